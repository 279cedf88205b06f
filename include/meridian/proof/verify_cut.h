// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_PROOF_VERIFY_CUT_H
#define MERIDIAN_PROOF_VERIFY_CUT_H

#include <meridian/base/Polygon_soup.h>
#include <meridian/base/Result_mesh.h>
#include <meridian/base/Verification.h>
#include <meridian/proof/internal/Cut_verifier.h>

namespace meridian {

/*!
 * \ingroup PkgMeridianVerification
 *
 * recounts a cut from the input and the result alone.
 *
 * It checks that
 * - every vertex has the position of its origin, bit for bit, and copies are copies of the right vertices;
 * - the faces on each triangle of the input are a disc that divides it, turned the same way throughout;
 * - edges are shared or listed as seams exactly where the input is connected, and nowhere else;
 * - glueing the seams gives the genus and the boundary loops of the input;
 * - every component of the input became one disc: connected, Euler characteristic 1, one boundary loop, no pinched
 * vertex.
 *
 * All of it is counted by sorting sides and by union-find of corners. Nothing is shared with the code that
 * cuts but the plain arrays of input and result, the fan of a polygon and the formula of a position.
 *
 * \param input the input as it was read
 * \param result the result as it was read
 *
 * \returns the counts and the failures
 * \par Complexity
 * \f$ O(n \log d) \f$ for the largest degree \f$ d \f$
 */
inline Verification verify_cut(const Polygon_soup& input, const Result_mesh& result)
{
  return verification::Cut_verifier(input, result).run();
}

} // namespace meridian

#endif // MERIDIAN_PROOF_VERIFY_CUT_H
