// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MAP_PACK_CHARTS_H
#define MERIDIAN_MAP_PACK_CHARTS_H

#include <meridian/base/vectors.h>

#include <array>
#include <vector>

namespace meridian {

/// \ingroup PkgMeridianParameterization
/// a map of one component, to be packed with others.
struct Chart
{
  const std::vector<std::array<Index, 3>>* triangles; ///< its faces, which are the caller's
  std::vector<Plane_point> at;                        ///< the image of each vertex
  double area;                                        ///< of the component, in one unit for all charts
};

/*!
 * \ingroup PkgMeridianParameterization
 *
 * puts charts side by side into the unit square, all at one scale of area, so that their bounding rectangles are
 * disjoint.
 *
 * Each chart is turned until its bounding rectangle is smallest, unless rounding would then turn a face over; the
 * rectangles stand on shelves, the highest first.
 *
 * \param charts the charts; their points are moved
 * \par Complexity
 * \f$ O(n \log n) \f$
 */
void pack_charts(std::vector<Chart>& charts);

} // namespace meridian

#endif // MERIDIAN_MAP_PACK_CHARTS_H
