// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_PROOF_VERIFY_GENERATORS_H
#define MERIDIAN_PROOF_VERIFY_GENERATORS_H

#include <meridian/base/Polygon_soup.h>
#include <meridian/base/Result_mesh.h>
#include <meridian/base/Verification.h>
#include <meridian/proof/internal/Generator_verifier.h>

#include <vector>

namespace meridian {

/*!
 * \ingroup PkgMeridianVerification
 *
 * recounts generators from the input and the result alone.
 *
 * It checks that
 * - the result is the input, divided, as `verify_cut()` does, with nothing taken apart;
 * - there are two curves for each handle, and every boundary loop is listed;
 * - every curve is closed and made of edges, and passes through no vertex twice;
 * - `meridian_i` and `longitude_i` share one vertex and cross there, from right to left, and share none with other
 * curves; so the intersection matrix, counted from the order of edges around shared vertices, is the standard
 * symplectic one;
 * - on a component with boundary, and for curves named `loop_i`, which may cross, the curves and all boundary loops but
 * one are a basis of the first homology: their classes, by the cocycles of a spanning tree and cotree, have determinant
 * 1 or -1.
 *
 * \param input the input as it was read
 * \param result the refined mesh as it was read
 * \param curves closed curves named `meridian_0`, `longitude_0`, ..., or `loop_0`, ..., and `boundary_0`, ...
 *
 * \returns the counts and the failures
 * \par Complexity
 * \f$ O(n \log d) \f$ for the largest degree \f$ d \f$; where classes are counted, also the size of their matrix
 */
inline Generator_verification verify_generators(const Polygon_soup& input, const Result_mesh& result,
                                                const std::vector<Result_curve>& curves)
{
  return verification::Generator_verifier(input, result, curves).run();
}

} // namespace meridian

#endif // MERIDIAN_PROOF_VERIFY_GENERATORS_H
