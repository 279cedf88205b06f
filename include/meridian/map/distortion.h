// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MAP_DISTORTION_H
#define MERIDIAN_MAP_DISTORTION_H

#include <meridian/base/vectors.h>

#include <array>
#include <vector>

namespace meridian {

/// \ingroup PkgMeridianParameterization
/// how a map between a face and the plane distorts, when the whole image is scaled to the area of the surface. With
/// \f$ \Gamma \ge \gamma \f$, the singular values of the map from the plane to the surface (\cite sander2001):
struct Face_distortion
{
  double stretch_l2 = 1;   ///< \f$ \sqrt{(\Gamma^2 + \gamma^2) / 2} \f$
  double stretch_linf = 1; ///< \f$ \Gamma \f$
  double conformal = 1;    ///< \f$ \Gamma / \gamma \f$; 1 if angles are kept
  double areal = 1;        ///< \f$ \Gamma \gamma \f$; 1 if area is kept, more where the image is too small
};

/// \ingroup PkgMeridianParameterization
/// the distortion of a whole map. No value depends on the scale of surface or image.
struct Distortion
{
  double stretch_l2 = 1;   ///< root of the mean square, by area on the surface; 1 for an isometry
  double stretch_linf = 1; ///< the largest of all faces
  /// mean difference of a corner's angles on the surface and in the plane, in radians, by area
  double angle = 0;
  double area = 0;      ///< sum of |share of the surface's area - share of the image's area|, 0 to 2
  double conformal = 1; ///< mean of \f$ \Gamma / \gamma \f$, by area
  double areal = 1;     ///< mean of the larger of \f$ \Gamma \gamma \f$ and its inverse, by area
};

/*!
 * \ingroup PkgMeridianParameterization
 *
 * \returns the distortion of each face; that of faces without area in the plane is infinite
 * \param points, triangles the surface
 * \param at the image of each vertex
 * \par Complexity
 * Linear.
 */
std::vector<Face_distortion> measure_faces(const std::vector<Point>& points,
                                           const std::vector<std::array<Index, 3>>& triangles,
                                           const std::vector<Plane_point>& at);

/*!
 * \ingroup PkgMeridianParameterization
 *
 * \returns the distortion of a map; that of an isometry if the surface has no area. Faces without area count nowhere
 *          but in the largest stretch.
 * \param points, triangles the surface
 * \param at the image of each vertex
 * \param faces what `measure_faces()` found
 * \par Complexity
 * Linear.
 */
Distortion measure_distortion(const std::vector<Point>& points, const std::vector<std::array<Index, 3>>& triangles,
                              const std::vector<Plane_point>& at, const std::vector<Face_distortion>& faces);

} // namespace meridian

#endif // MERIDIAN_MAP_DISTORTION_H
