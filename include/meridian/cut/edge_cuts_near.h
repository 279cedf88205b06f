// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_EDGE_CUTS_NEAR_H
#define MERIDIAN_CUT_EDGE_CUTS_NEAR_H

#include <meridian/base/vectors.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/Triangle_surface.h>

#include <vector>

namespace meridian {

namespace internal {

// What the seam of a refined surface has to do with its root.
struct Seam_trace
{
  // for each edge of the root, by `edge()`: passes a point inside it, or along a part of it
  std::vector<char> crosses, follows;
  std::vector<char> is_on; // whether a vertex of the root is on the seam
  // for each vertex of the root, how far from it the seam passes an edge or face at it
  std::vector<double> beside;
  std::vector<Index> ends; // vertices of the root at or next to the ends of the seam, sorted
};

Seam_trace trace_seam(const Triangle_surface& root, const Refined_surface& cut);

} // namespace internal

/*!
 * \ingroup PkgMeridianCut
 *
 * \returns a cut graph of edges of the root, close to a cut graph of a refinement
 *
 * A spanning tree of the root's faces takes first the edges that are no part of the given seam: those farthest from it
 * first, then those that touch it in a vertex, then those it crosses, and those it follows last. What is left over is
 * pruned, and its paths are straightened within the vertices next to the seam. So the result is a cut graph whatever
 * the seam is. A face that the seam crosses joins one of its sides; where that can be done for all, the edges left over
 * zigzag across the seam before they are straightened, and lie in its homotopy class. A seam that follows edges of the
 * root throughout is kept as it is with 0 rounds. On a closed sphere, the ends of the seam are joined by ways along the
 * faces it crosses.
 *
 * \param root the surface
 * \param cut a refinement of it with a seam
 * \param rounds of straightening at most
 *
 * \pre `root` is connected
 * \post as of `cut_by_tree_cotree()`
 * \par Complexity
 * \f$ O(n \log n) \f$, and that of `straighten_edge_cut()`
 */
std::vector<Index> cut_of_edges_near(const Triangle_surface& root, const Refined_surface& cut, int rounds = 5);

} // namespace meridian

#endif // MERIDIAN_CUT_EDGE_CUTS_NEAR_H
