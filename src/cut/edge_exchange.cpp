// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/cut/internal/edge_exchange.h>

#include <meridian/base/exceptions.h>

#include <algorithm>

namespace meridian {

namespace internal {

namespace {

constexpr double less = 1 - 1e-12; // rounding must not keep exchanges going

} // namespace

Edge_exchange::Edge_exchange(const Triangle_surface& s, std::vector<char>& is_cut)
  : m_surface(s), m_is_cut(is_cut), m_degree(s.number_of_vertices(), 0), m_place(s.number_of_halfedges(), -1)
{
  for (Index h = 0; h < s.number_of_halfedges(); ++h) { m_degree[s.source(h)] += is_cut[h]; }
}

int Edge_exchange::run()
{
  if (!walk()) { return 0; }
  grow();
  std::vector<std::pair<double, Index>> order; // by what they gain
  for (const auto& [sides, c] : m_candidates)
  {
    const Index side = longest_between(begin_of(c.over), begin_of(m_surface.opposite[c.over]));
    if (side >= 0 && c.length < less * m_sides[side].length)
    {
      order.emplace_back(c.length - m_sides[side].length, c.over);
    }
  }
  std::sort(order.begin(), order.end());
  int exchanged = 0;
  for (const auto& [gain, over] : order) { exchanged += try_exchange(over); }
  return exchanged;
}

bool Edge_exchange::is_node(Index v) const
{
  return m_degree[v] > 0 && (m_degree[v] != 2 || m_surface.is_boundary_vertex(v));
}

bool Edge_exchange::walk()
{
  Index first = -1, walls = 0;
  for (Index h = 0; h < m_surface.number_of_halfedges(); ++h)
  {
    if (!is_wall(h)) { continue; }
    ++walls;
    if (first < 0 && is_node(m_surface.source(h))) { first = h; }
  }
  if (first < 0) { return false; }
  m_rim.clear();
  Index h = first;
  do {
    for (Index g = h; g >= 0 && (g == h || !is_wall(g)); g = m_surface.turn_left(g))
    {
      m_place[g] = static_cast<Index>(m_rim.size());
    }
    m_rim.push_back(h);
    h = m_surface.next(h);
    while (!is_wall(h)) { h = m_surface.next(m_surface.opposite[h]); }
  } while (h != first);
  if (static_cast<Index>(m_rim.size()) != walls)
  {
    throw Invalid_input_error("the edges are no cut graph; more than a disc is left");
  }
  find_sides();
  return true;
}

void Edge_exchange::find_sides()
{
  m_sides.clear();
  m_side.clear();
  for (Index h : m_rim)
  {
    const auto place = static_cast<Index>(m_side.size());
    if (is_node(m_surface.source(h))) { m_sides.push_back({place, place, -1, 0}); }
    m_side.push_back(static_cast<Index>(m_sides.size()) - 1);
    m_sides.back().end = place + 1;
    m_sides.back().length += m_surface.length(h);
  }
  for (Side& side : m_sides)
  {
    const Index h = m_rim[side.begin];
    if (m_is_cut[h]) { side.mate = m_side[m_place[m_surface.opposite[h]]]; }
  }
}

void Edge_exchange::grow()
{
  m_reached.assign(m_surface.number_of_vertices(), {});
  m_candidates.clear();
  m_queue.clear();
  double farthest = 0; // from the rim: half the longest path
  for (const Side& side : m_sides) { farthest = std::max(farthest, side.mate < 0 ? 0 : side.length / 2); }
  for (Index h : m_rim)
  {
    for (Index g = m_surface.turn_left(h); g >= 0 && !is_wall(g); g = m_surface.turn_left(g))
    {
      take(g, 0, g, farthest);
    }
  }
  m_queue.search([&](double at, Index v) {
    if (at > m_reached[v].distance) { return false; }
    m_surface.for_each_outgoing(v, [&](Index h) { take(h, at, m_reached[v].root, farthest); });
    return false;
  });
}

void Edge_exchange::take(Index h, double distance, Index root, double farthest)
{
  const Index w = m_surface.target(h);
  const double length = distance + m_surface.length(h);
  Reached& there = m_reached[w];
  if (is_used(w) || there.distance <= distance) // reached for good
  {
    const Index a = m_side[m_place[root]], b = m_side[begin_of(m_surface.opposite[h])];
    if (a == b) { return; }
    Candidate& c = m_candidates[std::minmax(a, b)];
    const double whole = length + (is_used(w) ? 0 : there.distance);
    if (whole < c.length) { c = {whole, h}; }
  }
  else if (length < there.distance && length <= farthest)
  {
    there = {length, h, root};
    m_queue.reach(length, w);
  }
}

Index Edge_exchange::begin_of(Index h) const
{
  const Index v = m_surface.source(h);
  return m_place[is_used(v) ? h : m_reached[v].root];
}

Index Edge_exchange::longest_between(Index from, Index to) const
{
  if (from > to) { std::swap(from, to); }
  Index best = -1;
  for (Index i = m_side[from] + (m_sides[m_side[from]].begin < from); i <= m_side[to] && m_sides[i].end <= to; ++i)
  {
    const Side& side = m_sides[i];
    if (side.mate < 0 || (best >= 0 && side.length <= m_sides[best].length)) { continue; }
    const Side& mate = m_sides[side.mate];
    if (mate.end <= from || mate.begin >= to) { best = i; }
  }
  return best;
}

Edge_exchange::Path Edge_exchange::path_over(Index h) const
{
  Path path;
  const auto follow = [&](Index v) {
    for (; !is_used(v); v = m_surface.source(path.back()))
    {
      if (m_reached[v].by < 0) { return false; } // the way began on a path that is gone
      path.push_back(m_reached[v].by);
    }
    return true;
  };
  if (is_wall(h) || !follow(m_surface.source(h))) { return {}; }
  std::reverse(path.begin(), path.end());
  const auto before = path.size();
  if (!follow(m_surface.target(h))) { return {}; }
  for (auto i = path.begin() + before; i != path.end(); ++i) { *i = m_surface.opposite[*i]; }
  path.insert(path.begin() + before, h);
  return path;
}

bool Edge_exchange::try_exchange(Index over)
{
  const Path path = path_over(over);
  if (path.empty()) { return false; }
  double length = 0;
  for (Index h : path) { length += m_surface.length(h); }
  const Index side = longest_between(m_place[path.front()], m_place[m_surface.opposite[path.back()]]);
  if (side < 0 || !(length < less * m_sides[side].length)) { return false; }
  const Path old(m_rim.begin() + m_sides[side].begin, m_rim.begin() + m_sides[side].end);
  for (Index h : old) { set(h, false); }
  for (Index h : path) { set(h, true); }
  prune(m_surface.source(old.front()));
  prune(m_surface.target(old.back()));
  walk();
  return true;
}

void Edge_exchange::set(Index h, bool is_cut)
{
  m_is_cut[h] = m_is_cut[m_surface.opposite[h]] = is_cut;
  for (Index v : {m_surface.source(h), m_surface.target(h)}) { m_degree[v] += is_cut ? 1 : -1; }
}

void Edge_exchange::prune(Index v)
{
  while (m_degree[v] == 1 && !m_surface.is_boundary_vertex(v))
  {
    Index out = -1;
    m_surface.for_each_outgoing(v, [&](Index h) { out = m_is_cut[h] ? h : out; });
    set(out, false);
    v = m_surface.target(out);
  }
}

} // namespace internal

} // namespace meridian
