// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_EDGE_CUTS_H
#define MERIDIAN_CUT_EDGE_CUTS_H

#include <meridian/base/Progress_observer.h>
#include <meridian/base/vectors.h>
#include <meridian/cut/Edge_metric.h>
#include <meridian/surface/Triangle_surface.h>

#include <vector>

namespace meridian {

/// \ingroup PkgMeridianCut
/// where the paths of a cut graph of edges may end when they are made shorter.
enum class Path_ends
{
  FIXED, ///< at the nodes they ended at before
  SLIDE  ///< anywhere on the rest of the cut graph or the boundary
};

/*!
 * \ingroup PkgMeridianCut
 *
 * \returns a cut graph of edges from the shortest loops at a base point (\cite erickson2005, "Greedy optimal
 *          homotopy and homology generators")
 *
 * Shortest ways along edges from the base make a tree. Each other edge closes a loop with it, over the ways to its two
 * ends. A spanning tree of the faces crosses those with the longest loops; what it leaves beside the vertices' tree has
 * the shortest. What dangles is taken off. Going along the boundary costs nothing, as that is no seam; so boundary
 * loops are joined to the graph by shortest ways from the base, and every genus and number of loops is one case. On a
 * closed sphere it is the way to the vertex farthest from the base, of two edges at least.
 *
 * \param s the surface
 * \param base the vertex that all loops come from
 * \param metric how long edges count
 *
 * \pre `s` is connected
 * \post the edges are inside the surface, each given as its lower halfedge, sorted; cutting along them leaves one disc
 * \throws Invalid_input_error if there is no such vertex
 * \par Complexity
 * \f$ O(n \log n) \f$
 */
std::vector<Index> cut_by_tree_cotree(const Triangle_surface& s, Index base, const Edge_metric& metric = {});

/*!
 * \ingroup PkgMeridianCut
 *
 * \returns the shortest of the cut graphs that `cut_by_tree_cotree()` finds from several vertices; of equal ones the
 *          first
 *
 * The first base is far out; each further one is the vertex farthest from those before (\cite gonzalez1985), the lowest
 * of equals. A closed sphere has one cut, between two vertices far apart.
 *
 * \param s the surface
 * \param bases how many base points; from the number of vertices on, all are taken
 * \param progress told after each base how much is done \param metric how long edges count
 * \param may_be_base tells of a vertex whether it may be a base, where not all are taken; empty: each may
 *
 * \pre `s` is connected
 * \post as of `cut_by_tree_cotree()`
 * \throws Invalid_input_error if `bases` is below 1
 * \par Complexity
 * \f$ O(n \log n) \f$ for each base
 */
std::vector<Index> find_short_tree_cotree_cut(const Triangle_surface& s, int bases = 16, const Progress& progress = {},
                                              const Edge_metric& metric = {},
                                              const std::function<bool(Index)>& may_be_base = {});

/*!
 * \ingroup PkgMeridianCut
 *
 * makes the paths of a cut graph of edges shorter.
 *
 * A path runs between two nodes: vertices where another number of edges than two meet, or on the boundary. Without it
 * the rest leaves an annulus, and any simple path between the two boundaries of that leaves a disc again. The shortest
 * one takes its place, from node to node as \cite gu2002 do, or wherever it may end. A path over a closed
 * sphere stays.
 *
 * \param s the surface
 * \param cut the edges, a halfedge of each
 * \param ends where paths may end
 * \param rounds how often all paths are gone through at most; it ends when none got shorter
 * \param may_pass whether a path may pass through a vertex; all may, by default. What does not hold of a path is left
 *   where it is
 *
 * \returns the edges of the shorter cut graph, sorted
 * \pre `s` is connected, cutting it along the edges leaves one disc, and no edge dangles
 * \post cutting along them leaves one disc, and they are not longer than before
 * \throws Invalid_input_error if the edges are found to be no cut graph
 * \par Complexity
 * For each path once the size of the cut graph, and \f$ O(k \log k) \f$ for the `k` vertices within the length of the
 * path
 */
std::vector<Index> straighten_edge_cut(
  const Triangle_surface& s, const std::vector<Index>& cut, Path_ends ends = Path_ends::SLIDE, int rounds = 5,
  const std::function<bool(Index)>& may_pass = [](Index) { return true; });

/*!
 * \ingroup PkgMeridianCut
 *
 * puts shorter paths of edges in the place of others, wherever they lie.
 *
 * A way through the disc that a cut graph leaves may take the place of any path that has a side on either hand of it.
 * The shortest are found all at once, where the cells of the nearest sides touch; what gains most is exchanged first.
 * \param s the surface \param cut the edges, a halfedge of each
 * \param rounds of growing cells at most; it ends when one gains less than a thousandth
 * \returns the edges of the shorter cut graph, sorted
 * \pre `s` is connected, and cutting it along the edges leaves one disc, as it does afterwards
 * \throws Invalid_input_error if more than a disc is left
 * \par Complexity
 * For each round \f$ O(n \log n) \f$, and for every exchange the number of paths
 */
std::vector<Index> exchange_in_edge_cut(const Triangle_surface& s, const std::vector<Index>& cut, int rounds = 10);

/*!
 * \ingroup PkgMeridianCut
 *
 * \returns a cut graph of edges from taking faces away (\cite gu2002, "Geometry images", section 3.1)
 *
 * Faces are taken away from a seed on, in the order of their distance through faces, each with the edge to the one
 * before. The edges that are left over are pruned to a cut graph, and its paths straightened. A closed sphere is opened
 * along a path between two vertices far apart.
 * \param s the surface
 * \param seed_face the first face, or -1 for one at a vertex far out
 * \param ends where paths may end when they are straightened; as published, at their nodes
 * \param rounds of straightening at most
 *
 * \pre `s` is connected
 * \post as of `cut_by_tree_cotree()`
 * \throws Invalid_input_error if there is no such face
 * \par Complexity
 * \f$ O(n \log n) \f$, and that of `straighten_edge_cut()`
 */
std::vector<Index> cut_by_removing_faces(const Triangle_surface& s, Index seed_face = -1,
                                         Path_ends ends = Path_ends::FIXED, int rounds = 5);

} // namespace meridian

#endif // MERIDIAN_CUT_EDGE_CUTS_H
