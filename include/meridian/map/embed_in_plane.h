// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MAP_EMBED_IN_PLANE_H
#define MERIDIAN_MAP_EMBED_IN_PLANE_H

#include <meridian/base/vectors.h>
#include <meridian/field/Sparse_solver.h>
#include <meridian/surface/Triangle_surface.h>

#include <vector>

namespace meridian {

/// \ingroup PkgMeridianSurface
/// a planar embedding of a surface of genus 0.
struct Planar_embedding
{
  std::vector<Plane_point> points; ///< of each vertex
  bool is_valid = false;           ///< whether every face, those that fill holes too, is turned counterclockwise: exact
};

/*!
 * \ingroup PkgMeridianSurface
 *
 * embeds a connected bordered surface of genus 0 in the plane (\cite tutte1963, with symmetric positive weights).
 *
 * The longest boundary loop becomes a circle; the others are filled with a fan around a new vertex, so that the whole
 * is a disc. In exact arithmetic no face can be turned over; in double precision faces at the end of long tubes
 * underflow, which the exact orientation predicate tells.
 *
 * \param s the surface
 * \param make_solver makes the solver of the systems
 * \returns the embedding
 * \pre `s` has genus 0 and at least one boundary loop
 * \throws Solver_error if the system cannot be factorized
 * \par Complexity
 * One factorization.
 */
Planar_embedding embed_in_plane(const Triangle_surface& s, Make_solver make_solver = make_symmetric_solver);

} // namespace meridian

#endif // MERIDIAN_MAP_EMBED_IN_PLANE_H
