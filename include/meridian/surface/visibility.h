// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_SURFACE_VISIBILITY_H
#define MERIDIAN_SURFACE_VISIBILITY_H

#include <meridian/base/vectors.h>
#include <meridian/surface/Triangle_surface.h>

#include <vector>

namespace meridian {

/*!
 * \ingroup PkgMeridianMeridians
 *
 * \returns for each vertex 1 if it is seen from far out in a direction, and 0 if it faces away or another face is in
 *          front of it. `preference::low_weight()` keeps meridians out of sight with it.
 * \param s the surface
 * \param direction towards the eye, of any length but 0
 * \throws Invalid_input_error if the direction is 0 or not finite
 * \par Complexity
 * \f$ O(n \log n) \f$ as a rule, with a tree of boxes (CGAL's AABB tree)
 */
std::vector<double> visibility(const Triangle_surface& s, const Point& direction);

} // namespace meridian

#endif // MERIDIAN_SURFACE_VISIBILITY_H
