// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_RESULT_RECOUNT_H
#define MERIDIAN_RESULT_RECOUNT_H

#include <meridian/proof/verify_cut.h>
#include <meridian/proof/verify_generators.h>
#include <meridian/result/assemble_result.h>
#include <meridian/result/name_curves.h>

namespace meridian {

namespace internal {

// One surface as a file that holds nothing else.
inline Polygon_soup soup_of(const Triangle_surface& root)
{
  Polygon_soup soup;
  soup.points = root.points;
  for (const auto& t : root.triangles) { soup.add_polygon(t.data(), 3); }
  return soup;
}

inline Examination examination_of(const Triangle_surface& root)
{
  Examination examination;
  examination.components.resize(1);
  Surface_component& c = examination.components.front();
  c.vertex_of.resize(root.number_of_vertices());
  c.triangle_of.resize(root.number_of_faces());
  std::iota(c.vertex_of.begin(), c.vertex_of.end(), Index(0));
  std::iota(c.triangle_of.begin(), c.triangle_of.end(), Index(0));
  c.polygon_of = c.triangle_of;
  c.is_flipped.assign(root.number_of_faces(), 0);
  return examination;
}

} // namespace internal

/*!
 * \ingroup PkgMeridianResults
 *
 * \returns the recount of a cut that was made without a file: the surface and the disc as plain arrays, given to
 *          `verify_cut()`
 * \param root the surface that was cut
 * \param cut its cut
 */
inline Verification verify_cut(const Triangle_surface& root, const Cut& cut)
{
  const Polygon_soup soup = internal::soup_of(root);
  return verify_cut(soup, assemble_result(soup, internal::examination_of(root), std::vector<Cut>{cut}).mesh);
}

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
