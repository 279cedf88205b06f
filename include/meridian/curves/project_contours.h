// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CURVES_PROJECT_CONTOURS_H
#define MERIDIAN_CURVES_PROJECT_CONTOURS_H

#include <meridian/curves/contours.h>
#include <meridian/curves/place_crossings.h>
#include <meridian/field/Ordered_surface.h>
#include <meridian/surface/Surface_curve.h>
#include <meridian/surface/Triangle_surface.h>

#include <vector>

namespace meridian {

namespace internal {

// The crossings of contours with the edges of the root, in an order on every edge.
std::vector<std::vector<Piece_crossing>> project_crossings(const Triangle_surface& root, const Ordered_surface& m,
                                                           const std::vector<const Contour*>& contours);

} // namespace internal

/*!
 * \ingroup PkgMeridianContours
 *
 * \returns disjoint contours as curves on the surface that was ordered to begin with
 *
 * Only crossings with edges of the root are kept. Where a contour then turns back across the edge it came by, it is
 * pulled over; what it passed there was a vertex of the finer model only. On each edge the crossings keep the order
 * that the levels give them, and a small distance from each other and from the ends. A contour that passes close by
 * a vertex goes through it, unless the vertex lies on the boundary or another curve is in the way.
 *
 * \param root the surface that `m.surface` refines
 * \param m the ordered surface
 * \param contours contours of `m`, all different
 *
 * \post the curves are closed, simple and disjoint, and homotopic to the contours on the root
 * \throws Internal_error if a contour can be pulled to a point
 * \par Complexity
 * \f$ O(k \log k) \f$ for `k` crossings
 */
std::vector<Surface_curve> project_contours(const Triangle_surface& root, const Ordered_surface& m,
                                            const std::vector<const Contour*>& contours);

} // namespace meridian

#endif // MERIDIAN_CURVES_PROJECT_CONTOURS_H
