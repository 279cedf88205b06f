// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_JOIN_GENERATORS_H
#define MERIDIAN_CUT_JOIN_GENERATORS_H

#include <meridian/base/names.h>
#include <meridian/base/vectors.h>
#include <meridian/curves/morse_complex.h>
#include <meridian/cut/link_boundaries.h>
#include <meridian/field/Ordered_surface.h>

#include <array>
#include <utility>
#include <vector>

namespace meridian {

/// \ingroup PkgMeridianCut
/// how the generators of different handles are joined.
enum class Generator_join
{
  SURFACE, ///< by shortest paths on the surface
  COMPLEX, ///< along shortest paths in the quasi Morse-Smale complex between any of the critical points of the pairs
  SADDLES  ///< along its shortest paths between the saddles that gave the meridians
};

/// the names of `Generator_join`.
template <> struct Names<Generator_join>
{
  static constexpr std::array<Named_value<Generator_join>, 3> table{{
    {Generator_join::SURFACE, "surface", "by shortest paths on the surface"},
    {Generator_join::COMPLEX, "complex", "along the quasi Morse-Smale complex"},
    {Generator_join::SADDLES, "saddles", "along its paths between the meridians' saddles"},
  }};
};

namespace internal {

// The ways of a minimum spanning tree of the pairs, with the length of paths in the complex for weights (Patane 2007,
// figure 10).
std::vector<Link_guide> guide_joins(const Ordered_surface& m, const Morse_complex& complex,
                                    const std::vector<std::pair<Index, Index>>& saddles,
                                    const std::vector<Index>& shared, Generator_join join);

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_CUT_JOIN_GENERATORS_H
