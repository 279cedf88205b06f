// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_UNWRAP_MEASURE_ROUND_TRIP_H
#define MERIDIAN_UNWRAP_MEASURE_ROUND_TRIP_H

#include <meridian/surface/Triangle_surface.h>

namespace meridian {

/// \ingroup PkgMeridianParameterization
/// distances from samples of one surface to another.
struct Sampled_distance
{
  double largest = 0; ///< over samples and vertices
  double rms = 0;     ///< root of the mean square over the samples, which lie evenly by area
};

/// \ingroup PkgMeridianParameterization
/// how well a surface came back from an image.
struct Round_trip
{
  Sampled_distance there; ///< from the first surface to the second
  Sampled_distance back;  ///< from the second surface to the first
  double hausdorff = 0;   ///< the larger of both largest distances
  double rms = 0;         ///< the larger of both
  double diagonal = 0;    ///< of the bounding box of the first surface
  double psnr = 0;        ///< \f$ 20 \log_{10} (diagonal / rms) \f$, in decibels (\cite gu2002)
};

/*!
 * \ingroup PkgMeridianParameterization
 *
 * measures the distance between a surface and what an image made of it, both ways.
 *
 * Distances are those from sample points to the nearest point of the other surface: the Hausdorff distance is measured
 * from below. Samples are all vertices and, evenly by area, as many points as the larger surface has faces, but at
 * least `least_samples`.
 *
 * \param original, remeshed the surfaces
 * \param least_samples how many points inside faces are taken at least, on each surface
 *
 * \returns the distances; the PSNR is infinite if all of them are 0
 * \throws Invalid_input_error if a surface has no area
 * \par Complexity
 * \f$ O(n \log n) \f$ as a rule, with trees of boxes (CGAL's AABB tree)
 */
Round_trip measure_round_trip(const Triangle_surface& original, const Triangle_surface& remeshed,
                              std::size_t least_samples = 100000);

} // namespace meridian

#endif // MERIDIAN_UNWRAP_MEASURE_ROUND_TRIP_H
