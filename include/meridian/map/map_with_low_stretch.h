// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MAP_MAP_WITH_LOW_STRETCH_H
#define MERIDIAN_MAP_MAP_WITH_LOW_STRETCH_H

#include <meridian/base/vectors.h>
#include <meridian/field/Sparse_solver.h>
#include <meridian/surface/Triangle_surface.h>

#include <vector>

namespace meridian {
/*!
 * \ingroup PkgMeridianParameterization
 *
 * maps a disc into a convex polygon with low stretch, so that no part of the surface becomes small.
 *
 * It begins with positive weights. The weight of every edge is then divided by the geometric mean of the L2 stretch at
 * its ends, a symmetric form of the step of Yoshizawa, Belyaev and Seidel (2004), and the disc is mapped again. A step
 * that raises the stretch, or turns a face over, is taken back and its exponent halved. If no map without flipped faces
 * is found so, equal weights are tried. Stretch is the root of the mean square of all faces by area; faces of more than
 * 1000 count as 1000.
 *
 * \param disc the surface
 * \param loop its boundary, as halfedges
 * \param border the image of each halfedge's source, on a convex polygon, counterclockwise
 * \param steps how often weights are changed at most, once no face is flipped; until then up to 8 times
 * \param make_solver makes the solver of the systems
 *
 * \returns the image of each vertex: of the maps without flipped faces that of the least stretch; if there is none,
 *          that with the fewest
 * \pre no inner edge joins two points of one side of the polygon
 * \throws Solver_error if neither the positive nor the equal weights give a system that can be solved
 * \par Complexity
 * One factorization a step.
 */
std::vector<Plane_point> map_with_low_stretch(const Triangle_surface& disc, const std::vector<Index>& loop,
                                              const std::vector<Plane_point>& border, int steps = 20,
                                              Make_solver make_solver = make_symmetric_solver);

} // namespace meridian

#endif // MERIDIAN_MAP_MAP_WITH_LOW_STRETCH_H
