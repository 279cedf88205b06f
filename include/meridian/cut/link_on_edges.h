// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_LINK_ON_EDGES_H
#define MERIDIAN_CUT_LINK_ON_EDGES_H

#include <meridian/base/vectors.h>
#include <meridian/surface/Refined_surface.h>

#include <vector>

namespace meridian {

/*!
 * \ingroup PkgMeridianLinks
 *
 * joins all boundaries of a slit genus-0 surface by a tree of paths along existing edges, which makes it a disc; if it
 * is several pieces, those of each piece. No vertex is added.
 *
 * The tree grows from one boundary (\cite prim1957): each link is the shortest path of edges from what is joined so far
 * to the nearest other boundary, and its inside avoids all vertices of boundaries, seams and links. It may begin on an
 * earlier link: if that were not allowed, links could run out of free vertices. A loop whose neighbours all lie on one
 * link, for example, is reached from that link only, and there may be no free vertex in between, which
 * `link_boundaries()` would make by dividing edges.
 *
 * A link always exists. Take the slit surface apart: its corners between seams are the vertices of a connected
 * triangulated surface. The shortest path of edges there from the boundary that holds the tree to the other boundaries
 * has no inner vertex on either, and none of its edges is a seam, as the two sides of a seam have both ends on one
 * boundary. Cutting along it makes one of two boundaries and leaves the surface connected, so with the last link it is
 * a disc.
 *
 * A closed surface of genus 0 is opened along paths that join two vertices far apart, or a point and one of them;
 * they have two edges at least.
 *
 * \param s the surface. The links are flagged.
 * \param points vertices that links shall pass through or end at
 * \param kept_out of each face of the root of `s`, whether links go around it, if there is a way; empty: around none
 *
 * \returns the links as vertices of `s`, each from the tree before it to the boundary that it joins
 * \pre cutting `s` along its seams leaves pieces of genus 0; if it has neither seams nor a boundary, one
 * \post cutting it along all seams leaves discs
 * \par Complexity
 * \f$ O(n \log n) \f$ where each vertex comes nearer to the tree a bounded number of times; for each link that again at
 * worst
 */
std::vector<std::vector<Index>> link_boundaries_on_edges(Refined_surface& s, const std::vector<Index>& points = {},
                                                         const std::vector<char>& kept_out = {});

} // namespace meridian

#endif // MERIDIAN_CUT_LINK_ON_EDGES_H
