// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_FIND_ARC_H
#define MERIDIAN_CUT_FIND_ARC_H

#include <meridian/base/vectors.h>
#include <meridian/surface/Surface_curve.h>
#include <meridian/surface/Triangle_surface.h>

#include <array>
#include <functional>
#include <vector>

namespace meridian {

/*!
 * \ingroup PkgMeridianLinks
 *
 * finds a short arc through a disc, from its border to its border, that divides it into two discs.
 *
 * The Voronoi diagram of the border's vertices is grown through the disc; where two of its cells touch, the shortest
 * ways back to their vertices make an arc that is locally shortest, and what lies on either side is known from the
 * areas of the cells. Of all these arcs the one is taken whose length is least for what it brings: parts alike in
 * area, and faces apart that should be. It is then made straight.
 *
 * \param disc the surface
 * \param apart pairs of faces that should come apart; if there are none, only area counts
 * \param on_edges whether the arc runs along edges
 * \param is_good if given: whether an arc across faces may be taken; if not, the next best is tried, a hundred at most
 * \param kept_out of each face, whether the arc shall not go there; empty: it may go anywhere
 *
 * \returns the arc, from a vertex of the border to another, through no other, or nothing if there is none: the disc
 *          has no edge or face inside that could be crossed
 * \pre `disc` is a disc
 * \par Complexity
 * \f$ O(n \log n) \f$
 */
Surface_curve find_arc(const Triangle_surface& disc, const std::vector<std::array<Index, 2>>& apart, bool on_edges,
                       const std::function<bool(const Surface_curve&)>& is_good = {},
                       const std::vector<char>& kept_out = {});

} // namespace meridian

#endif // MERIDIAN_CUT_FIND_ARC_H
