// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MAP_PARAMETERIZATION_H
#define MERIDIAN_MAP_PARAMETERIZATION_H

#include <meridian/base/vectors.h>
#include <meridian/field/Sparse_solver.h>
#include <meridian/map/Map_method.h>
#include <meridian/map/distortion.h>
#include <meridian/surface/Triangle_surface.h>

#include <functional>
#include <string>
#include <vector>

namespace meridian {

/// \ingroup PkgMeridianParameterization
/// what one may choose about a map.
struct Map_options
{
  Map_method method = Map_method::SYMMETRIC_DIRICHLET;
  Map_border border = Map_border::FREE;
  std::vector<Index> loop = {}; ///< the border as halfedges, counterclockwise, and
  /// where the source of each goes, on a convex polygon, in place of a circle or square; or both empty. For
  /// `SYMMETRIC_DIRICHLET`, `POSITIVE` and `STRETCH`
  std::vector<Plane_point> polygon = {};
  std::function<void(double)> progress = {}; ///< receives the part done; may throw to cancel
  /// for `SYMMETRIC_DIRICHLET`, `POSITIVE` and `STRETCH`
  Make_solver make_solver = make_symmetric_solver;
};

/// \ingroup PkgMeridianParameterization
/// a map that was tried.
struct Map_attempt
{
  Map_method method;
  Map_border border;
  Index flipped;      ///< faces turned over or without area; -1 if there was no map
  std::string reason; ///< why there was none
};

/// \ingroup PkgMeridianParameterization
/// a map of a disc into the plane.
struct Parameterization
{
  /// the image of each vertex, in the unit square, as a multiple of 2^-50: what is counted of it holds wherever it is
  /// put
  std::vector<Plane_point> at;
  Map_method method = Map_method::SYMMETRIC_DIRICHLET; ///< that was used
  Map_border border = Map_border::FREE;
  /// the last is the one used, unless all had flipped faces; then that with the fewest
  std::vector<Map_attempt> attempts;
  std::vector<Index> flipped; ///< the faces turned over or without area, exactly
  bool is_one_to_one = false; ///< whether no face is flipped and the border does not meet itself, exactly
  std::vector<Face_distortion> faces;
  Distortion distortion;
};

/*!
 * \ingroup PkgMeridianParameterization
 *
 * maps a disc into the plane.
 *
 * If the method asked for leaves flipped faces, the next safer one is tried: `SYMMETRIC_DIRICHLET` after another with a
 * free border, then averages with positive weights, which flip nothing in exact arithmetic, with uniform ones, and with
 * weights changed until stretch is low; after a square, whose sides may hold all corners of a face, a circle, unless a
 * polygon is given.
 *
 * \param disc the surface
 * \param options see there
 *
 * \returns the first map without flipped faces, or, if there is none, that with the fewest
 * \pre `disc` is a disc
 * \par Complexity
 * One factorization for linear methods, two for each step of `ARAP`, and one of twice the size for each of
 * `SYMMETRIC_DIRICHLET`.
 */
Parameterization parameterize_disc(const Triangle_surface& disc, const Map_options& options = Map_options());

} // namespace meridian

#endif // MERIDIAN_MAP_PARAMETERIZATION_H
