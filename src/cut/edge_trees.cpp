// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/cut/internal/edge_trees.h>

#include <meridian/base/Union_find.h>
#include <meridian/base/vectors.h>
#include <meridian/surface/Closed_model.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/measures.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace meridian {

namespace internal {

std::vector<Index> way_to(const Triangle_surface& s, const Edge_tree& tree, Index v)
{
  std::vector<Index> edges;
  for (; tree.by[v] >= 0; v = tree.from[v]) { edges.push_back(s.edge(tree.by[v])); }
  return edges;
}

std::vector<Index> flagged_edges(const Triangle_surface& s, const std::vector<char>& flags)
{
  std::vector<Index> edges;
  for (Index h = 0; h < s.number_of_halfedges(); ++h)
  {
    if (flags[h] && s.edge(h) == h) { edges.push_back(h); }
  }
  return edges;
}

std::vector<Index> cut_sphere(const Triangle_surface& s, Index from, const std::vector<double>& lengths)
{
  // a closed surface's nodes are its vertices
  if (from < 0) { from = find_distant_nodes(s, make_closed_model(s)).first; }
  Edge_tree tree = grow_edge_tree(s, {{0., from}}, [&](Index h) { return lengths[h]; });
  Index to = from == 0 ? 1 : 0;
  for (Index v = 0; v < s.number_of_vertices(); ++v)
  {
    if (v != from && tree.distance[v] > tree.distance[to]) { to = v; }
  }
  if (tree.from[to] == from) // one edge would open nothing; a face beside it has another way
  {
    const Index e = s.edge(tree.by[to]);
    tree = grow_edge_tree(
      s, {{0., from}}, [&](Index h) { return s.edge(h) == e ? std::numeric_limits<double>::infinity() : lengths[h]; });
  }
  std::vector<Index> edges = way_to(s, tree, to);
  std::sort(edges.begin(), edges.end());
  return edges;
}

std::vector<char> edges_beside_face_tree(const Triangle_surface& s, const std::vector<Index>& order)
{
  Union_find faces(s.number_of_faces());
  std::vector<char> is_left(s.number_of_halfedges(), 0);
  for (Index h = 0; h < s.number_of_halfedges(); ++h) { is_left[h] = s.opposite[h] >= 0; }
  for (Index h : order)
  {
    const Index o = s.opposite[h];
    if (faces.unite(s.face(h), s.face(o))) { is_left[h] = is_left[o] = 0; }
  }
  return is_left;
}

void prune(const Triangle_surface& s, std::vector<char>& is_cut)
{
  std::vector<Index> degree(s.number_of_vertices(), 0), dangling;
  for (Index h = 0; h < s.number_of_halfedges(); ++h) { degree[s.source(h)] += is_cut[h]; }
  const auto dangles = [&](Index v) { return degree[v] == 1 && !s.is_boundary_vertex(v); };
  for (Index v = 0; v < s.number_of_vertices(); ++v)
  {
    if (dangles(v)) { dangling.push_back(v); }
  }
  while (!dangling.empty())
  {
    const Index v = dangling.back();
    dangling.pop_back();
    if (degree[v] == 0) { continue; } // the other end came first
    Index last = -1;
    s.for_each_outgoing(v, [&](Index h) {
      if (is_cut[h]) { last = h; }
    });
    const Index w = s.target(last);
    is_cut[last] = is_cut[s.opposite[last]] = 0;
    --degree[v];
    --degree[w];
    if (dangles(w)) { dangling.push_back(w); }
  }
}

} // namespace internal

} // namespace meridian
