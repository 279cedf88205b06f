// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_HANDLES_INTERNAL_FLOW_LONGITUDES_H
#define MERIDIAN_HANDLES_INTERNAL_FLOW_LONGITUDES_H

#include <meridian/base/vectors.h>
#include <meridian/curves/Normal_curves.h>
#include <meridian/curves/find_crossing_loop.h>
#include <meridian/curves/morse_complex.h>
#include <meridian/field/Ordered_surface.h>
#include <meridian/field/Sparse_solver.h>
#include <meridian/field/Two_point_fields.h>
#include <meridian/field/critical_points.h>
#include <meridian/handles/Generators.h>
#include <meridian/handles/internal/flow_loops.h>
#include <meridian/surface/Triangle_surface.h>

#include <memory>
#include <utility>
#include <vector>

namespace meridian {
namespace internal {

// Looks for longitudes among flow lines (Patane 2007, section 4).
class Flow_longitudes
{
public:
  // `saddles`: of each pair's meridian, in `m.surface`. `longer`: than the arc a loop may be, by this factor.
  Flow_longitudes(const Triangle_surface& root, const Ordered_surface& m, const Morse_complex& complex,
                  Normal_curves& curves, const std::vector<std::pair<Index, Index>>& saddles, double longer,
                  const Solvers& solvers);

  // Adds a longitude of flow lines for pair `i`, if there is one that is not much longer than the arc found for it.
  bool add(Index i, const Crossing_loop& arc, Generator_pair& pair);

  static constexpr int few = 8; // handles for which fields are solved on the whole surface

private:
  static constexpr double reach = 0.3;    // of a patch, in lengths of the arc
  static constexpr std::size_t share = 4; // of all patches together, in faces of the surface, at most

  Index farthest_on(const Crossing_loop& arc, Index from) const;
  Index nearest_critical(Index saddle) const;
  bool add_on_patch(Index i, const Crossing_loop& arc, Index low, Index high, Generator_pair& pair);
  bool take_all(Index i, const Ordered_surface& h, const Surface_patch& patch, const Crossing_loop& arc,
                Generator_pair& pair);
  bool take(Index i, const std::vector<Flow_loop>& loops, const Ordered_surface& h, const Surface_patch& patch,
            const Crossing_loop& arc, Generator_pair& pair);

  const Triangle_surface& m_root;
  const Ordered_surface& m_ordered;
  Normal_curves& m_curves;
  const std::vector<std::pair<Index, Index>>& m_saddles;
  const Morse_complex& m_complex;
  double m_longer; // than the arc a loop may be, by this factor
  Solvers m_solvers;
  std::vector<Critical_point> m_critical;
  std::unique_ptr<Two_point_fields> m_fields; // on the whole surface
  Surface_patch m_whole;
};

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_HANDLES_INTERNAL_FLOW_LONGITUDES_H
