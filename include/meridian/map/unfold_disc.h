// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MAP_UNFOLD_DISC_H
#define MERIDIAN_MAP_UNFOLD_DISC_H

#include <meridian/base/vectors.h>
#include <meridian/field/Sparse_solver.h>
#include <meridian/surface/Triangle_surface.h>

#include <vector>

namespace meridian {

/*!
 * \ingroup PkgMeridianParameterization
 *
 * unfolds a disc into the plane as if it could pass through itself.
 *
 * Faces are turned by a trivial connection (\cite crane2010): across an edge as the faces unfold, and further by
 * \f$ w (u_i - u_j) \f$, where \f$ u \f$ is the potential of the angle defects, 0 on the border. The points are those
 * whose edges come nearest to the turned ones in least squares (\cite liu2008); then turns and points are fitted to
 * each other a few times. The faces keep their sizes as well as they can, but some may be turned over, and the image
 * may overlap itself: where it does, no map without overlaps stretches as little.
 *
 * \param disc the surface
 * \param solver the solver of both systems
 *
 * \returns the image of each vertex, in the unit of the surface
 * \pre `disc` is a disc
 * \throws Solver_error if a system cannot be solved
 * \par Complexity
 * Two factorizations of the disc's Laplacian.
 */
std::vector<Plane_point> unfold_disc(const Triangle_surface& disc, Make_solver solver = make_symmetric_solver);

} // namespace meridian

#endif // MERIDIAN_MAP_UNFOLD_DISC_H
