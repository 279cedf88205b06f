// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/cut/edge_cuts_near.h>

#include <meridian/base/exceptions.h>
#include <meridian/cut/Edge_metric.h>
#include <meridian/cut/edge_cuts.h>
#include <meridian/cut/internal/edge_trees.h>
#include <meridian/surface/distance_rings.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <vector>

namespace meridian {

namespace internal {

Seam_trace trace_seam(const Triangle_surface& root, const Refined_surface& cut)
{
  Seam_trace trace;
  trace.crosses.assign(root.number_of_halfedges(), 0);
  trace.follows.assign(root.number_of_halfedges(), 0);
  trace.is_on.assign(root.number_of_vertices(), 0);
  trace.beside.assign(root.number_of_vertices(), std::numeric_limits<double>::infinity());
  const auto edge_in = [&](Index f, const std::array<Index, 2>& ends) {
    for (Index h = 3 * f; h < 3 * f + 3; ++h)
      if (std::minmax(root.source(h), root.target(h)) == std::minmax(ends[0], ends[1])) { return root.edge(h); }
    throw Internal_error("trace_seam: a point does not lie on the face it came from");
  };
  std::vector<Index> degree(cut.number_of_vertices(), 0);
  for (Index h = 0; h < cut.number_of_halfedges(); ++h)
  {
    if (!cut.seam[h]) { continue; }
    ++degree[cut.source(h)];
    const Index f = cut.face_of[cut.face(h)];
    for (Index v : {cut.source(h), cut.target(h)})
    {
      const Origin o = cut.origin(v);
      if (o.kind == Origin::EDGE) { trace.crosses[edge_in(f, o.index)] = 1; }
      if (o.kind == Origin::VERTEX) { trace.is_on[o.index[0]] = 1; }
      const Point at = position(root, o);
      const auto reach = [&](Index w) { trace.beside[w] = std::min(trace.beside[w], distance(root.points[w], at)); };
      if (o.kind != Origin::FACE) { reach(o.index[0]); }
      if (o.kind == Origin::EDGE) { reach(o.index[1]); }
      if (o.kind == Origin::FACE)
      {
        for (Index w : root.triangles[o.index[0]]) { reach(w); }
      }
    }
    std::array<Index, 2> ends;
    std::array<double, 2> t;
    if (on_common_root_edge(cut.origin(cut.source(h)), cut.origin(cut.target(h)), ends, t))
    {
      trace.follows[edge_in(f, ends)] = 1;
    }
  }
  for (Index v = 0; v < cut.number_of_vertices(); ++v)
  {
    if (degree[v] != 1) { continue; }
    const Origin o = cut.origin(v);
    trace.ends.push_back(o.kind == Origin::FACE ? root.triangles[o.index[0]][0] : o.index[0]);
  }
  std::sort(trace.ends.begin(), trace.ends.end());
  trace.ends.erase(std::unique(trace.ends.begin(), trace.ends.end()), trace.ends.end());
  return trace;
}

namespace {

bool is_beside(const Seam_trace& trace, Index v) { return trace.beside[v] < std::numeric_limits<double>::infinity(); }

// A tree of edges near the seam of a closed sphere, that joins the seam's ends.
std::vector<Index> cut_sphere_near(const Triangle_surface& root, const Seam_trace& trace)
{
  if (trace.ends.size() < 2) { return cut_sphere(root, -1, measure_edges(root, {})); }
  constexpr double away = 1000; // how much longer an edge counts that leaves the faces of the seam
  const Edge_tree tree = grow_edge_tree(root, {{0., trace.ends.front()}}, [&](Index h) {
    return (is_beside(trace, root.source(h)) && is_beside(trace, root.target(h)) ? 1 : away) * root.length(h);
  });
  std::vector<char> is_cut(root.number_of_halfedges(), 0);
  for (Index v : trace.ends)
  {
    for (Index h : way_to(root, tree, v)) { is_cut[h] = 1; }
  }
  std::vector<Index> edges = flagged_edges(root, is_cut);
  return edges.size() < 2 ? cut_sphere(root, trace.ends.front(), measure_edges(root, {})) : edges;
}

// The distance of each vertex from the seam along edges; infinite beyond `limit`.
std::vector<double> distances_from(const Triangle_surface& root, const Seam_trace& trace, double limit)
{
  std::vector<std::pair<double, Index>> starts;
  for (Index v = 0; v < root.number_of_vertices(); ++v)
  {
    if (is_beside(trace, v)) { starts.emplace_back(trace.beside[v], v); }
  }
  double mean = 0;
  for (Index h = 0; h < root.number_of_halfedges(); ++h) { mean += root.length(h) / root.number_of_halfedges(); }
  return find_distances(
    root.number_of_vertices(), starts, mean,
    [&](Index v, const auto& reach) {
      root.for_each_outgoing(v, [&](Index h) {
        reach(root.target(h), root.length(h));
        const Index in = root.prev(h); // a boundary edge has only the halfedge that comes in
        if (root.opposite[in] < 0) { reach(root.source(in), root.length(in)); }
      });
    },
    limit);
}

// What the seam does on an edge: nothing, touch it, cross it, follow it.
int rank_of(const Triangle_surface& root, const Seam_trace& trace, Index edge)
{
  const bool touches = trace.is_on[root.source(edge)] || trace.is_on[root.target(edge)];
  return trace.follows[edge] ? 3 : trace.crosses[edge] ? 2 : touches ? 1 : 0;
}

// The edges inside the surface by what the seam does on them, those farthest from it first. Of those that it does not
// even touch that is left out, unless `all` shall be sorted.
std::vector<Index> order_edges(const Triangle_surface& root, const Seam_trace& trace, bool all)
{
  std::array<std::vector<Index>, 4> edges;
  double limit = 0; // within it lie all vertices that matter
  for (Index h = 0; h < root.number_of_halfedges(); ++h)
  {
    if (root.opposite[h] < h) { continue; }
    const int rank = rank_of(root, trace, h);
    edges[rank].push_back(h);
    if (rank > 0) { limit = std::max(limit, root.length(h)); }
    for (Index v : {root.source(h), root.target(h)})
    {
      if (is_beside(trace, v)) { limit = std::max(limit, trace.beside[v]); }
    }
  }
  if (all) { limit = std::numeric_limits<double>::infinity(); }
  const std::vector<double> away = distances_from(root, trace, limit);
  std::vector<Index> order;
  for (auto& of_rank : edges)
  {
    const bool is_sorted = all || &of_rank != edges.data();
    std::vector<std::pair<double, Index>> ranked;
    for (Index h : of_rank) { ranked.emplace_back(is_sorted ? -(away[root.source(h)] + away[root.target(h)]) : 0, h); }
    if (is_sorted) { std::sort(ranked.begin(), ranked.end()); }
    for (const auto& [nearness, h] : ranked) { order.push_back(h); }
  }
  return order;
}

// The cut graph that is left by a spanning tree of the faces which crosses edges in their order. Where the seam is a
// cut graph, all that it does not touch lies in a disc, and whichever of these edges the tree does not cross dangle. So
// they are sorted only if one of them is left.
std::vector<Index> edges_near(const Triangle_surface& root, const Seam_trace& trace)
{
  for (const bool all : {false, true})
  {
    std::vector<char> is_cut = edges_beside_face_tree(root, order_edges(root, trace, all));
    prune(root, is_cut);
    std::vector<Index> edges = flagged_edges(root, is_cut);
    const bool is_near = std::all_of(edges.begin(), edges.end(), [&](Index h) { return rank_of(root, trace, h) > 0; });
    if (all || is_near) { return edges; }
  }
  return {};
}

} // namespace

} // namespace internal

std::vector<Index> cut_of_edges_near(const Triangle_surface& root, const Refined_surface& cut, int rounds)
{
  const internal::Seam_trace trace = internal::trace_seam(root, cut);
  if (internal::is_sphere(root)) { return internal::cut_sphere_near(root, trace); }
  return straighten_edge_cut(root, internal::edges_near(root, trace), Path_ends::SLIDE, rounds,
                             [&](Index v) { return trace.beside[v] < std::numeric_limits<double>::infinity(); });
}

} // namespace meridian
