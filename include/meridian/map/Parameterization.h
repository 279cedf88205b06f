// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MAP_PARAMETERIZATION_H
#define MERIDIAN_MAP_PARAMETERIZATION_H

#include <meridian/base/vectors.h>
#include <meridian/field/Sparse_solver.h>
#include <meridian/map/Map_method.h>
#include <meridian/map/distortion.h>
#include <meridian/surface/Triangle_surface.h>

#include <string>
#include <vector>

namespace meridian {

/// \ingroup PkgMeridianParameterization
/// what one may choose about a map.
struct Map_options
{
  Map_method method = Map_method::SYMMETRIC_DIRICHLET; ///< the first that is tried
  Map_border border = Map_border::FREE;                ///< where the border goes
  std::vector<Index> loop = {};                        ///< the border as halfedges, counterclockwise, and
  /// where the source of each goes, on a convex polygon, in place of a square; or both empty
  std::vector<Plane_point> polygon = {};
  /// for `SYMMETRIC_DIRICHLET`, `POSITIVE` and `STRETCH`
  Make_solver make_solver = make_symmetric_solver;
  /// a map of low distortion is good enough when a step gains no more than this part of its energy
  double least_gain = 1e-3;
};

/// \ingroup PkgMeridianParameterization
/// checks whether choices about a map go together.
/// \param options the choices
/// \throws Invalid_input_error if the method cannot put the border where it is asked to, or if loop and polygon do not
///   go together or would be ignored
void check(const Map_options& options);

/// \ingroup PkgMeridianParameterization
/// a map that was tried.
struct Map_attempt
{
  Map_method method;  ///< the method
  Map_border border;  ///< where it put the border
  Index flipped;      ///< faces turned over or without area; -1 if there was no map
  std::string reason; ///< why there was none, or what else was wrong with it
};

/// \ingroup PkgMeridianParameterization
/// a map of a disc into the plane.
struct Parameterization
{
  /// the image of each vertex, in the unit square, as a multiple of 2^-50: what is counted of it holds wherever it is
  /// put
  std::vector<Plane_point> at;
  Map_method method = Map_method::SYMMETRIC_DIRICHLET; ///< that was used
  Map_border border = Map_border::FREE;                ///< where the border is
  /// the last is the one used, unless none was one-to-one; then that with the fewest flipped faces
  std::vector<Map_attempt> attempts;
  std::vector<Index> flipped;         ///< the faces turned over or without area, exactly
  bool is_one_to_one = false;         ///< whether no face is flipped and the border does not meet itself, exactly
  std::vector<Face_distortion> faces; ///< how each face is distorted
  Distortion distortion;              ///< of all together
};

} // namespace meridian

#endif // MERIDIAN_MAP_PARAMETERIZATION_H
