// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/cut/internal/network_exchange.h>

#include <meridian/base/exceptions.h>
#include <meridian/curves/chords.h>
#include <meridian/curves/sleeve.h>
#include <meridian/cut/internal/network_moves.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace meridian {

namespace internal {

void tidy_vertex(Normal_curves& curves, Index v)
{
  const Triangle_surface& s = curves.surface();
  if (s.is_boundary_vertex(v)) { return; }
  const auto ends = curves.ends_at(v);
  if (ends.size() == 1)
  {
    const Index far = curves.vertex({ends[0].curve, !ends[0].is_last});
    curves.remove(ends[0].curve);
    return tidy_vertex(curves, far);
  }
  if (ends.size() != 2 || ends[0].curve == ends[1].curve) { return; }
  const Network_star star = make_star(curves, v);
  // from one arm to the other, on either side of the vertex
  auto right = spokes_between(star, star.arms[1].at, star.arms[0].at);
  auto left = spokes_between(star, star.arms[0].at, star.arms[1].at);
  if (star.arms[0].at == star.arms[1].at) { left.clear(); } // both leave through one corner
  const bool on_right = right.size() < left.size();
  for (auto* way : {&left, &right})
    for (Index& h : *way) { h = s.opposite[h]; }
  curves.splice(star.arms[on_right].end, star.arms[!on_right].end, on_right ? right : left);
}

int Network_exchange::run(const Tighten_options& options, const std::function<void()>& pause)
{
  grow();
  std::vector<std::pair<double, const Candidate*>> order;
  for (const auto& [sides, c] : m_candidates)
  {
    const double gain = longest_between(c).second - c.length;
    if (gain > 0) { order.emplace_back(-gain, &c); }
  }
  std::stable_sort(order.begin(), order.end(), [](const auto& x, const auto& y) { return x.first < y.first; });
  int exchanged = 0;
  for (const auto& [gain, c] : order)
  {
    pause();
    exchanged += try_exchange(*c, options);
  }
  return exchanged;
}

Index Network_exchange::free_vertex_beside(Index x) const
{
  const Index e = m_curves.edge(x);
  const auto& list = m_curves.on(e);
  if (list.empty()) { return -1; } // it was taken out since
  const auto is_usable = [&](Index v) { return !m_surface.is_boundary_vertex(v) && m_curves.ends_at(v).empty(); };
  const bool first = list.front() == x && is_usable(m_surface.source(e)),
             last = list.back() == x && is_usable(m_surface.target(e));
  if (first && (!last || m_curves[x].t <= 0.5)) { return m_surface.source(e); }
  return last ? m_surface.target(e) : -1;
}

void Network_exchange::walk()
{
  std::vector<std::size_t> begin;
  m_sides = walk_around(m_curves, begin);
  if (begin.size() != 1)
  {
    throw Internal_error("Network_exchange: the network leaves " + std::to_string(begin.size())
                         + " pieces and not a disc");
  }
  m_place.resize(m_curves.number_of_curves());
  m_boundary_place.clear();
  for (std::size_t i = 0; i < m_sides.size(); ++i)
  {
    if (m_sides[i].curve >= 0) { m_place[m_sides[i].curve][m_sides[i].is_forward] = i; }
    else { m_boundary_place[m_sides[i].corner] = i; }
  }
  m_length.resize(m_curves.number_of_curves());
  for (Index c = 0; c < m_curves.number_of_curves(); ++c)
  {
    if (m_curves.is_open(c)) { m_length[c] = curve_length(m_curves, c); }
  }
}

void Network_exchange::grow()
{
  walk();
  m_changed_edges.clear();
  m_changed_vertices.clear();
  m_graph.forget();
  m_roots.clear();
  m_candidates.clear();
  std::unordered_map<Index, Network_star> stars;
  for (std::size_t i = 0; i < m_sides.size(); ++i)
  {
    if (m_sides[i].curve >= 0) { start_on_curve(i); }
    else { start_on_boundary(i); }
    const auto [known, is_new] = stars.try_emplace(m_sides[i].corner);
    if (is_new) { known->second = make_star(m_curves, m_sides[i].corner); }
    start_at_corner(i, known->second);
  }
  // no way more than twice as long is of use
  double farthest = m_length.empty() ? 0 : *std::max_element(m_length.begin(), m_length.end()) / 2;
  m_graph.grow(farthest, [&](Gap_graph::Node n, Gap_graph::Node to, Index region, double length) {
    const Index from_root = m_graph.reached(n).root, to_root = m_graph.reached(to).root;
    const std::size_t a = m_roots[from_root].side, b = m_roots[to_root].side;
    if (a == b) { return; }
    Candidate& c = m_candidates[std::minmax(a, b)];
    if (length < c.length) { c = {length, n, to, m_graph.face(region), {known_as(from_root), known_as(to_root)}}; }
  });
}

void Network_exchange::start(const Gap& g, const Root& root)
{
  if (m_surface.opposite[g.edge] < 0 || m_curves.along(g.edge) >= 0) { return; }
  const Gap_graph::Node n = m_graph.node(g);
  const double d = root.vertex < 0 ? 0 : distance(m_surface.points[root.vertex], m_graph.point(n));
  if (m_graph.start(n, d, static_cast<Index>(m_roots.size()))) { m_roots.push_back(root); }
}

void Network_exchange::start_at_vertex(Index v, const std::vector<Index>& spokes, std::size_t side)
{
  for (Index h : spokes)
  {
    const Index e = m_surface.edge(h);
    const Gap g{e, e == h ? 0 : static_cast<Index>(m_curves.on(e).size())};
    start(g, {v, -1, side});
  }
}

void Network_exchange::start_on_curve(std::size_t side)
{
  for (Index x : m_curves.crossings(m_sides[side].curve))
  {
    if (free_vertex_beside(x) >= 0) { start(gap_beside(m_curves, x, m_sides[side].is_forward), {-1, x, side}); }
  }
}

void Network_exchange::start_on_boundary(std::size_t side)
{
  const Disc_side& before = m_sides[(side + m_sides.size() - 1) % m_sides.size()];
  for (Index v = m_surface.target(m_surface.outgoing[before.corner]); v != m_sides[side].corner;
       v = m_surface.target(m_surface.outgoing[v]))
  {
    std::vector<Index> spokes;
    m_surface.for_each_outgoing(v, [&](Index h) { spokes.push_back(h); });
    start_at_vertex(v, spokes, side);
  }
}

void Network_exchange::start_at_corner(std::size_t i, const Network_star& star)
{
  const Disc_side &side = m_sides[i], &next = m_sides[(i + 1) % m_sides.size()];
  const auto arm_of = [&](const Disc_side& of, bool is_last) {
    return std::find_if(star.arms.begin(), star.arms.end(), [&](const auto& arm) {
      return arm.end == Network_end{of.curve, is_last};
    });
  };
  const auto here = side.curve >= 0 ? arm_of(side, side.is_forward) : star.arms.end();
  const auto there = next.curve >= 0 ? arm_of(next, !next.is_forward) : star.arms.end();
  const Index to = here != star.arms.end() ? here->at : static_cast<Index>(2 * star.spokes.size());
  const Index from = there != star.arms.end() ? there->at : 0;
  if (from == to && there < here) { return; } // both leave through one corner
  start_at_vertex(side.corner, spokes_between(star, from, to), i);
}

Disc_side Network_exchange::known_as(Index root) const
{
  Disc_side side = m_sides[m_roots[root].side];
  if (side.curve < 0) { side.corner = m_roots[root].vertex; }
  return side;
}

std::pair<Index, double> Network_exchange::longest_between(const Candidate& c) const
{
  std::array<std::size_t, 2> at;
  for (int i = 0; i < 2; ++i)
  {
    const Disc_side& side = c.sides[i];
    if (side.curve >= 0)
    {
      if (!m_curves.is_open(side.curve)) { return {-1, 0}; }
      at[i] = m_place[side.curve][side.is_forward];
      continue;
    }
    Index corner = side.corner;
    while (m_curves.ends_at(corner).empty()) { corner = m_surface.target(m_surface.outgoing[corner]); }
    at[i] = m_boundary_place.at(corner);
  }
  const std::size_t n = m_sides.size();
  std::size_t from = std::min(at[0], at[1]), to = std::max(at[0], at[1]);
  if (from == to) { return {-1, 0}; }
  if (2 * (to - from) > n) { std::swap(from, to); } // the shorter way round
  const auto steps = [&](std::size_t place) { return (place + n - from) % n; };
  std::pair<Index, double> best{-1, 0};
  for (std::size_t i = (from + 1) % n; i != to; i = (i + 1) % n)
  {
    const Index curve = m_sides[i].curve;
    if (curve < 0 || curve == c.sides[0].curve || curve == c.sides[1].curve || !(m_length[curve] > best.second))
    {
      continue;
    }
    // its other side is beyond
    if (steps(m_place[curve][!m_sides[i].is_forward]) > steps(to)) { best = {curve, m_length[curve]}; }
  }
  return best;
}

std::vector<Gap_graph::Node> Network_exchange::back_from(Gap_graph::Node n)
{
  std::vector<Gap_graph::Node> way;
  for (; n >= 0; n = m_graph.reached(n).from)
  {
    if (m_changed_edges.count(m_graph.gap(n).edge) > 0) { return {}; }
    way.push_back(n);
  }
  return way;
}

std::vector<Crossing> Network_exchange::steps_along(const std::vector<Gap_graph::Node>& way, std::size_t before,
                                                    Index between)
{
  const auto face_before = [&](Gap_graph::Node n) { return m_graph.face(m_graph.reached(n).region); };
  std::vector<Index> faces; // after each gap
  for (std::size_t i = 0; i + 1 < way.size(); ++i)
  {
    faces.push_back(i + 1 < before ? face_before(way[i + 1]) : i + 1 == before ? between : face_before(way[i]));
  }
  std::vector<Crossing> steps;
  for (std::size_t i = 0; i < way.size(); ++i)
  {
    const Gap& gap = m_graph.gap(way[i]);
    const Index e = gap.edge, o = m_surface.opposite[e];
    const Index h =
      i < faces.size() ? (m_surface.face(e) == faces[i] ? o : e) : (m_surface.face(e) == faces[i - 1] ? e : o);
    steps.push_back({h, gap.place, middle_of(m_curves, gap)});
  }
  return steps;
}

std::optional<Network_exchange::New_curve> Network_exchange::find_new_curve(const Candidate& c)
{
  std::vector<Gap_graph::Node> way = back_from(c.begin);
  const std::vector<Gap_graph::Node> rest = back_from(c.end);
  if (way.empty() || rest.empty()) { return std::nullopt; }
  const std::size_t before = way.size();
  std::reverse(way.begin(), way.end());
  way.insert(way.end(), rest.begin(), rest.end());
  New_curve curve;
  curve.roots = {m_roots[m_graph.reached(way.front()).root], m_roots[m_graph.reached(way.back()).root]};
  for (int k = 0; k < 2; ++k)
  {
    const Root& root = curve.roots[k];
    const Index u = root.crossing >= 0 ? free_vertex_beside(root.crossing) : root.vertex;
    if (u < 0 || m_changed_vertices.count(u) > 0) { return std::nullopt; }
    curve.ends[k] = u;
  }
  const auto [v, w] = curve.ends;
  if (v == w || (curve.roots[0].crossing >= 0 && curve.roots[0].crossing == curve.roots[1].crossing))
  {
    return std::nullopt;
  }
  const std::vector<Crossing> steps = steps_along(way, before, c.face);
  std::size_t first = 0, last = steps.size(); // what only leads round an end is left out
  while (first < last && touches(m_surface, steps[first].halfedge, v)) { ++first; }
  while (first < last && touches(m_surface, steps[last - 1].halfedge, w)) { --last; }
  curve.steps.assign(steps.begin() + first, steps.begin() + last);
  if (!is_clear(way) || !is_proper(curve)) { return std::nullopt; }
  return curve;
}

bool Network_exchange::is_clear(const std::vector<Gap_graph::Node>& way) const
{
  for (Gap_graph::Node n : way)
    for (Index u : {m_surface.source(m_graph.gap(n).edge), m_surface.target(m_graph.gap(n).edge)})
    {
      if (m_changed_vertices.count(u) > 0) { return false; }
    }
  return true;
}

bool Network_exchange::is_proper(const New_curve& curve) const
{
  const auto& steps = curve.steps;
  for (std::size_t i = 0; i < steps.size(); ++i)
  {
    for (Index u : curve.ends)
    {
      if (touches(m_surface, steps[i].halfedge, u)) { return false; }
    }
    if (i > 0 && m_surface.edge(steps[i].halfedge) == m_surface.edge(steps[i - 1].halfedge)) { return false; }
  }
  if (!steps.empty()) { return true; }
  const Index h = m_surface.find_halfedge(curve.ends[0], curve.ends[1]),
              g = h >= 0 ? h : m_surface.find_halfedge(curve.ends[1], curve.ends[0]);
  return g >= 0 && m_surface.opposite[g] >= 0;
}

void Network_exchange::note_change(Index curve, Changes& changes) const
{
  for (Index x : m_curves.crossings(curve)) { changes.edges.insert(m_curves.edge(x)); }
  if (m_curves.nearest({curve, false}) < 0) { changes.edges.insert(m_curves.edge_along(curve)); }
  for (bool is_last : {false, true}) { changes.vertices.insert(m_curves.vertex({curve, is_last})); }
}

void Network_exchange::note_removed(const New_curve& curve, Index old, Changes& changes) const
{
  std::set<Index> removed{old};
  for (const Root& root : curve.roots)
  {
    if (root.crossing >= 0) { removed.insert(m_curves[root.crossing].curve); }
  }
  for (bool is_last : {false, true})
    // or perhaps not
    for (const Network_end& e : m_curves.ends_at(m_curves.vertex({old, is_last}))) { removed.insert(e.curve); }
  for (Index c : removed) { note_change(c, changes); }
}

bool Network_exchange::put_in(const New_curve& curve)
{
  const auto [v, w] = curve.ends;
  if (curve.roots[0].crossing >= 0) { m_curves.split(curve.roots[0].crossing, v); }
  if (curve.roots[1].crossing >= 0)
  {
    if (free_vertex_beside(curve.roots[1].crossing) != w) { return false; }
    m_curves.split(curve.roots[1].crossing, w);
  }
  if (curve.steps.empty()
      && !m_curves.is_free(m_surface.edge(std::max(m_surface.find_halfedge(v, w), m_surface.find_halfedge(w, v)))))
  {
    return false;
  }
  m_curves.add(v, w, curve.steps);
  return true;
}

void Network_exchange::take_out(Index curve)
{
  const std::array<Index, 2> ends{m_curves.vertex({curve, false}), m_curves.vertex({curve, true})};
  m_curves.remove(curve);
  for (Index u : ends) { tidy_vertex(m_curves, u); }
}

double Network_exchange::tighten_from(Index known, const Tighten_options& options)
{
  double gain = 0;
  for (Index curve = 0; curve < known; ++curve)
  {
    if (m_length[curve] > 0 && !m_curves.is_open(curve)) { gain += m_length[curve]; }
  }
  for (Index curve = known; curve < m_curves.number_of_curves(); ++curve)
    if (m_curves.is_open(curve))
    {
      if (!is_disjoint(m_curves, curve)) { return 0; }
      tighten_curve(m_curves, curve, options);
      gain -= curve_length(m_curves, curve);
    }
  return gain;
}

bool Network_exchange::try_exchange(const Candidate& c, const Tighten_options& options)
{
  const auto [old, old_length] = longest_between(c);
  if (old < 0 || !(c.length < old_length)) { return false; }
  const std::optional<New_curve> replacement = find_new_curve(c);
  if (!replacement) { return false; }
  const Index known = m_curves.number_of_curves();
  Changes changes;
  note_removed(*replacement, old, changes);
  Normal_curves::Trial trial(m_curves);
  if (!put_in(*replacement)) { return false; }
  take_out(old);
  if (!(tighten_from(known, options) > 1e-9 * old_length)) { return false; }
  trial.keep();
  for (Index curve = 0; curve < known; ++curve)
  {
    if (!m_curves.is_open(curve)) { m_length[curve] = 0; }
  }
  for (Index curve = known; curve < m_curves.number_of_curves(); ++curve)
  {
    if (m_curves.is_open(curve)) { note_change(curve, changes); }
  }
  m_changed_edges.insert(changes.edges.begin(), changes.edges.end());
  m_changed_vertices.insert(changes.vertices.begin(), changes.vertices.end());
  walk();
  return true;
}

} // namespace internal

} // namespace meridian
