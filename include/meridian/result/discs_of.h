// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_RESULT_DISCS_OF_H
#define MERIDIAN_RESULT_DISCS_OF_H

#include <meridian/base/Polygon_soup.h>
#include <meridian/base/Result_mesh.h>
#include <meridian/cut/Cut.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/examine_surface.h>

#include <vector>

namespace meridian {

/// \ingroup PkgMeridianParameterization
/// the disc that a cut made of a surface, its root, and what of the root the cut left alone.
struct Cut_disc
{
  /// the opened surface. The vertices of the root come first and keep their indices; new ones and copies follow
  Triangle_surface disc;
  std::vector<char> is_touched; ///< for each vertex of the root whether it lies on the seam or a face at it was divided
};

/*!
 * \ingroup PkgMeridianParameterization
 *
 * \returns the disc of a cut
 * \param root the surface that was cut
 * \param cut its cut
 * \par Complexity
 * \f$ O(n \log d) \f$ for the largest degree \f$ d \f$
 */
Cut_disc cut_disc_of(const Triangle_surface& root, const Cut& cut);

/*!
 * \ingroup PkgMeridianParameterization
 *
 * finds the discs of a result that was read from files, as `cut_disc_of()` finds them of cuts just made.
 *
 * Copies are traced back through the seams, because `copy_of` names a vertex of the file, and the file may have one
 * vertex where the surface has several, at a pinch.
 *
 * \param input the mesh that was cut
 * \param examination what `examine_surface()` made of it
 * \param result the opened mesh of all components and its map
 *
 * \returns the disc of each component, in its unit of length
 * \pre `verify_cut()` accepts the result
 * \throws Invalid_input_error if the result does not belong to the input
 * \par Complexity
 * \f$ O(n \log n) \f$
 */
std::vector<Cut_disc> cut_discs_of(const Polygon_soup& input, const Examination& examination,
                                   const Result_mesh& result);

} // namespace meridian

#endif // MERIDIAN_RESULT_DISCS_OF_H
