// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CURVES_FIND_CROSSING_LOOP_H
#define MERIDIAN_CURVES_FIND_CROSSING_LOOP_H

#include <meridian/base/vectors.h>
#include <meridian/curves/Gap_records.h>
#include <meridian/curves/Normal_curves.h>
#include <meridian/curves/chords.h>
#include <meridian/surface/Triangle_surface.h>

#include <cstdint>
#include <limits>
#include <map>
#include <vector>

namespace meridian {
namespace internal {

// A way through gaps, each with the face by which the next one is reached.
struct Gap_walk
{
  struct Stop
  {
    Gap gap;
    Index face_after;
  };
  std::vector<Stop> stops;
};

struct Crossing_loop
{
  std::vector<Crossing> steps;
  double length;
};

// Searches for loops; keeps its memory from one search to the next.
class Crossing_loop_search
{
public:
  explicit Crossing_loop_search(const Normal_curves& curves)
    : m_curves(curves), m_surface(curves.surface()), m_reached(curves)
  {}

  explicit Crossing_loop_search(Normal_curves&& curves) = delete;

  // The shortest closed walk that crosses curve `m` once, from right to left, and no other curve: from the left side of
  // the curve through gaps to its right side, and along that side back to where it began. If the curve does not
  // separate the surface cut along the others there is one.
  Crossing_loop find(Index m);

private:
  struct Reached
  {
    double distance = std::numeric_limits<double>::infinity();
    Gap from{-1, -1};
    Index face = -1;
    std::uint32_t run = 0; // the search that this belongs to
    bool is_done = false;
  };

  Point point(const Gap& g) const { return m_surface.point_on(g.edge, middle_of(m_curves, g)); }

  // Dijkstra's algorithm on gaps; two are neighbours if they lie on one region of a face.
  Gap search(const std::map<Gap, Index>& source, const std::map<Gap, Index>& target);

  Gap_walk walk_to(const Gap& end);

  // Goes back from beside crossing `last` to beside crossing `first` along the right side of their curve, the shorter
  // way round.
  Crossing_loop close(const Gap& end, Index first, Index last);

  const Normal_curves& m_curves;
  const Triangle_surface& m_surface;
  Gap_records<Reached> m_reached;
};

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_CURVES_FIND_CROSSING_LOOP_H
