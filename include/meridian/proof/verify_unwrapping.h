// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_PROOF_VERIFY_UNWRAPPING_H
#define MERIDIAN_PROOF_VERIFY_UNWRAPPING_H

#include <meridian/base/Polygon_soup.h>
#include <meridian/base/Result_mesh.h>
#include <meridian/base/Verification.h>
#include <meridian/proof/Padding.h>

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
 * - all coordinates lie in the unit square; or, with several tiles, those of each face in one of them: tile `t` is the
 *   square moved by `t % 10` to the right and `t / 10` up;
 * - no two sides on borders of charts meet, other than at a vertex that they share, and no chart lies inside another:
 *   by exact signs. With the signs of the faces, the layout is then one-to-one;
 * - if padding is asked for, no two charts of one tile are nearer, compared exactly.
 *
 * \param input the input as it was read
 * \param result the result as it was read, a vertex for each texture coordinate
 * \param texture the coordinates of each vertex of `result`
 * \param padding how far apart charts are, at least
 * \param tiles how many there may be
 *
 * \returns the counts and the failures
 * \par Complexity
 * \f$ O(n \log d) \f$ for the largest degree \f$ d \f$, and \f$ O(b \log^2 b + k) \f$ for `b` sides on borders, of
 * which `k` pairs are near (\cite zomorodian2002)
 */
Verification verify_unwrapping(const Polygon_soup& input, const Result_mesh& result,
                               const std::vector<Plane_point>& texture, const Padding& padding = Padding(),
                               int tiles = 1);

} // namespace meridian

#endif // MERIDIAN_PROOF_VERIFY_UNWRAPPING_H
