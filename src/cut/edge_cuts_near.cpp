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

// A tree of edges near the seam of a closed sphere, that joins the seam's ends.
std::vector<Index> cut_sphere_near(const Triangle_surface& root, const Seam_trace& trace)
{
  if (trace.ends.size() < 2) { return cut_sphere(root, -1, measure_edges(root, {})); }
  constexpr double away = 1000; // how much longer an edge counts that leaves the faces of the seam
  const auto is_beside = [&](Index v) { return trace.beside[v] < std::numeric_limits<double>::infinity(); };
  const Edge_tree tree = grow_edge_tree(root, {{0., trace.ends.front()}}, [&](Index h) {
    return (is_beside(root.source(h)) && is_beside(root.target(h)) ? 1 : away) * root.length(h);
  });
  std::vector<char> is_cut(root.number_of_halfedges(), 0);
  for (Index v : trace.ends)
  {
    for (Index h : way_to(root, tree, v)) { is_cut[h] = 1; }
  }
  std::vector<Index> edges = flagged_edges(root, is_cut);
  return edges.size() < 2 ? cut_sphere(root, trace.ends.front(), measure_edges(root, {})) : edges;
}

// The distance of each vertex along edges.
std::vector<double> distances_from(const Triangle_surface& root, const std::vector<std::pair<double, Index>>& starts)
{
  double mean = 0;
  for (Index h = 0; h < root.number_of_halfedges(); ++h) { mean += root.length(h) / root.number_of_halfedges(); }
  return find_distances(root.number_of_vertices(), starts, mean, [&](Index v, const auto& reach) {
    root.for_each_outgoing(v, [&](Index h) {
      reach(root.target(h), root.length(h));
      const Index in = root.prev(h); // a boundary edge has only the halfedge that comes in
      if (root.opposite[in] < 0) { reach(root.source(in), root.length(in)); }
    });
  });
}

} // namespace

} // namespace internal

std::vector<Index> cut_of_edges_near(const Triangle_surface& root, const Refined_surface& cut, int rounds)
{
  const internal::Seam_trace trace = internal::trace_seam(root, cut);
  if (internal::is_sphere(root)) { return internal::cut_sphere_near(root, trace); }
  std::vector<std::pair<double, Index>> starts;
  for (Index v = 0; v < root.number_of_vertices(); ++v)
    if (trace.beside[v] < std::numeric_limits<double>::infinity()) { starts.emplace_back(trace.beside[v], v); }
  const std::vector<double> away = internal::distances_from(root, starts);
  // by what the seam does on them, those farthest from it first
  std::array<std::vector<std::pair<double, Index>>, 4> ranks;
  for (Index h = 0; h < root.number_of_halfedges(); ++h)
  {
    if (root.opposite[h] < h) { continue; }
    const Index v = root.source(h), w = root.target(h);
    const bool touches = trace.is_on[v] || trace.is_on[w];
    const int kind = trace.follows[h] ? 3 : trace.crosses[h] ? 2 : touches ? 1 : 0;
    ranks[kind].emplace_back(starts.empty() ? 0 : -(away[v] + away[w]), h);
  }
  std::vector<Index> order;
  for (auto& of_kind : ranks)
  {
    std::sort(of_kind.begin(), of_kind.end());
    for (const auto& [nearness, h] : of_kind) { order.push_back(h); }
  }
  std::vector<char> is_cut = internal::edges_beside_face_tree(root, order);
  internal::prune(root, is_cut);
  return straighten_edge_cut(root, internal::flagged_edges(root, is_cut), Path_ends::SLIDE, rounds,
                             [&](Index v) { return trace.beside[v] < std::numeric_limits<double>::infinity(); });
}

} // namespace meridian
