// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_INTERNAL_EDGE_TREES_H
#define MERIDIAN_CUT_INTERNAL_EDGE_TREES_H

#include <meridian/base/vectors.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/shortest_ways.h>

#include <utility>
#include <vector>

namespace meridian {
namespace internal {

// Calls `f(h, w)` for each edge at `v` once, with a halfedge of it (which leaves or, on the boundary, reaches `v`) and
// its other end.
template <class Function> void for_each_edge_at(const Triangle_surface& s, Index v, Function f)
{
  s.for_each_outgoing(v, [&](Index h) {
    f(h, s.target(h));
    const Index before = s.prev(h);
    if (s.opposite[before] < 0) { f(before, s.source(before)); }
  });
}

// Shortest ways along edges: for each vertex the distance, the halfedge of the last edge (-1 at a start) and the vertex
// before.
struct Edge_tree
{
  std::vector<double> distance;
  std::vector<Index> by, from;
};

// From starts with a distance each; `cost(h)` of an edge is not negative, and may be infinite.
template <class Cost>
Edge_tree grow_edge_tree(const Triangle_surface& s, const std::vector<std::pair<double, Index>>& starts,
                         const Cost& cost)
{
  Edge_tree tree{{}, std::vector<Index>(s.number_of_vertices(), -1), std::vector<Index>(s.number_of_vertices(), -1)};
  tree.distance = find_shortest_ways(s.number_of_vertices(), starts, [&](Index v, const auto& reach) {
    for_each_edge_at(s, v, [&](Index h, Index w) {
      if (!reach(w, cost(h))) { return; }
      tree.by[w] = h;
      tree.from[w] = v;
    });
  });
  return tree;
}

// The edges from a start to `v`.
std::vector<Index> way_to(const Triangle_surface& s, const Edge_tree& tree, Index v);

// The edges flagged, the lower halfedge of each, sorted.
std::vector<Index> flagged_edges(const Triangle_surface& s, const std::vector<char>& flags);

// Of a connected surface; closed or not.
inline bool is_sphere(const Triangle_surface& s)
{
  return s.number_of_vertices() - s.number_of_edges() + s.number_of_faces() == 2;
}

// The shortest way of at least two edges from `from`, or a vertex far out if that is -1, to the vertex that is farthest
// from it.
std::vector<Index> cut_sphere(const Triangle_surface& s, Index from, const std::vector<double>& lengths);

// Flags, on both halfedges, the edges inside the surface that a spanning tree of the faces does not cross. The tree
// takes edges in the order given (Kruskal 1956). What is left, with the boundary, is connected, and the faces make one
// disc beside it.
std::vector<char> edges_beside_face_tree(const Triangle_surface& s, const std::vector<Index>& order);

// Takes off edges that dangle: those of a vertex inside the surface that ends no other. This opens the disc no less:
// the two copies of such an edge are neighbours on its rim, and glueing them leaves a disc.
void prune(const Triangle_surface& s, std::vector<char>& is_cut);

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_CUT_INTERNAL_EDGE_TREES_H
