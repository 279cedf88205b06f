// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/cut/shorten_cut_graph.h>

#include <meridian/base/exceptions.h>
#include <meridian/curves/place_crossings.h>
#include <meridian/curves/sleeve.h>
#include <meridian/cut/edge_cuts.h>
#include <meridian/cut/internal/network_moves.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/measures.h>
#include <meridian/surface/seam_paths.h>
#include <meridian/surface/seams.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

namespace meridian {

namespace internal {

void add_paths(Normal_curves& curves, const std::vector<std::vector<Index>>& paths)
{
  const Triangle_surface& s = curves.surface();
  for (const auto& path : paths)
  {
    std::vector<Crossing> steps;
    const auto push = [&](Index h) { // a crossing next to the source of `h`
      if (!steps.empty() && s.opposite[steps.back().halfedge] == h)
      {
        steps.pop_back();
        return;
      }
      const Index e = s.edge(h);
      steps.push_back({h, e == h ? 0 : static_cast<Index>(curves.on(e).size()), e == h ? 0.25 : 0.75});
    };
    for (std::size_t i = 1; i + 1 < path.size(); ++i)
    {
      const Index back = s.find_halfedge(path[i], path[i - 1]), on = s.find_halfedge(path[i], path[i + 1]);
      if (back < 0 || on < 0)
      {
        throw Internal_error("add_paths: two vertices of a path are not joined by an edge inside the surface");
      }
      for (Index h = s.turn_right(back); h != on; h = s.turn_right(h)) { push(h); }
    }
    while (!steps.empty() && touches(s, steps.front().halfedge, path.front())) { steps.erase(steps.begin()); }
    while (!steps.empty() && touches(s, steps.back().halfedge, path.back())) { steps.pop_back(); }
    curves.add(path.front(), path.back(), steps);
  }
}

double network_length(const Normal_curves& curves)
{
  double sum = 0;
  for (Index c = 0; c < curves.number_of_curves(); ++c)
  {
    if (curves.is_open(c)) { sum += curve_length(curves, c); }
  }
  return sum;
}

void move_vertices(Normal_curves& curves, const Tighten_options& options, const Progress& progress)
{
  const double least_gain = 50 * options.least_gain; // of a pass
  // What could not be moved at some time can not as long as nothing has changed there.
  std::unordered_map<Index, std::uint64_t> at_vertex, at_curve;
  const auto has_changed = [&](Index v, std::uint64_t since) {
    return curves.ends_at(v).empty() || curves.has_changed_at(v, since);
  };
  for (int pass = 0; pass < options.passes; ++pass)
  {
    const double before = network_length(curves);
    std::set<Index> vertices;
    for (Index c = 0; c < curves.number_of_curves(); ++c)
      if (curves.is_open(c))
      {
        for (bool is_last : {false, true}) { vertices.insert(curves.vertex({c, is_last})); }
      }
    for (Index v : vertices)
    {
      if (progress) { progress(static_cast<double>(pass) / options.passes); }
      const auto tried = at_vertex.find(v);
      if (tried != at_vertex.end() && !has_changed(v, tried->second)) { continue; }
      Index last = v;
      for (std::optional<Index> at = v; at && !curves.ends_at(*at).empty();)
      {
        last = *at;
        at = move_vertex(curves, *at, options);
      }
      at_vertex[last] = curves.clock();
    }
    for (Index c = 0; c < curves.number_of_curves(); ++c)
    {
      if (!curves.is_open(c) || curves.nearest({c, false}) >= 0) { continue; }
      const auto tried = at_curve.find(c);
      if (tried != at_curve.end() && !has_changed(curves.vertex({c, false}), tried->second)
          && !has_changed(curves.vertex({c, true}), tried->second))
      {
        continue;
      }
      exchange_neighbors(curves, c, options);
      at_curve[c] = curves.clock();
    }
    tighten_curves(curves, options);
    if (!(network_length(curves) < (1 - least_gain) * before)) { return; }
  }
}

namespace {

// The paths of the shorter graph that exchanging makes of one.
std::vector<std::vector<Index>> exchange_paths(const Triangle_surface& root,
                                               const std::vector<std::vector<Index>>& paths, int rounds)
{
  std::vector<Index> edges;
  for (const auto& path : paths)
    for (std::size_t i = 1; i < path.size(); ++i)
    {
      const Index h = root.find_halfedge(path[i - 1], path[i]);
      if (h < 0 || root.opposite[h] < 0)
      {
        throw Invalid_input_error("shorten_cut_graph: vertices " + std::to_string(path[i - 1]) + " and "
                                  + std::to_string(path[i])
                                  + " of a path are not joined by an edge inside the surface");
      }
      edges.push_back(root.edge(h));
    }
  Refined_surface s(root);
  flag_seam(s, exchange_in_edge_cut(root, edges, rounds));
  return seam_paths(s);
}

// The curves of a network, placed.
std::vector<Surface_curve> place_network(const Normal_curves& curves)
{
  const Triangle_surface& s = curves.surface();
  std::vector<std::vector<Piece_crossing>> crossings;
  std::vector<Index> present;
  for (Index c = 0; c < curves.number_of_curves(); ++c)
  {
    if (!curves.is_open(c)) { continue; }
    present.push_back(c);
    auto& all = crossings.emplace_back();
    for (Index x : curves.crossings(c)) { all.push_back({curves[x], curves.edge(x)}); }
  }
  auto placed = place_crossings(s, crossings, false,
                                [&](Index v) { return !s.is_boundary_vertex(v) && curves.ends_at(v).empty(); });
  for (std::size_t i = 0; i < present.size(); ++i)
  {
    auto& points = placed[i].points;
    points.insert(points.begin(), Curve_point::on_vertex(curves.vertex({present[i], false})));
    points.push_back(Curve_point::on_vertex(curves.vertex({present[i], true})));
  }
  return placed;
}

} // namespace

} // namespace internal

std::vector<Surface_curve> shorten_cut_graph(const Triangle_surface& root, const std::vector<std::vector<Index>>& paths,
                                             const Tighten_options& options, const Progress& progress)
{
  if (paths.empty()) { return {}; }
  constexpr int rounds = 10; // of exchanges
  const std::vector<std::vector<Index>> exchanged = internal::exchange_paths(root, paths, rounds);
  Normal_curves curves(root, 0);
  internal::add_paths(curves, exchanged);
  tighten_curves(curves, options);
  internal::move_vertices(curves, options, progress);
  std::vector<Surface_curve> placed = internal::place_network(curves), on_edges;
  double before = 0, after = 0;
  for (const auto& path : exchanged)
  {
    auto& curve = on_edges.emplace_back();
    for (Index v : path) { curve.points.push_back(Curve_point::on_vertex(v)); }
    before += length(root, curve);
  }
  for (const Surface_curve& curve : placed) { after += length(root, curve); }
  // where a face has many curves, or no area, the places of crossings may cost more than was gained
  return after < before ? placed : on_edges;
}

} // namespace meridian
