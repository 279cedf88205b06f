// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_LINK_BOUNDARIES_H
#define MERIDIAN_CUT_LINK_BOUNDARIES_H

#include <meridian/base/Progress_observer.h>
#include <meridian/base/vectors.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/Triangle_surface.h>

#include <vector>

namespace meridian {

/// \ingroup PkgMeridianLinks
/// a way that a link shall take: between the boundaries of the cut surface that two vertices lie on, through faces of
/// the root.
struct Link_guide
{
  Index from;               ///< a vertex of the refined surface
  Index to;                 ///< another
  std::vector<Index> faces; /**< sorted */
};

/// \ingroup PkgMeridianLinks
/// how boundaries are joined.
struct Link_options
{
  bool bifurcations = false; ///< whether a link may end on an earlier link
  Index source = -1;         ///< a root vertex that the links shall pass through, or -1
  /// of each face of the root, whether links go around it, if there is a way; empty: around none
  std::vector<char> kept_out = {};
};

/*!
 * \ingroup PkgMeridianLinks
 *
 * joins all boundaries of a slit genus-0 surface by a tree of shortest paths, which makes it a disc; if it is several
 * pieces, those of each piece.
 *
 * The Voronoi diagram of the boundaries is grown until its cells' contacts hold a minimum spanning tree
 * (\cite kruskal1956); it gives the pairs. Each link is then found as a strip of faces, moved and pulled until it is
 * locally shortest, and inserted before the next, so that links never cross. The topology rests on strips of different
 * faces that cross no seam, which always exist, and on a union-find of boundaries.
 *
 * A closed surface of genus 0 is opened along a path between two vertices far apart, of at least two edges.
 *
 * \param root the surface that `s` refines
 * \param s the surface. The links are inserted and flagged.
 * \param options see there
 * \param guides ways that are taken first, as far as no seam is in the way
 * \param progress told after each link how much is done
 * \param parents if given: for each face that is appended to `s`, the face that it was a part of is appended to it
 * \param points vertices of `s` that the links shall reach too, like boundaries
 *
 * \returns the links as vertices of `s`
 * \pre cutting `s` along its seams leaves pieces of genus 0; if it has neither seams nor a boundary, one
 * \post cutting it along all seams leaves discs
 * \throws Internal_error if two boundaries cannot be joined
 * \par Complexity
 * \f$ O(n \log n) \f$, plus the size of two cells for each link that meets an earlier one
 */
std::vector<std::vector<Index>> link_boundaries(const Triangle_surface& root, Refined_surface& s,
                                                const Link_options& options = Link_options(),
                                                const std::vector<Link_guide>& guides = {},
                                                const Progress& progress = {}, std::vector<Index>* parents = nullptr,
                                                const std::vector<Index>& points = {});

} // namespace meridian

#endif // MERIDIAN_CUT_LINK_BOUNDARIES_H
