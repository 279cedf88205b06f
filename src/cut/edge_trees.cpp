// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/cut/internal/edge_trees.h>

#include <meridian/base/Union_find.h>
#include <meridian/base/vectors.h>
#include <meridian/surface/Closed_model.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/measures.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
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

std::vector<Index> cut_sphere(const Triangle_surface& s, Index from)
{
  // a closed surface's nodes are its vertices
  if (from < 0) { from = find_distant_nodes(s, make_closed_model(s)).first; }
  Edge_tree tree = grow_edge_tree(s, {{0., from}}, [&](Index h) { return s.length(h); });
  Index to = from == 0 ? 1 : 0;
  for (Index v = 0; v < s.number_of_vertices(); ++v)
  {
    if (v != from && tree.distance[v] > tree.distance[to]) { to = v; }
  }
  if (tree.from[to] == from) // one edge would open nothing; a face beside it has another way
  {
    const Index e = s.edge(tree.by[to]);
    tree = grow_edge_tree(
      s, {{0., from}}, [&](Index h) { return s.edge(h) == e ? std::numeric_limits<double>::infinity() : s.length(h); });
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

std::vector<Index> face_tree(const Triangle_surface& s, Index seed)
{
  std::vector<double> at(s.number_of_faces(), std::numeric_limits<double>::infinity());
  std::vector<Index> by(s.number_of_faces(), -1);
  std::priority_queue<std::pair<double, Index>, std::vector<std::pair<double, Index>>, std::greater<>> queue;
  at[seed] = 0;
  queue.emplace(0., seed);
  while (!queue.empty())
  {
    const auto [d, f] = queue.top();
    queue.pop();
    if (d > at[f]) { continue; }
    const auto& t = s.triangles[f];
    const Point entry =
      by[f] >= 0 ? s.point_on(by[f], 0.5) : (1. / 3) * (s.points[t[0]] + s.points[t[1]] + s.points[t[2]]);
    for (Index h = 3 * f; h < 3 * f + 3; ++h)
    {
      if (s.opposite[h] < 0) { continue; }
      const Index g = s.face(s.opposite[h]);
      const double reached = d + distance(entry, s.point_on(h, 0.5));
      if (!(reached < at[g]) || g == seed) { continue; }
      at[g] = reached;
      by[g] = h;
      queue.emplace(reached, g);
    }
  }
  return by;
}

} // namespace internal

} // namespace meridian
