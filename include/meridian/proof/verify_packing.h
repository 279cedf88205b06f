// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_PROOF_VERIFY_PACKING_H
#define MERIDIAN_PROOF_VERIFY_PACKING_H

#include <meridian/base/Verification.h>
#include <meridian/base/vectors.h>
#include <meridian/proof/Padding.h>

#include <array>
#include <cstdint>
#include <vector>

namespace meridian {

/*!
 * \ingroup PkgMeridianVerification
 *
 * recounts charts that were packed, whatever they are themselves: that each face lies in one tile, that no two charts
 * of a tile are nearer than the padding, compared exactly, and that none lies inside another. Faces that share a vertex
 * are of one chart.
 *
 * \param faces the places in `texture` of the corners of each face
 * \param texture the points
 * \param padding how far apart charts are, at least; more than 0
 * \param tiles how many there may be; see `verify_unwrapping()`
 * \param before where the points were before they were packed, if it shall be recounted, too, that each face has the
 *   same exact sign of its area still: none was turned over or lost its area
 * \returns the failures
 * \par Complexity
 * \f$ O(b \log^2 b + k) \f$ for `b` sides on borders, of which `k` pairs are near (\cite zomorodian2002)
 */
Verification verify_packing(const std::vector<std::array<std::int32_t, 3>>& faces,
                            const std::vector<Plane_point>& texture, const Padding& padding, int tiles = 1,
                            const std::vector<Plane_point>& before = {});

/*!
 * \ingroup PkgMeridianVerification
 *
 * recounts where charts are near themselves, so that texels of one side of a slit bleed into the other: sides of a
 * border that face each other across what is outside, nearer than the padding, compared exactly, while the way from one
 * to the other along the border is longer than eight times that. At the end of a slit they must be near.
 *
 * \param faces the places in `texture` of the corners of each face; charts are discs
 * \param texture the points
 * \param padding how far apart sides should be, at least
 * \returns the faces at such sides, ascending
 * \par Complexity
 * \f$ O(b \log^2 b + k) \f$ for `b` sides on borders, of which `k` pairs are near (\cite zomorodian2002)
 */
std::vector<std::int32_t> find_near_themselves(const std::vector<std::array<std::int32_t, 3>>& faces,
                                               const std::vector<Plane_point>& texture, const Padding& padding);

} // namespace meridian

#endif // MERIDIAN_PROOF_VERIFY_PACKING_H
