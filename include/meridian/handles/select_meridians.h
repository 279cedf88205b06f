// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_HANDLES_SELECT_MERIDIANS_H
#define MERIDIAN_HANDLES_SELECT_MERIDIANS_H

#include <meridian/curves/contours.h>
#include <meridian/field/Ordered_surface.h>
#include <meridian/handles/preference.h>

#include <vector>

namespace meridian {

/// \ingroup PkgMeridianMeridians
/// a chosen loop, and what the surface is after all loops up to it are cut.
struct Meridian_choice
{
  std::size_t loop;     ///< its place among the candidates
  int genus_after;      ///< genus of the surface cut so far
  int components_after; ///< number of its components
};

/// \ingroup PkgMeridianMeridians
/// \param candidates the loops
/// \param rate rates one
/// \returns the candidates' places, the most preferred first: by rate, then length, then place
std::vector<std::size_t> rank_by_preference(const std::vector<Loop_candidate>& candidates, const Preference& rate);

/*!
 * \ingroup PkgMeridianMeridians
 *
 * chooses the loops that cut all handles and leave the surface connected.
 *
 * The paper tries the loops from the most to the least preferred and recounts the genus after each. The same loops come
 * out of one pass the other way round: take them from the *least* to the *most* preferred; one that joins two pieces
 * stays uncut, every other is cut. (Loops are the edges and pieces the nodes of a graph, and the uncut loops are its
 * spanning tree: reverse-delete duality.)
 *
 * \param m the ordered surface
 * \param loops disjoint contours, at least all loops of the saddles
 * \param order the loops' places, the most preferred first
 *
 * \returns the chosen loops, the most preferred first, with the genus and the number of components after each cut
 * \post as many loops as the genus
 * \par Complexity
 * \f$ O((n + k \log k) \alpha(n)) \f$ for `k` crossings
 */
std::vector<Meridian_choice> select_meridians(const Ordered_surface& m, const std::vector<Contour>& loops,
                                              const std::vector<std::size_t>& order);

} // namespace meridian

#endif // MERIDIAN_HANDLES_SELECT_MERIDIANS_H
