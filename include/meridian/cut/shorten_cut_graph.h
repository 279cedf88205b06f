// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_SHORTEN_CUT_GRAPH_H
#define MERIDIAN_CUT_SHORTEN_CUT_GRAPH_H

#include <meridian/cut/internal/network_exchange.h>
#include <meridian/surface/Surface_curve.h>

namespace meridian {

namespace internal {

// Adds paths of edges to a network. Each is pushed off the vertices that it passes, to its left.
inline void add_paths(Normal_curves& curves, const std::vector<std::vector<Index>>& paths)
{
  const Triangle_surface& s = curves.surface();
  for (const auto& path : paths)
  {
    std::vector<Normal_curves::Step> steps;
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

inline double network_length(const Normal_curves& curves)
{
  double sum = 0;
  for (Index c = 0; c < curves.number_of_curves(); ++c)
  {
    if (curves.is_open(c)) { sum += curve_length(curves, c); }
  }
  return sum;
}

// Moves all vertices of a network, and parts and joins them, until no pass gains more than the least gain. `pause` is
// called between moves; it may throw.
inline void move_vertices(Normal_curves& curves, const Tighten_options& options, const std::function<void()>& pause)
{
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
      pause();
      for (std::optional<Index> at = v; at && !curves.ends_at(*at).empty();) { at = move_vertex(curves, *at, options); }
    }
    for (Index c = 0; c < curves.number_of_curves(); ++c)
      if (curves.is_open(c) && curves.nearest({c, false}) < 0) { exchange_neighbors(curves, c, options); }
    tighten_curves(curves, options);
    if (!(network_length(curves) < (1 - options.least_gain) * before)) { return; }
  }
}

// The curves of a network, placed.
inline std::vector<Surface_curve> place_network(const Normal_curves& curves)
{
  const Triangle_surface& s = curves.surface();
  std::vector<std::vector<Crossing>> crossings;
  std::vector<Index> present;
  for (Index c = 0; c < curves.number_of_curves(); ++c)
  {
    if (!curves.is_open(c)) { continue; }
    present.push_back(c);
    auto& all = crossings.emplace_back();
    for (Index x : curves.crossings(c))
    {
      all.push_back({curves[x].halfedge, curves.edge(x), 0, curves[x].place, curves[x].t, true, -1});
    }
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

} // namespace internal

/*!
 * \ingroup PkgMeridianCut
 *
 * makes a cut graph shorter; what it leaves of the surface stays a disc.
 *
 * The paths of the graph become open curves in normal position. Three moves are tried by turns until none gains more
 * than the least gain:
 * - a curve is pulled tight and moved over vertices of the mesh (see `tighten_curves()`);
 * - a vertex of the graph moves to a neighbour, two curves that leave it at less than 120 degrees part from the others,
 * or two vertices draw together and part the other way: the graph tends to a Steiner network of geodesics;
 * - a shorter way through the disc takes the place of a curve whose two sides it separates.
 *
 * The first two keep the class of the graph. The third keeps the disc: a disc cut along a way through it is two discs,
 * and glueing them along a curve that lies on both makes one. Which curves these are is read from the walk around the
 * disc, and the walk is done again, as a count, after each exchange. No step depends on a number being exact.
 *
 * \param root the surface
 * \param paths the graph: vertices joined by edges inside the surface, as from `seam_paths()`
 * \param options see there
 *
 * \returns the curves of the graph, not longer than it was; their ends are vertices of `root`
 * \pre `root` is connected; cutting along the paths leaves one disc; no path dangles
 * \throws Internal_error if the paths leave anything but a disc
 * \par Complexity
 * \f$ O(n \log n) \f$ for each round of exchanges and the size of the graph for each of them, and linear in the
 * crossings of the curves that a move changes
 */
inline std::vector<Surface_curve> shorten_cut_graph(const Triangle_surface& root,
                                                    const std::vector<std::vector<Index>>& paths,
                                                    const Tighten_options& options = Tighten_options())
{
  Normal_curves curves(root, 0);
  internal::add_paths(curves, paths);
  if (curves.number_of_curves() == 0) { return {}; }
  double done = 0;
  const auto pause = [&] {
    if (options.progress) { options.progress(done); }
  };
  Tighten_options quiet = options;
  quiet.progress = nullptr;
  tighten_curves(curves, quiet);
  internal::Network_exchange exchange(curves);
  double last = internal::network_length(curves);
  for (int round = 0; round < options.rounds; ++round)
  {
    done = static_cast<double>(round) / options.rounds;
    internal::move_vertices(curves, quiet, pause);
    for (double before = internal::network_length(curves); exchange.run(quiet, pause) > 0;)
    {
      const double now = internal::network_length(curves);
      if (!(now < (1 - options.least_gain) * before)) { break; }
      before = now;
    }
    tighten_curves(curves, quiet);
    const double now = internal::network_length(curves);
    if (!(now < (1 - options.least_gain) * last)) { break; }
    last = now;
  }
  std::vector<Surface_curve> placed = internal::place_network(curves), as_given;
  double before = 0, after = 0;
  for (const auto& path : paths)
  {
    auto& curve = as_given.emplace_back();
    for (Index v : path) { curve.points.push_back(Curve_point::on_vertex(v)); }
    before += length(root, curve);
  }
  for (const Surface_curve& curve : placed) { after += length(root, curve); }
  // where faces have no area, the places of crossings may cost more than was gained
  return after < before ? placed : as_given;
}

} // namespace meridian

#endif // MERIDIAN_CUT_SHORTEN_CUT_GRAPH_H
