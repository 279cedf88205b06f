// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_PROOF_VERIFY_UNWRAPPING_H
#define MERIDIAN_PROOF_VERIFY_UNWRAPPING_H

#include <meridian/base/Polygon_soup.h>
#include <meridian/base/Result_mesh.h>
#include <meridian/base/Verification.h>

#include <array>
#include <vector>

namespace meridian {

/*!
 * \ingroup PkgMeridianVerification
 *
 * recounts texture coordinates from the input and the result alone.
 *
 * What `verify_cut()` checks of the mesh whose vertices are the texture's; further, that
 * - no face is turned over or without area in the plane: by the exact sign of its area;
 * - all coordinates lie in the unit square;
 * - the bounding rectangles of different components do not overlap.
 *
 * \param input the input as it was read
 * \param result the result as it was read, a vertex for each texture coordinate
 * \param texture the coordinates of each vertex of `result`
 *
 * \returns the counts and the failures
 * \par Complexity
 * \f$ O(n \log d) \f$ for the largest degree \f$ d \f$, and the square of the number of components
 */
Verification verify_unwrapping(const Polygon_soup& input, const Result_mesh& result,
                               const std::vector<Plane_point>& texture);

} // namespace meridian

#endif // MERIDIAN_PROOF_VERIFY_UNWRAPPING_H
