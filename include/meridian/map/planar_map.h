// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MAP_PLANAR_MAP_H
#define MERIDIAN_MAP_PLANAR_MAP_H

#include <meridian/base/vectors.h>

#include <array>
#include <vector>

namespace meridian {

/// \ingroup PkgMeridianParameterization
/// \param a, b, c the corners of a triangle
/// \returns the sign of its area: exact
int orientation_of(const Plane_point& a, const Plane_point& b, const Plane_point& c);

/// \ingroup PkgMeridianParameterization
/// \returns the faces whose image is not turned counterclockwise: those turned over, and those without area. Decided
///          exactly.
/// \param triangles the vertices of each face
/// \param at the image of each vertex
std::vector<Index> find_flipped_faces(const std::vector<std::array<Index, 3>>& triangles,
                                      const std::vector<Plane_point>& at);

/// \ingroup PkgMeridianParameterization
/// \param triangles the vertices of each face
/// \param at the image of each vertex
/// \returns the area of the image
double area_of(const std::vector<std::array<Index, 3>>& triangles, const std::vector<Plane_point>& at);

/// \ingroup PkgMeridianParameterization
/// \param loop the vertices of a polygon, in order
/// \param at the image of each vertex
/// \returns whether it does not meet itself: exact
bool is_simple(const std::vector<Index>& loop, const std::vector<Plane_point>& at);

/// \ingroup PkgMeridianParameterization
/// \param loop the vertices of a polygon, in order
/// \param at the image of each vertex
/// \returns whether it is still simple when it is rounded to a grid of 2^36 places or more along it: then there is room
///          between its sides, and it stays simple when it is moved, turned and scaled with rounding
bool is_roomy(const std::vector<Index>& loop, const std::vector<Plane_point>& at);

/// \ingroup PkgMeridianParameterization
/// \param points some points
/// \returns the sides of the rectangle of least area around them, the longer first
/// \par Complexity
/// \f$ O(n \log n) \f$
std::array<double, 2> sides_of_smallest_rectangle(const std::vector<Plane_point>& points);

/// \ingroup PkgMeridianParameterization
/// \param points some points
/// \returns the direction of the longer side of the rectangle of least area around them, of length 1
///          (CGAL's rotating calipers; \cite toussaint1983)
/// \par Complexity
/// \f$ O(n \log n) \f$
Plane_point longer_side_of_smallest_rectangle(const std::vector<Plane_point>& points);

} // namespace meridian

#endif // MERIDIAN_MAP_PLANAR_MAP_H
