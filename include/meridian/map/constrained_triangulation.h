// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MAP_CONSTRAINED_TRIANGULATION_H
#define MERIDIAN_MAP_CONSTRAINED_TRIANGULATION_H

#include <meridian/base/vectors.h>

#include <array>
#include <vector>

namespace meridian {
namespace internal {

// The triangles between a simple polygon, whose corners are `loop`, and a box around it. The corners of the box are
// appended to `at`.
std::vector<std::array<Index, 3>> triangulate_outside(const std::vector<Index>& loop, std::vector<Plane_point>& at);

// The edges of the constrained Delaunay triangulation of some vertices, with the sides of closed polygons of them among
// them, in no order that means anything. Empty if two vertices coincide.
std::vector<std::array<Index, 2>> constrained_delaunay_edges(const std::vector<Index>& vertices,
                                                             const std::vector<std::vector<Index>>& polygons,
                                                             const std::vector<Plane_point>& at);

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_MAP_CONSTRAINED_TRIANGULATION_H
