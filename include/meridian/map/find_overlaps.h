// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MAP_FIND_OVERLAPS_H
#define MERIDIAN_MAP_FIND_OVERLAPS_H

#include <meridian/base/vectors.h>
#include <meridian/surface/Triangle_surface.h>

#include <array>
#include <vector>

namespace meridian {

/// \ingroup PkgMeridianParameterization
/// where an image in the plane overlaps itself, by samples.
struct Overlaps
{
  std::vector<std::array<Index, 2>> faces; ///< pairs of faces that cover one sample, one a sample
  double part = 0;                         ///< of the image's area
};

/*!
 * \ingroup PkgMeridianParameterization
 *
 * \returns where an image overlaps itself, at the points of a square grid: an estimate, which passes over what is
 *          smaller. Faces that are turned over cover nothing.
 * \param disc the surface
 * \param at the image of each vertex
 * \param samples about how many points of the grid the image's area holds
 * \par Complexity
 * \f$ O(n + k \log k) \f$ for `k` samples
 */
Overlaps find_overlaps(const Triangle_surface& disc, const std::vector<Plane_point>& at, double samples = 16384);

} // namespace meridian

#endif // MERIDIAN_MAP_FIND_OVERLAPS_H
