// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_RESULT_ASSEMBLE_RESULT_H
#define MERIDIAN_RESULT_ASSEMBLE_RESULT_H

#include <meridian/base/Polygon_soup.h>
#include <meridian/cut/Cut.h>
#include <meridian/result/Assembled_result.h>
#include <meridian/result/internal/assemble_parts.h>
#include <meridian/surface/examine_surface.h>
#include <meridian/surface/open_along.h>

#include <vector>

namespace meridian {

/*!
 * \ingroup PkgMeridianResults
 *
 * puts the discs of all components back into one mesh in the order of the input.
 *
 * \param soup the input
 * \param examination what `examine_surface()` made of it
 * \param cuts the cut of each component
 *
 * \returns the opened mesh. The parts of a face stand where the face stood.
 * \par Complexity
 * Linear.
 */
Assembled_result assemble_result(const Polygon_soup& soup, const Examination& examination,
                                 const std::vector<Cut>& cuts);

/*!
 * \ingroup PkgMeridianResults
 *
 * puts refined components back into one mesh in the order of the input, with nothing taken apart.
 *
 * \tparam Curves `Generators` or `Homology_basis`
 * \param soup the input
 * \param examination what `examine_surface()` made of it
 * \param all those of each component
 *
 * \returns the refined mesh. The parts of a face stand where the face stood.
 * \par Complexity
 * Linear.
 */
template <class Curves>
Assembled_result assemble_refined(const Polygon_soup& soup, const Examination& examination,
                                  const std::vector<Curves>& all)
{
  std::vector<Opened_surface> whole(all.size());
  std::vector<internal::Result_part> parts;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    whole[i].triangles = all[i].surface.triangles;
    parts.push_back({all[i].surface, whole[i]});
  }
  return internal::assemble_parts(soup, examination, parts);
}

} // namespace meridian

#endif // MERIDIAN_RESULT_ASSEMBLE_RESULT_H
