// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_RESULT_RECOUNT_H
#define MERIDIAN_RESULT_RECOUNT_H

#include <meridian/base/Polygon_soup.h>
#include <meridian/base/Verification.h>
#include <meridian/cut/Cut.h>
#include <meridian/proof/verify_cut.h>
#include <meridian/proof/verify_generators.h>
#include <meridian/result/assemble_result.h>
#include <meridian/result/internal/assemble_parts.h>
#include <meridian/result/name_curves.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/examine_surface.h>

#include <vector>

namespace meridian {

namespace internal {

// One surface as a file that holds nothing else.
Polygon_soup soup_of(const Triangle_surface& root);

Examination examination_of(const Triangle_surface& root);

// What a file would hold of a connected surface that is taken apart along its seams, with origins and faces that are
// somebody's claim: nothing is made of them here.
Result_mesh result_of(const Refined_surface& s, const std::vector<Origin>& origins, const std::vector<Index>& face_of);

} // namespace internal

/*!
 * \ingroup PkgMeridianResults
 *
 * \returns the recount of a cut that was made without a file: the surface and the disc as plain arrays, given to
 *          `verify_cut()`
 * \param root the surface that was cut
 * \param cut its cut
 */
Verification verify_cut(const Triangle_surface& root, const Cut& cut);

/// \ingroup PkgMeridianResults
/// \returns the same for a cut that leaves several discs
/// \param root the surface that was cut
/// \param cut its cut
Verification verify_charts(const Triangle_surface& root, const Cut& cut);

/*!
 * \ingroup PkgMeridianResults
 *
 * \returns the recount of curves that were found without a file
 * \tparam Curves `Generators` or `Homology_basis`
 * \param root the surface
 * \param found its curves
 */
template <class Curves> Generator_verification verify_generators(const Triangle_surface& root, const Curves& found)
{
  const Polygon_soup soup = internal::soup_of(root);
  const std::vector<Curves> all{found};
  const Assembled_result assembled = assemble_refined(soup, internal::examination_of(root), all);
  return verify_generators(soup, assembled.mesh, name_curves(all, assembled));
}

} // namespace meridian

#endif // MERIDIAN_RESULT_RECOUNT_H
