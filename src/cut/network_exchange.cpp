// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/cut/internal/network_exchange.h>

#include <meridian/base/exceptions.h>
#include <meridian/curves/sleeve.h>
#include <meridian/cut/internal/network_moves.h>

#include <algorithm>
#include <queue>
#include <string>
#include <tuple>

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

Network_exchange::Reached& Network_exchange::reached(const Gap& g)
{
  Reached& r = m_curves.on(g.edge).empty()
                 ? m_plain[g.edge]
                 : m_crowded[static_cast<std::uint64_t>(g.edge) << 32 | static_cast<std::uint32_t>(g.place)];
  if (r.run != m_run)
  {
    r = Reached{};
    r.run = m_run;
  }
  return r;
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
  ++m_run;
  m_crowded.clear();
  m_roots.clear();
  m_candidates.clear();
  using Entry = std::tuple<double, Index, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  const auto start = [&](const Gap& g, double d, const Root& root) {
    if (m_surface.opposite[g.edge] < 0 || m_curves.along(g.edge) >= 0) { return; }
    Reached& r = reached(g);
    if (!(d < r.distance)) { return; }
    r.distance = d;
    r.root = static_cast<Index>(m_roots.size());
    m_roots.push_back(root);
    queue.emplace(d, g.edge, g.place);
  };
  const auto start_at_vertex = [&](Index v, const std::vector<Index>& spokes, std::size_t side) {
    for (Index h : spokes)
    {
      const Index e = m_surface.edge(h);
      const Gap g{e, e == h ? 0 : static_cast<Index>(m_curves.on(e).size())};
      start(g, distance(m_surface.points[v], point(g)), {v, -1, side});
    }
  };
  std::unordered_map<Index, Network_star> stars;
  for (std::size_t i = 0; i < m_sides.size(); ++i)
  {
    const Disc_side& side = m_sides[i];
    if (side.curve >= 0)
      for (Index x : m_curves.crossings(side.curve))
      {
        if (free_vertex_beside(x) >= 0) { start(m_curves.beside(x, side.is_forward), 0, {-1, x, i}); }
      }
    else
    {
      const Disc_side& before = m_sides[(i + m_sides.size() - 1) % m_sides.size()];
      for (Index v = m_surface.target(m_surface.outgoing[before.corner]); v != side.corner;
           v = m_surface.target(m_surface.outgoing[v]))
      {
        std::vector<Index> spokes;
        m_surface.for_each_outgoing(v, [&](Index h) { spokes.push_back(h); });
        start_at_vertex(v, spokes, i);
      }
    }
    const Disc_side& next = m_sides[(i + 1) % m_sides.size()]; // the corner between this side and the next
    const auto [known, is_new] = stars.try_emplace(side.corner);
    if (is_new) { known->second = make_star(m_curves, side.corner); }
    const Network_star& star = known->second;
    const auto arm_of = [&](const Disc_side& of, bool is_last) {
      return std::find_if(star.arms.begin(), star.arms.end(), [&](const auto& arm) {
        return arm.end == Network_end{of.curve, is_last};
      });
    };
    const auto here = side.curve >= 0 ? arm_of(side, side.is_forward) : star.arms.end();
    const auto there = next.curve >= 0 ? arm_of(next, !next.is_forward) : star.arms.end();
    const Index to = here != star.arms.end() ? here->at : static_cast<Index>(2 * star.spokes.size());
    const Index from = there != star.arms.end() ? there->at : 0;
    if (from == to && there < here) { continue; } // both leave through one corner
    start_at_vertex(side.corner, spokes_between(star, from, to), i);
  }
  // no way longer than this is of use
  const double farthest = m_length.empty() ? 0 : *std::max_element(m_length.begin(), m_length.end());
  while (!queue.empty())
  {
    const Gap gap{std::get<1>(queue.top()), std::get<2>(queue.top())};
    queue.pop();
    if (reached(gap).is_done) { continue; }
    reached(gap).is_done = true;
    const Reached here = reached(gap);
    const Point from = point(gap);
    for (Index h : {gap.edge, m_surface.opposite[gap.edge]})
    {
      const Index face = m_surface.face(h);
      m_curves.for_each_gap_around(gap, face, [&](const Gap& to, Index) {
        if (m_surface.opposite[to.edge] < 0 || m_curves.along(to.edge) >= 0 || to == gap) { return; }
        Reached& there = reached(to);
        const double d = here.distance + distance(from, point(to));
        if (there.is_done)
        {
          const std::size_t a = m_roots[here.root].side, b = m_roots[there.root].side;
          if (a == b || here.face == face || there.face == face) { return; } // the way would turn back
          Candidate& c = m_candidates[{std::min(a, b), std::max(a, b)}];
          if (d + there.distance < c.length)
          {
            c = {d + there.distance, gap, to, face, {known_as(here.root), known_as(there.root)}};
          }
          return;
        }
        if (here.face == face || !(d < there.distance) || d > farthest) { return; }
        there = {d, gap, face, here.root, m_run, false};
        queue.emplace(d, to.edge, to.place);
      });
    }
  }
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

std::vector<Network_exchange::Gap> Network_exchange::back_from(Gap g)
{
  std::vector<Gap> way;
  for (; g.edge >= 0; g = reached(g).from)
  {
    if (m_changed_edges.count(g.edge) > 0) { return {}; }
    way.push_back(g);
  }
  return way;
}

bool Network_exchange::try_exchange(const Candidate& c, const Tighten_options& options)
{
  const auto [old, old_length] = longest_between(c);
  if (old < 0 || !(c.length < old_length)) { return false; }
  std::vector<Gap> way = back_from(c.gap);
  const std::vector<Gap> rest = back_from(c.to);
  if (way.empty() || rest.empty()) { return false; }
  std::reverse(way.begin(), way.end());
  way.insert(way.end(), rest.begin(), rest.end());
  const Root root_1 = m_roots[reached(way.front()).root], root_2 = m_roots[reached(way.back()).root];
  const Index v = root_1.crossing >= 0 ? free_vertex_beside(root_1.crossing) : root_1.vertex;
  const Index w = root_2.crossing >= 0 ? free_vertex_beside(root_2.crossing) : root_2.vertex;
  for (Index u : {v, w})
  {
    if (u < 0 || m_changed_vertices.count(u) > 0) { return false; }
  }
  if (v == w || (root_1.crossing >= 0 && root_1.crossing == root_2.crossing)) { return false; }

  // The faces between gaps tell the halfedges. What only leads round an end is left out.
  std::vector<Normal_curves::Step> steps;
  std::vector<Index> faces; // after each gap
  for (std::size_t i = 0; i + 1 < way.size(); ++i)
  {
    const bool in_first = i + 1 < way.size() - rest.size();
    faces.push_back(in_first                            ? reached(way[i + 1]).face
                    : i + 1 == way.size() - rest.size() ? c.face
                                                        : reached(way[i]).face);
  }
  for (std::size_t i = 0; i < way.size(); ++i)
  {
    const Index e = way[i].edge, o = m_surface.opposite[e];
    const Index h =
      i < faces.size() ? (m_surface.face(e) == faces[i] ? o : e) : (m_surface.face(e) == faces[i - 1] ? e : o);
    steps.push_back({h, way[i].place, m_curves.middle(way[i])});
  }
  std::size_t first = 0, last = steps.size();
  while (first < last && touches(m_surface, steps[first].halfedge, v)) { ++first; }
  while (first < last && touches(m_surface, steps[last - 1].halfedge, w)) { --last; }
  steps = {steps.begin() + first, steps.begin() + last};
  for (const Gap& g : way) // an exchange before this one may have put a curve's end in the way
    for (Index u : {m_surface.source(g.edge), m_surface.target(g.edge)})
    {
      if (m_changed_vertices.count(u) > 0) { return false; }
    }
  for (std::size_t i = 0; i < steps.size(); ++i)
  {
    for (Index u : {v, w})
    {
      if (touches(m_surface, steps[i].halfedge, u)) { return false; }
    }
    if (i > 0 && m_surface.edge(steps[i].halfedge) == m_surface.edge(steps[i - 1].halfedge)) { return false; }
  }
  if (steps.empty())
  {
    const Index h = m_surface.find_halfedge(v, w), g = h >= 0 ? h : m_surface.find_halfedge(w, v);
    if (g < 0 || m_surface.opposite[g] < 0) { return false; }
  }

  const Index known = m_curves.number_of_curves();
  std::set<Index> removed{old}, edges, vertices;
  const auto note = [&](Index curve) {
    for (Index x : m_curves.crossings(curve)) { edges.insert(m_curves.edge(x)); }
    if (m_curves.nearest({curve, false}) < 0) { edges.insert(m_curves.edge_along(curve)); }
    for (bool is_last : {false, true}) { vertices.insert(m_curves.vertex({curve, is_last})); }
  };
  for (const Root& root : {root_1, root_2})
  {
    if (root.crossing >= 0) { removed.insert(m_curves[root.crossing].curve); }
  }
  for (bool is_last : {false, true})
    // or perhaps not
    for (const Network_end& e : m_curves.ends_at(m_curves.vertex({old, is_last}))) { removed.insert(e.curve); }
  for (Index curve : removed) { note(curve); }
  Normal_curves::Trial trial(m_curves);
  if (root_1.crossing >= 0) { m_curves.split(root_1.crossing, v); }
  if (root_2.crossing >= 0)
  {
    if (free_vertex_beside(root_2.crossing) != w) { return false; }
    m_curves.split(root_2.crossing, w);
  }
  if (steps.empty()
      && !m_curves.is_free(m_surface.edge(std::max(m_surface.find_halfedge(v, w), m_surface.find_halfedge(w, v)))))
  {
    return false;
  }
  m_curves.add(v, w, steps);
  const std::array<Index, 2> ends{m_curves.vertex({old, false}), m_curves.vertex({old, true})};
  m_curves.remove(old);
  for (Index u : ends) { tidy_vertex(m_curves, u); }
  double gain = 0;
  for (Index curve = 0; curve < known; ++curve)
  {
    if (m_length[curve] > 0 && !m_curves.is_open(curve)) { gain += m_length[curve]; }
  }
  for (Index curve = known; curve < m_curves.number_of_curves(); ++curve)
    if (m_curves.is_open(curve))
    {
      if (!m_curves.is_disjoint(curve)) { return false; }
      tighten_curve(m_curves, curve, options);
      gain -= curve_length(m_curves, curve);
    }
  if (!(gain > 1e-9 * old_length)) { return false; }
  trial.keep();
  for (Index curve = 0; curve < known; ++curve)
  {
    if (!m_curves.is_open(curve)) { m_length[curve] = 0; }
  }
  for (Index curve = known; curve < m_curves.number_of_curves(); ++curve)
  {
    if (m_curves.is_open(curve)) { note(curve); }
  }
  m_changed_edges.insert(edges.begin(), edges.end());
  m_changed_vertices.insert(vertices.begin(), vertices.end());
  walk();
  return true;
}

} // namespace internal

} // namespace meridian
