// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FIELD_GEODESIC_DISTANCE_H
#define MERIDIAN_FIELD_GEODESIC_DISTANCE_H

#include <meridian/base/vectors.h>
#include <meridian/field/Sparse_solver.h>
#include <meridian/field/intrinsic_delaunay.h>
#include <meridian/surface/Triangle_surface.h>

#include <vector>

namespace meridian {
namespace internal {

// Distances along the edges of an intrinsic triangulation (Dijkstra 1959).
std::vector<double> edge_distances(const Intrinsic_triangulation& t, Index vertices, const std::vector<Index>& sources);

} // namespace internal

/*!
 * \ingroup PkgMeridianOrder
 *
 * \returns for each vertex its distance within the surface from the nearest of some vertices, by the heat method
 *          (\cite crane2013) on the intrinsic Delaunay triangulation (\cite sharp2020)
 *
 * Heat flows from the sources for a short while, its gradient is brought to unit length, and the function whose
 * gradient comes nearest to that is solved for. The time is the square of the mean length of edges; on surfaces so long
 * that heat would fall below the range of double at the far end, it is as much longer as is needed. Going along the
 * boundary is not free here: the distance is that of the surface, not of its closed model.
 *
 * \param s the surface
 * \param sources vertices
 * \param make_solver makes the solver of both systems
 * \pre the surface is connected
 * \throws Invalid_input_error if there is no source
 * \throws Solver_error if a system cannot be factorized or a distance is not finite
 *
 * \par Complexity
 * Two factorizations, \f$ O(n^{1.5}) \f$ for a surface mesh. The error is of first order in the length of edges.
 */
std::vector<double> geodesic_distance(const Triangle_surface& s, const std::vector<Index>& sources,
                                      Make_solver make_solver = make_symmetric_solver);

} // namespace meridian

#endif // MERIDIAN_FIELD_GEODESIC_DISTANCE_H
