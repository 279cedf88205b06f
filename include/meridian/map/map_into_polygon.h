// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MAP_MAP_INTO_POLYGON_H
#define MERIDIAN_MAP_MAP_INTO_POLYGON_H

#include <meridian/base/vectors.h>
#include <meridian/field/Sparse_solver.h>
#include <meridian/surface/Triangle_surface.h>

#include <vector>

namespace meridian {

/// \ingroup PkgMeridianParameterization
/// \param s the surface
/// \param loop a boundary loop, as halfedges
/// \returns for each halfedge where along the loop it begins, from 0 to 1: half by length and half
///          by number, so that edges without length have a place too
std::vector<double> places_along(const Triangle_surface& s, const std::vector<Index>& loop);

/// \ingroup PkgMeridianParameterization
/// \param places along the circle, from 0 to 1
/// \returns the points of the unit circle there
std::vector<Plane_point> place_on_circle(const std::vector<double>& places);

/*!
 * \ingroup PkgMeridianParameterization
 *
 * maps a disc into a convex polygon so that every inner vertex is the average of its neighbours (\cite tutte1963;
 * \cite floater1997).
 *
 * With positive weights and no chord that joins two points of one side of the polygon, no face is turned over in exact
 * arithmetic.
 *
 * \param disc the surface
 * \param weights one for each halfedge, equal on twins, positive
 * \param loop the boundary, as halfedges
 * \param border the image of each halfedge's source
 * \param make_solver makes the solver of the systems
 *
 * \returns the image of each vertex
 * \throws Solver_error if the system cannot be factorized
 * \par Complexity
 * One factorization.
 */
std::vector<Plane_point> map_into_polygon(const Triangle_surface& disc, const std::vector<double>& weights,
                                          const std::vector<Index>& loop, const std::vector<Plane_point>& border,
                                          Make_solver make_solver = make_symmetric_solver);

} // namespace meridian

#endif // MERIDIAN_MAP_MAP_INTO_POLYGON_H
