// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_EDGE_CUTS_H
#define MERIDIAN_CUT_EDGE_CUTS_H

#include <meridian/cut/internal/edge_trees.h>
#include <meridian/cut/internal/straighten_paths.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/seams.h>

#include <functional>
#include <string>
#include <tuple>

namespace meridian {

/// \ingroup PkgMeridianCut
/// where the paths of a cut graph of edges may end when they are made shorter.
enum class Path_ends
{
  FIXED, ///< at the nodes they ended at before
  SLIDE  ///< anywhere on the rest of the cut graph or the boundary
};

namespace internal {

// The tree of shortest ways along edges from `base`; the boundary costs nothing.
inline Edge_tree seam_tree(const Triangle_surface& s, Index base)
{
  return grow_edge_tree(s, {{0., base}}, [&](Index h) { return s.opposite[h] < 0 ? 0. : s.length(h); });
}

inline std::vector<Index> close_tree_to_cut(const Triangle_surface& s, const Edge_tree& tree)
{
  std::vector<char> is_in_tree(s.number_of_halfedges(), 0);
  for (Index h : tree.by)
  {
    if (h >= 0) { is_in_tree[s.edge(h)] = 1; }
  }
  // The loops, the longest first; then the tree, from far out: of two ways to one boundary loop that are equally long,
  // one must be crossed.
  std::vector<std::tuple<bool, double, Index>> loops;
  for (Index h = 0; h < s.number_of_halfedges(); ++h)
    if (s.opposite[h] > h)
    {
      loops.emplace_back(is_in_tree[h], -(tree.distance[s.source(h)] + tree.distance[s.target(h)] + s.length(h)), h);
    }
  std::sort(loops.begin(), loops.end());
  std::vector<Index> order;
  for (const auto& loop : loops) { order.push_back(std::get<Index>(loop)); }
  std::vector<char> is_cut = edges_beside_face_tree(s, order);
  prune(s, is_cut);
  return flagged_edges(s, is_cut);
}

inline void check_index(const char* function, const char* what, Index i, Index size)
{
  if (i < 0 || i >= size)
    throw Invalid_input_error(std::string(function) + ": there is no " + what + " " + std::to_string(i)
                              + "; the surface has " + std::to_string(size));
}

} // namespace internal

/*!
 * \ingroup PkgMeridianCut
 *
 * \returns a cut graph of edges from the shortest loops at a base point (Erickson, Whittlesey 2005, "Greedy optimal
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
 *
 * \pre `s` is connected
 * \post the edges are inside the surface, each given as its lower halfedge, sorted; cutting along them leaves one disc
 * \throws Invalid_input_error if there is no such vertex
 * \par Complexity
 * \f$ O(n \log n) \f$
 */
inline std::vector<Index> cut_by_tree_cotree(const Triangle_surface& s, Index base)
{
  internal::check_index("cut_by_tree_cotree", "vertex", base, s.number_of_vertices());
  return internal::is_sphere(s) ? internal::cut_sphere(s, base)
                                : internal::close_tree_to_cut(s, internal::seam_tree(s, base));
}

/*!
 * \ingroup PkgMeridianCut
 *
 * \returns the shortest of the cut graphs that `cut_by_tree_cotree()` finds from several vertices; of equal ones the
 *          first
 *
 * The first base is far out; each further one is the vertex farthest from those before (Gonzalez 1985), the lowest of
 * equals. A closed sphere has one cut, between two vertices far apart.
 *
 * \param s the surface
 * \param bases how many base points; from the number of vertices on, all are taken
 * \param progress told after each base how much is done, from 0 to 1; may throw to end the run
 *
 * \pre `s` is connected
 * \post as of `cut_by_tree_cotree()`
 * \throws Invalid_input_error if `bases` is below 1
 * \par Complexity
 * \f$ O(n \log n) \f$ for each base
 */
inline std::vector<Index> find_short_tree_cotree_cut(const Triangle_surface& s, int bases = 16,
                                                     const std::function<void(double)>& progress = {})
{
  if (bases < 1)
  {
    throw Invalid_input_error("find_short_tree_cotree_cut: " + std::to_string(bases)
                              + " base points were asked for; one is the least");
  }
  if (internal::is_sphere(s)) { return internal::cut_sphere(s, -1); }
  const Index n = s.number_of_vertices();
  const bool takes_all = bases >= n;
  const Closed_model g = make_closed_model(s);
  std::vector<double> far(n, std::numeric_limits<double>::infinity());
  Index base = takes_all || g.number_of_nodes < 2 ? 0 : g.representative[find_distant_nodes(s, g).first];
  std::vector<Index> shortest;
  double least = std::numeric_limits<double>::infinity();
  const Index wanted = takes_all ? n : static_cast<Index>(bases);
  for (Index i = 0; i < wanted; ++i)
  {
    const internal::Edge_tree tree = internal::seam_tree(s, base);
    std::vector<Index> cut = internal::close_tree_to_cut(s, tree);
    const double length = length_of_edges(s, cut);
    if (length < least || i == 0)
    {
      least = length;
      shortest = std::move(cut);
    }
    for (Index v = 0; v < n; ++v)
    {
      if (far[v] >= 0) { far[v] = std::min(far[v], tree.distance[v]); }
    }
    far[base] = -1; // not again, also where all distances are 0
    base = takes_all ? i + 1 : static_cast<Index>(std::max_element(far.begin(), far.end()) - far.begin());
    if (progress) { progress(static_cast<double>(i + 1) / wanted); }
  }
  return shortest;
}

/*!
 * \ingroup PkgMeridianCut
 *
 * makes the paths of a cut graph of edges shorter.
 *
 * A path runs between two nodes: vertices where another number of edges than two meet, or on the boundary. Without it
 * the rest leaves an annulus, and any simple path between the two boundaries of that leaves a disc again. The shortest
 * one takes its place, from node to node as Gu, Gortler, Hoppe 2002 do, or wherever it may end. A path over a closed
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
inline std::vector<Index> straighten_edge_cut(
  const Triangle_surface& s, const std::vector<Index>& cut, Path_ends ends = Path_ends::SLIDE, int rounds = 5,
  const std::function<bool(Index)>& may_pass = [](Index) { return true; })
{
  std::vector<char> is_cut(s.number_of_halfedges(), 0);
  for (Index h : cut) { is_cut[h] = is_cut[s.opposite[h]] = 1; }
  internal::Path_straightener straightener(s, is_cut, ends == Path_ends::SLIDE, may_pass);
  while (rounds-- > 0 && straightener.straighten_all()) {}
  return internal::flagged_edges(s, is_cut);
}

/*!
 * \ingroup PkgMeridianCut
 *
 * \returns a cut graph of edges from taking faces away (Gu, Gortler, Hoppe 2002, "Geometry images", section 3.1)
 *
 * Faces are taken away from a seed on, in the order of their distance through faces, each with the edge to the one
 * before. The edges that are left over are pruned to a cut graph, and its paths straightened. A closed sphere is opened
 * along a path between two vertices far apart.
 *
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
inline std::vector<Index> cut_by_removing_faces(const Triangle_surface& s, Index seed_face = -1,
                                                Path_ends ends = Path_ends::FIXED, int rounds = 5)
{
  if (seed_face != -1) { internal::check_index("cut_by_removing_faces", "face", seed_face, s.number_of_faces()); }
  if (internal::is_sphere(s)) { return internal::cut_sphere(s, -1); }
  if (seed_face < 0)
  {
    const Closed_model g = make_closed_model(s);
    seed_face = g.number_of_nodes < 2 ? 0 : s.face(s.outgoing[g.representative[find_distant_nodes(s, g).first]]);
  }
  std::vector<Index> crossed = internal::face_tree(s, seed_face);
  crossed.erase(std::remove(crossed.begin(), crossed.end(), -1), crossed.end());
  std::vector<char> is_cut = internal::edges_beside_face_tree(s, crossed);
  internal::prune(s, is_cut);
  return straighten_edge_cut(s, internal::flagged_edges(s, is_cut), ends, rounds);
}

} // namespace meridian

#endif // MERIDIAN_CUT_EDGE_CUTS_H
