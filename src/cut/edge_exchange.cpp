// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/cut/internal/edge_exchange.h>

#include <meridian/base/exceptions.h>
#include <meridian/surface/distance_rings.h>

#include <algorithm>

namespace meridian {

namespace internal {

namespace {

constexpr double less = 1 - 1e-12; // rounding must not keep exchanges going

} // namespace

Edge_exchange::Edge_exchange(const Triangle_surface& s, std::vector<char>& is_cut)
  : m_surface(s), m_is_cut(is_cut), m_degree(s.number_of_vertices(), 0), m_side(s.number_of_halfedges(), -1),
    m_index(s.number_of_halfedges(), -1), m_local(s.number_of_vertices()), m_is_local(s.number_of_vertices(), 0)
{
  for (Index h = 0; h < s.number_of_halfedges(); ++h)
  {
    m_length.push_back(s.length(h));
    m_degree[s.source(h)] += is_cut[h];
    m_mean_length += m_length[h] / s.number_of_halfedges();
  }
}

int Edge_exchange::run()
{
  if (!begin()) { return 0; }
  grow();
  find_candidates();
  const int straightened = straighten_all();
  return straightened + exchange_all();
}

bool Edge_exchange::begin()
{
  Index first = -1, walls = 0, cut = 0;
  for (Index h = 0; h < m_surface.number_of_halfedges(); ++h)
  {
    if (!is_wall(h)) { continue; }
    ++walls;
    cut += m_is_cut[h];
    if (first < 0 && is_node(m_surface.source(h))) { first = h; }
  }
  if (cut == 0) { return false; }
  if (first < 0 || walk(first) != walls)
  {
    throw Invalid_input_error("exchange_in_edge_cut: the edges are no cut graph; more than a disc is left");
  }
  return true;
}

int Edge_exchange::straighten_all()
{
  const std::vector<Path> cells = collect_cells();
  int exchanged = 0;
  for (Index side = 0; side < static_cast<Index>(cells.size()); ++side)
  {
    if (m_sides[side].mate > side && !m_is_changed[side]) { exchanged += straighten(side, cells); }
  }
  return exchanged;
}

int Edge_exchange::exchange_all()
{
  std::vector<std::pair<double, Index>> order; // by what they gain
  for (const auto& [sides, c] : m_candidates)
  {
    const Path path = path_over(c.over);
    const Index side = path.empty() ? -1 : longest_replaced(path);
    if (side >= 0) { order.emplace_back(length(path) - m_sides[side].length, c.over); }
  }
  std::sort(order.begin(), order.end());
  int exchanged = 0;
  for (const auto& [gain, over] : order)
  {
    const Path path = path_over(over);
    const Index side = path.empty() ? -1 : longest_replaced(path);
    exchanged += side >= 0 && exchange(path, side);
  }
  return exchanged;
}

double Edge_exchange::length(const Path& path) const
{
  double sum = 0;
  for (Index h : path) { sum += m_length[h]; }
  return sum;
}

double Edge_exchange::length() const
{
  double sum = 0;
  for (Index h = 0; h < m_surface.number_of_halfedges(); ++h)
  {
    if (m_is_cut[h] && m_surface.edge(h) == h) { sum += m_length[h]; }
  }
  return sum;
}

bool Edge_exchange::is_node(Index v) const
{
  return m_degree[v] > 0 && (m_degree[v] != 2 || m_surface.is_boundary_vertex(v));
}

Index Edge_exchange::walk(Index first)
{
  m_sides.clear();
  m_order.clear();
  m_is_changed.clear();
  Index h = first, steps = 0;
  do {
    if (is_node(m_surface.source(h))) { m_order.push_back(add_side({}, -1)); }
    Side& side = m_sides.back();
    m_side[h] = m_order.back();
    m_index[h] = static_cast<Index>(side.halfedges.size());
    side.halfedges.push_back(h);
    side.length += m_length[h];
    ++steps;
    h = m_surface.next(h);
    while (!is_wall(h)) { h = m_surface.next(m_surface.opposite[h]); }
  } while (h != first);
  for (Side& side : m_sides)
  {
    const Index own = side.halfedges.front();
    if (m_is_cut[own]) { side.mate = m_side[m_surface.opposite[own]]; }
  }
  number_sides();
  return steps;
}

void Edge_exchange::number_sides()
{
  m_rank.resize(m_sides.size());
  for (std::size_t i = 0; i < m_order.size(); ++i) { m_rank[m_order[i]] = static_cast<Index>(i); }
}

Index Edge_exchange::corner(Index h) const
{
  while (!is_wall(h)) { h = m_surface.turn_right(h); }
  return h;
}

void Edge_exchange::grow()
{
  m_reached.assign(m_surface.number_of_vertices(), {});
  double farthest = 0; // from the rim: half the longest path
  for (const Side& side : m_sides) { farthest = std::max(farthest, side.mate < 0 ? 0 : side.length / 2); }
  Distance_rings rings(m_mean_length);
  const auto reach = [&](Index h, double distance, Index root) {
    const Index w = m_surface.target(h);
    const double length = distance + m_length[h];
    if (is_used(w) || !(length < m_reached[w].distance) || length > farthest) { return; }
    m_reached[w] = {length, h, root};
    rings.reach(length, w);
  };
  for (const Side& side : m_sides)
    for (Index h : side.halfedges)
      for (Index g = m_surface.turn_left(h); g >= 0 && !is_wall(g); g = m_surface.turn_left(g)) { reach(g, 0, g); }
  rings.search([&](Index v) { return m_reached[v].distance; },
               [&](Index v) {
                 const Reached here = m_reached[v];
                 m_surface.for_each_outgoing(v, [&](Index h) { reach(h, here.distance, here.root); });
               });
}

void Edge_exchange::find_candidates()
{
  m_candidates.clear();
  std::pair<Index, Index> last{-1, -1}; // two sides that touch do so along many edges
  Candidate* c = nullptr;
  for (Index h = 0; h < m_surface.number_of_halfedges(); ++h)
  {
    if (m_surface.edge(h) != h || is_wall(h)) { continue; }
    const Index root = first_of(h), other = first_of(m_surface.opposite[h]);
    if (root < 0 || other < 0 || root == other) { continue; }
    const std::pair<Index, Index> sides = std::minmax(m_side[corner(root)], m_side[corner(other)]);
    if (sides.first == sides.second) { continue; }
    if (sides != last) { c = &m_candidates[sides]; }
    last = sides;
    const double whole = distance_of(m_surface.source(h)) + m_length[h] + distance_of(m_surface.target(h));
    if (whole < c->length) { *c = {whole, h}; }
  }
}

std::vector<Edge_exchange::Path> Edge_exchange::collect_cells() const
{
  std::vector<Path> cells(m_sides.size());
  for (Index v = 0; v < m_surface.number_of_vertices(); ++v)
  {
    if (m_reached[v].root >= 0) { cells[m_side[corner(m_reached[v].root)]].push_back(v); }
  }
  return cells;
}

Index Edge_exchange::first_of(Index h) const
{
  const Index v = m_surface.source(h);
  return is_used(v) ? h : m_reached[v].root;
}

Index Edge_exchange::longest_replaced(const Path& path) const
{
  Place from = place(path.front()), to = place(m_surface.opposite[path.back()]);
  if (to.rank < from.rank) { std::swap(from, to); }
  Index best = -1;
  double longest = length(path) / less;
  for (Index i = from.rank + (from.index > 0); i < to.rank; ++i)
  {
    const Side& side = m_sides[m_order[i]];
    if (side.mate < 0 || !(side.length > longest)) { continue; }
    const Index mate = m_rank[side.mate];
    if (mate < from.rank || mate > to.rank || (mate == to.rank && to.index == 0))
    {
      best = m_order[i];
      longest = side.length;
    }
  }
  return best;
}

Edge_exchange::Path Edge_exchange::path_over(Index h) const
{
  Path path;
  const auto follow = [&](Index v) {
    for (; !is_used(v); v = m_surface.source(path.back()))
    {
      if (reached(v).by < 0) { return false; } // the way began on a path that is gone
      path.push_back(reached(v).by);
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

bool Edge_exchange::exchange(const Path& path, Index side)
{
  const Index mate = m_sides[side].mate;
  const Path old = m_sides[side].halfedges;
  set(old, false);
  if (!is_used(m_surface.source(path.front())) || !is_used(m_surface.target(path.back()))) // a loose end of the path
  {
    set(old, true);
    return false;
  }
  const Index from = corner(path.front()), to = corner(m_surface.opposite[path.back()]);
  split(from);
  split(to);
  // Without the path the rim falls into two; the way joins the one that it begins at with the one that it ends at.
  std::rotate(m_order.begin(), std::find(m_order.begin(), m_order.end(), side), m_order.end());
  const auto middle = std::find(m_order.begin(), m_order.end(), mate);
  std::vector<Index> first(m_order.begin() + 1, middle), second(middle + 1, m_order.end());
  if (std::find(first.begin(), first.end(), m_side[from]) == first.end()) { std::swap(first, second); }
  const auto begin = std::find(first.begin(), first.end(), m_side[from]),
             end = std::find(second.begin(), second.end(), m_side[to]);
  if (begin == first.end() || end == second.end())
  {
    set(old, true);
    number_sides();
    return false;
  }
  Path back;
  for (auto h = path.rbegin(); h != path.rend(); ++h) { back.push_back(m_surface.opposite[*h]); }
  const Index there = add_side(path, -1), here = add_side(back, there);
  m_sides[there].mate = here;
  m_is_changed[side] = m_is_changed[mate] = 1;
  std::rotate(first.begin(), begin, first.end());
  std::rotate(second.begin(), end, second.end());
  m_order = std::move(first);
  m_order.push_back(there);
  m_order.insert(m_order.end(), second.begin(), second.end());
  m_order.push_back(here);
  set(path, true);
  number_sides();
  tidy(m_surface.source(old.front()));
  tidy(m_surface.target(old.back()));
  return true;
}

bool Edge_exchange::straighten(Index side, const std::vector<Path>& cells)
{
  const Path old = m_sides[side].halfedges;
  Path own = cells[side];
  own.insert(own.end(), cells[m_sides[side].mate].begin(), cells[m_sides[side].mate].end());
  for (std::size_t i = 1; i < old.size(); ++i) { own.push_back(m_surface.source(old[i])); }
  set(old, false);
  if (!is_used(m_surface.source(old.front())) || !is_used(m_surface.target(old.back()))) // a loose end of the path
  {
    set(old, true);
    return false;
  }
  own.erase(std::remove_if(own.begin(), own.end(), [&](Index v) { return is_used(v); }), own.end());
  for (Index v : own)
  {
    m_is_local[v] = 1;
    m_local[v] = {};
  }
  const Candidate way = search_cells(side, own, less * m_sides[side].length);
  const Path path = way.over >= 0 ? path_over(way.over) : Path{};
  for (Index v : own) { m_is_local[v] = 0; }
  set(old, true);
  return !path.empty() && length(path) < less * m_sides[side].length && exchange(path, side);
}

Edge_exchange::Reached Edge_exchange::reached_beside(Index h) const
{
  const Index u = m_surface.target(h);
  if (is_used(u)) { return {0, -1, m_surface.opposite[h]}; }
  const Reached r = reached(u);
  return r.root < 0 || !is_used(m_surface.source(r.root)) || is_wall(r.root) ? Reached{} : r;
}

bool Edge_exchange::comes_from_between(Index root, Index side) const
{
  const Index at = m_rank[m_side[corner(root)]], a = m_rank[side], b = m_rank[m_sides[side].mate];
  return a < b ? a < at && at < b : at > a || at < b;
}

Edge_exchange::Candidate Edge_exchange::search_cells(Index side, const Path& cells, double limit)
{
  Candidate best{limit, -1};
  m_queue.clear();
  const auto reach = [&](Index v, const Reached& r) {
    if (!(r.distance < m_local[v].distance) || 2 * r.distance > best.length) { return; }
    m_local[v] = r;
    m_queue.reach(r.distance, v);
  };
  for (Index v : cells)
    m_surface.for_each_outgoing(v, [&](Index h) {
      if (m_is_local[m_surface.target(h)] || is_wall(h)) { return; }
      const Reached beside = reached_beside(h);
      if (beside.root >= 0) { reach(v, {beside.distance + m_length[h], m_surface.opposite[h], beside.root}); }
    });
  m_queue.search([&](double at, Index v) {
    const Reached here = m_local[v];
    if (at > here.distance) { return false; }
    const bool is_between = comes_from_between(here.root, side);
    m_surface.for_each_outgoing(v, [&](Index h) {
      if (is_wall(h)) { return; }
      const Index w = m_surface.target(h);
      if (m_is_local[w]) { reach(w, {at + m_length[h], h, here.root}); }
      const Reached there = reached_beside(h);
      if (m_is_local[w] && there.distance > at) { return; } // perhaps not reached for good
      const double length = at + m_length[h] + there.distance;
      if (there.root >= 0 && length < best.length && comes_from_between(there.root, side) != is_between)
      {
        best = {length, h};
      }
    });
    return false;
  });
  return best;
}

void Edge_exchange::set(const Path& path, bool is_cut)
{
  for (Index h : path)
  {
    m_is_cut[h] = m_is_cut[m_surface.opposite[h]] = is_cut;
    for (Index v : {m_surface.source(h), m_surface.target(h)}) { m_degree[v] += is_cut ? 1 : -1; }
  }
}

Index Edge_exchange::add_side(const Path& halfedges, Index mate)
{
  const auto side = static_cast<Index>(m_sides.size());
  m_sides.push_back({{}, mate, 0});
  m_is_changed.push_back(0);
  extend(side, halfedges);
  return side;
}

void Edge_exchange::extend(Index side, const Path& halfedges)
{
  for (Index h : halfedges)
  {
    m_side[h] = side;
    m_index[h] = static_cast<Index>(m_sides[side].halfedges.size());
    m_sides[side].halfedges.push_back(h);
    m_sides[side].length += m_length[h];
  }
}

void Edge_exchange::split(Index h)
{
  if (m_index[h] == 0) { return; }
  const Index side = m_side[h], mate = m_sides[side].mate;
  const auto size = static_cast<std::size_t>(m_index[h]);
  divide(side, size);
  if (mate >= 0)
  {
    divide(mate, m_sides[mate].halfedges.size() - size);
    // the second part of the mate; before it, that of the side
    const auto last = static_cast<Index>(m_sides.size()) - 1;
    m_sides[side].mate = last;
    m_sides[last].mate = side;
    m_sides[mate].mate = last - 1;
    m_sides[last - 1].mate = mate;
  }
  number_sides();
}

void Edge_exchange::divide(Index side, std::size_t size)
{
  m_is_changed[side] = 1;
  Path& all = m_sides[side].halfedges;
  const Path rest(all.begin() + size, all.end());
  all.resize(size);
  m_sides[side].length = length(all);
  const Index second = add_side(rest, -1);
  m_order.insert(std::find(m_order.begin(), m_order.end(), side) + 1, second);
}

void Edge_exchange::tidy(Index v)
{
  if (m_surface.is_boundary_vertex(v)) { return; }
  std::vector<Index> out;
  m_surface.for_each_outgoing(v, [&](Index h) {
    if (m_is_cut[h]) { out.push_back(h); }
  });
  if (out.size() == 1)
  {
    const Index side = m_side[out.front()], mate = m_sides[side].mate;
    const Path all = m_sides[side].halfedges;
    for (Index gone : {side, mate})
    {
      m_is_changed[gone] = 1;
      m_order.erase(std::find(m_order.begin(), m_order.end(), gone));
    }
    set(all, false);
    number_sides();
    return tidy(m_surface.target(all.back()));
  }
  if (out.size() != 2) { return; }
  const Index x = m_side[m_surface.opposite[out[0]]], y = m_side[out[1]];
  if (x == y || m_sides[x].mate == y) { return; } // one loop
  const Index x_mate = m_sides[x].mate, y_mate = m_sides[y].mate;
  append(x, y);
  append(y_mate, x_mate);
  m_sides[x].mate = y_mate;
  m_sides[y_mate].mate = x;
  number_sides();
}

void Edge_exchange::append(Index side, Index next)
{
  m_is_changed[side] = m_is_changed[next] = 1;
  extend(side, m_sides[next].halfedges);
  m_order.erase(std::find(m_order.begin(), m_order.end(), next));
}

} // namespace internal

} // namespace meridian
