// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_UNWRAP_INTERNAL_SQUARE_CORNERS_H
#define MERIDIAN_UNWRAP_INTERNAL_SQUARE_CORNERS_H

#include <meridian/base/vectors.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/unwrap/internal/border_strands.h>

#include <map>
#include <utility>
#include <vector>

namespace meridian {
namespace internal {

// The angle of a surface at a vertex.
double angle_at(const Triangle_surface& s, Index v);

// How badly a corner of the square lies inside an edge: worse than at any vertex of a straight border.
constexpr double cost_inside_edge = 3.25;

// Lets a boundary without seams begin where it has the narrowest corners at its quarters.
void turn_whole_border(const Triangle_surface& disc, Border_strands& border);

// \returns the grid point of the border that becomes the first corner: that for which the disc is narrowest at the four
int choose_corners(const Triangle_surface& disc, Border_strands& border, int size);

// The edges of a surface that are divided, with their new vertices from the lower end on.
using Divided_edges = std::map<std::pair<Index, Index>, std::vector<Index>>;

// Gives every strand a vertex at each corner that lies inside it: moves one there, or divides an edge.
Divided_edges divide_at_corners(const Triangle_surface& root, Refined_surface& s, Border_strands& border,
                                int first_corner, int size);

// Lets a curve pass the new vertices of the edges that it runs along.
void insert_into_curve(const Divided_edges& divided, std::vector<Index>& curve, bool is_closed);

// The point of the border of the unit square at `place` steps from the corner (0, 0), of 4 (size - 1). On a side one
// coordinate is exactly 0 or 1.
Plane_point point_on_square(double place, int size);

// A bit for each side of the unit square that a point lies on.
inline unsigned sides_of(const Plane_point& p)
{
  return (p[0] == 0 ? 1u : 0u) | (p[0] == 1 ? 2u : 0u) | (p[1] == 0 ? 4u : 0u) | (p[1] == 1 ? 8u : 0u);
}

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_UNWRAP_INTERNAL_SQUARE_CORNERS_H
