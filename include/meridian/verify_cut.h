// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_VERIFY_CUT_H
#define MERIDIAN_VERIFY_CUT_H

#include <meridian/Result_mesh.h>

#include <string>

namespace meridian {

/// \ingroup PkgMeridianVerification
/// what was counted on one component of the input and of the result.
struct Component_count
{
  int vertices = 0, edges = 0, faces = 0; ///< of the input, polygons divided into triangles
  int euler_characteristic = 0, boundary_loops = 0, genus = 0;
  int discs = 0;                          ///< components of the result that it became
  int disc_euler_characteristic = 0, disc_boundary_loops = 0; ///< of those together
  int glued_euler_characteristic = 0, glued_boundary_loops = 0; ///< after the seams are glued
};

/// \ingroup PkgMeridianVerification
/// what was found; a failed check is a result, not an error.
struct Verification
{
  std::vector<Component_count> components;
  std::vector<std::string> failures; ///< each names a defect, counts it and gives the first elements
  explicit operator bool() const { return failures.empty(); }
};

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
 * - every component of the input became one disc: connected, Euler characteristic 1, one boundary loop, no pinched vertex.
 *
 * All of it is counted by sorting sides and by union-find of corners. Nothing is shared with the code that cuts.
 *
 * \param input the input as it was read
 * \param result the result as it was read
 *
 * \returns the counts and the failures
 * \par Complexity
 * \f$ O(n \log d) \f$ for the largest degree \f$ d \f$
 */
inline Verification verify_cut(const Polygon_soup& input, const Result_mesh& result);

} // namespace meridian

#include <meridian/internal/verify_cut.h>

#endif // MERIDIAN_VERIFY_CUT_H
