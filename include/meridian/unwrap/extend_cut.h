// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_UNWRAP_EXTEND_CUT_H
#define MERIDIAN_UNWRAP_EXTEND_CUT_H

#include <meridian/base/vectors.h>
#include <meridian/cut/Cut.h>
#include <meridian/map/Parameterization.h>
#include <meridian/surface/Triangle_surface.h>

#include <vector>

namespace meridian {

/*!
 * \ingroup PkgMeridianParameterization
 *
 * joins a cut to further vertices by a tree of shortest paths, so that what lies around them can unfold. The disc stays
 * a disc.
 *
 * \param root the surface that was cut
 * \param cut its cut
 * \param vertices vertices of `cut.surface`; nothing happens to those on a seam or a boundary
 * \param on_edges whether paths run along existing edges
 * \param kept_out of each face of `root`, whether paths go around it, if there is a way; empty: around none
 * \returns for each face that is appended to `cut.surface`, the face that it was a part of
 * \par Complexity
 * \f$ O(n \log n) \f$
 */
std::vector<Index> extend_cut(const Triangle_surface& root, Cut& cut, const std::vector<Index>& vertices, bool on_edges,
                              const std::vector<char>& kept_out = {});

/*!
 * \ingroup PkgMeridianParameterization
 *
 * divides the edges inside the disc that join two vertices of its border, so that no face has all its corners there. In
 * a map into a polygon, faces along one side would have no area.
 *
 * \param root the surface that was cut
 * \param cut its cut
 * \par Complexity
 * Linear.
 */
void divide_border_chords(const Triangle_surface& root, Cut& cut);

/*!
 * \ingroup PkgMeridianParameterization
 *
 * \returns vertices in the middle of regions that a map stretches more than those around them, the most stretched
 *          first. Stretch is smoothed over a region that grows with the surface.
 * \param disc the surface
 * \param map its map
 * \param most how many at most
 * \par Complexity
 * \f$ O(n^{1.5}) \f$, for the smoothing
 */
std::vector<Index> find_stretched_vertices(const Triangle_surface& disc, const Parameterization& map, std::size_t most);

} // namespace meridian

#endif // MERIDIAN_UNWRAP_EXTEND_CUT_H
