// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/cut/internal/edge_exchange.h>

#include <meridian/base/exceptions.h>
#include <meridian/surface/distance_rings.h>

#include <algorithm>

namespace meridian {

namespace internal {

namespace {

constexpr double less = 1 - 1e-6; // the rounding of lengths must not keep exchanges going

} // namespace

Edge_exchange::Edge_exchange(const Triangle_surface& s, std::vector<char>& is_cut)
  : m_surface(s), m_is_cut(is_cut), m_degree(s.number_of_vertices(), 0), m_side(s.number_of_halfedges(), -1),
    m_index(s.number_of_halfedges(), -1), m_local(s.number_of_vertices()), m_search(s.number_of_vertices(), 0)
{
  m_length.reserve(s.number_of_halfedges());
  for (Index h = 0; h < s.number_of_halfedges(); ++h)
  {
    m_length.push_back(static_cast<float>(s.length(h)));
    m_degree[s.source(h)] += is_cut[h];
    m_mean_length += m_length[h] / s.number_of_halfedges();
  }
}

int Edge_exchange::run()
{
  if (!begin()) { return 0; }
  grow();
  name_cells();
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
  int exchanged = 0;
  for (Index side = 0; side < static_cast<Index>(m_cells.size()); ++side)
  {
    const Index mate = m_sides[side].mate;
    if (mate > side && !m_is_changed[side] && !m_is_changed[mate] && (m_cells[side].is_new || m_cells[mate].is_new))
    {
      exchanged += straighten(side);
    }
  }
  return exchanged;
}

int Edge_exchange::exchange_all()
{
  std::vector<std::pair<double, Index>> order; // by what they gain
  for (const auto& [sides, c] : m_candidates)
  {
    number_sides();
    const Path path = path_over(c.over);
    const Index side = path.empty() ? -1 : longest_replaced(path);
    if (side >= 0) { order.emplace_back(length(path) - m_sides[side].length, c.over); }
  }
  std::sort(order.begin(), order.end());
  int exchanged = 0;
  for (const auto& [gain, over] : order)
  {
    number_sides();
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
  m_is_numbered = false;
  Index h = first, steps = 0;
  do {
    if (is_node(m_surface.source(h))) { m_order.push_back(add_side({}, -1)); }
    Side& side = m_sides.back();
    m_side[h] = m_order.back();
    for (Index g = m_surface.turn_left(h); g >= 0 && !is_wall(g); g = m_surface.turn_left(g)) { m_side[g] = m_side[h]; }
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
  return steps;
}

void Edge_exchange::number_sides()
{
  if (m_is_numbered) { return; }
  m_is_numbered = true;
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
  double farthest = 0; // from the rim: half the longest path
  for (const Side& side : m_sides) { farthest = std::max(farthest, side.mate < 0 ? 0 : side.length / 2); }
  const bool is_whole = farthest > m_farthest;
  m_farthest = std::max(m_farthest, farthest);
  m_is_new.assign(m_surface.number_of_vertices(), 0);
  Distance_rings rings(m_mean_length);
  const auto reach = [&](Index h, double distance, Index root) {
    const Index w = m_surface.target(h);
    const double length = distance + m_length[h];
    if (is_used(w) || !(length < m_reached[w].distance) || length > m_farthest) { return; }
    m_reached[w] = {length, h, root};
    m_is_new[w] = 1;
    rings.reach(length, w);
  };
  const auto leave_rim = [&](Index h) {
    for (Index g = m_surface.turn_left(h); g >= 0 && !is_wall(g); g = m_surface.turn_left(g)) { reach(g, 0, g); }
  };
  if (is_whole)
  {
    m_reached.assign(m_surface.number_of_vertices(), {});
    for (const Side& side : m_sides) { std::for_each(side.halfedges.begin(), side.halfedges.end(), leave_rim); }
  }
  else
  {
    for (Index v : forget_lost_ways())
      m_surface.for_each_outgoing(v, [&](Index h) {
        const Index u = m_surface.target(h), back = m_surface.opposite[h];
        if (is_used(u)) { reach(back, 0, back); }
        else if (m_reached[u].root >= 0) { reach(back, m_reached[u].distance, m_reached[u].root); }
      });
    for (Index h : m_exchanged)
    {
      if (is_wall(h)) { leave_rim(h); }
    }
  }
  m_exchanged.clear();
  rings.search([&](Index v) { return m_reached[v].distance; },
               [&](Index v) {
                 const Reached here = m_reached[v];
                 m_surface.for_each_outgoing(v, [&](Index h) { reach(h, here.distance, here.root); });
               });
}

Edge_exchange::Path Edge_exchange::forget_lost_ways()
{
  Path free;
  for (Index v = 0; v < m_surface.number_of_vertices(); ++v)
  {
    Reached& r = m_reached[v];
    if (!is_used(v) && r.root >= 0 && is_used(m_surface.source(r.root)) && !is_wall(r.root)) { continue; }
    m_is_new[v] = r.root >= 0 || !is_used(v);
    if (!is_used(v)) { free.push_back(v); }
    r = {};
  }
  return free;
}

void Edge_exchange::name_cells()
{
  m_cell.assign(m_surface.number_of_vertices(), -1);
  for (Index v = 0; v < m_surface.number_of_vertices(); ++v)
  {
    if (m_reached[v].root >= 0) { m_cell[v] = m_side[m_reached[v].root]; }
  }
}

void Edge_exchange::find_candidates()
{
  m_candidates.clear();
  m_cells.assign(m_sides.size(), {});
  std::pair<Index, Index> last{-1, -1}; // two sides that touch do so along many edges
  Candidate* c = nullptr;
  for (Index h = 0; h < m_surface.number_of_halfedges(); ++h)
  {
    if (m_surface.edge(h) != h || is_wall(h)) { continue; }
    const Index v = m_surface.source(h), w = m_surface.target(h), back = m_surface.opposite[h];
    const bool is_on_rim = is_used(v), ends_on_rim = is_used(w);
    const Index from = is_on_rim ? m_side[h] : m_cell[v], to = ends_on_rim ? m_side[back] : m_cell[w];
    if (from < 0 || to < 0) { continue; }
    if (m_is_new[v] || m_is_new[w]) { m_cells[from].is_new = m_cells[to].is_new = true; }
    if (!is_on_rim && (ends_on_rim || from != to)) { m_cells[from].border.push_back(h); }
    if (!ends_on_rim && (is_on_rim || from != to)) { m_cells[to].border.push_back(back); }
    if (from == to) { continue; }
    const std::pair<Index, Index> sides = std::minmax(from, to);
    if (sides != last) { c = &m_candidates[sides]; }
    last = sides;
    const double whole = distance_of(v) + m_length[h] + distance_of(w);
    if (whole < c->length) { *c = {whole, h}; }
  }
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
  if (!join_rims(side, m_side[from], m_side[to]))
  {
    set(old, true);
    return false;
  }
  Path back;
  for (auto h = path.rbegin(); h != path.rend(); ++h) { back.push_back(m_surface.opposite[*h]); }
  const Index there = add_side(path, -1), here = add_side(back, there);
  m_sides[there].mate = here;
  m_is_changed[side] = m_is_changed[mate] = 1;
  for (Index h : path)
  {
    const Index cell = m_cell[m_surface.target(h)];
    if (cell >= 0) { m_is_changed[cell] = 1; } // a part of it is cut off
  }
  set(path, true);
  for (const Path& all : {old, path}) { m_exchanged.insert(m_exchanged.end(), all.begin(), all.end()); }
  tidy(m_surface.source(old.front()));
  tidy(m_surface.target(old.back()));
  return true;
}

bool Edge_exchange::join_rims(Index side, Index from, Index to)
{
  number_sides();
  const auto n = static_cast<Index>(m_order.size());
  const auto after = [&](Index s) { return (m_rank[s] - m_rank[side] + n) % n; }; // along the rim, from the side on
  const Index middle = after(m_sides[side].mate), begin = after(from), end = after(to);
  if (begin == 0 || end == 0 || begin == middle || end == middle || (begin < middle) == (end < middle))
  {
    return false;
  }
  std::vector<Index> order;
  order.reserve(n);
  const auto add = [&](Index first, Index last) { // the sides between two places, counted from the path's on
    const auto at = m_order.begin() + m_rank[side];
    const Index turn = n - m_rank[side]; // the place of the first side of all
    if (first < turn) { order.insert(order.end(), at + first, at + std::min(last, turn)); }
    if (last > turn) { order.insert(order.end(), at + (std::max(first, turn) - n), at + (last - n)); }
  };
  const auto add_rim = [&](Index first) { // one of the two, from there on
    add(first, first < middle ? middle : n);
    add(first < middle ? 1 : middle + 1, first);
  };
  const auto way = static_cast<Index>(m_sides.size());
  add_rim(begin);
  order.push_back(way);
  add_rim(end);
  order.push_back(way + 1);
  m_order = std::move(order);
  m_is_numbered = false;
  return true;
}

bool Edge_exchange::straighten(Index side)
{
  number_sides();
  const Path old = m_sides[side].halfedges;
  set(old, false);
  if (!is_used(m_surface.source(old.front())) || !is_used(m_surface.target(old.back()))) // a loose end of the path
  {
    set(old, true);
    return false;
  }
  m_taken_out = {side, m_sides[side].mate};
  ++m_searches;
  for (std::size_t i = 1; i < old.size(); ++i) { m_cell[m_surface.source(old[i])] = side; }
  const Candidate way = search_cells(side, less * m_sides[side].length);
  const Path path = way.over >= 0 ? path_over(way.over) : Path{};
  for (std::size_t i = 1; i < old.size(); ++i) { m_cell[m_surface.source(old[i])] = -1; }
  m_taken_out = {-2, -2};
  set(old, true);
  return !path.empty() && length(path) < less * m_sides[side].length && exchange(path, side);
}

Edge_exchange::Reached Edge_exchange::reached(Index v) const
{
  if (!is_free(v)) { return m_reached[v]; }
  return m_search[v] == m_searches ? m_local[v] : Reached();
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

Edge_exchange::Candidate Edge_exchange::search_cells(Index side, double limit)
{
  Candidate best{limit, -1};
  m_queue.clear();
  const auto reach = [&](Index v, const Reached& r) {
    if (!(r.distance < reached(v).distance) || 2 * r.distance > best.length) { return; }
    m_local[v] = r;
    m_search[v] = m_searches;
    m_queue.reach(r.distance, v);
  };
  const auto enter = [&](Index h) { // over a halfedge that leaves the cells
    if (is_wall(h) || is_free(m_surface.target(h))) { return; }
    const Reached beside = reached_beside(h);
    if (beside.root < 0) { return; }
    reach(m_surface.source(h), {beside.distance + m_length[h], m_surface.opposite[h], beside.root});
  };
  for (Index s : {side, m_sides[side].mate})
  {
    std::for_each(m_cells[s].border.begin(), m_cells[s].border.end(), enter);
  }
  const Path& old = m_sides[side].halfedges;
  for (std::size_t i = 1; i < old.size(); ++i) { m_surface.for_each_outgoing(m_surface.source(old[i]), enter); }
  m_queue.search([&](double at, Index v) {
    const Reached here = m_local[v];
    if (at > here.distance) { return false; }
    const bool is_between = comes_from_between(here.root, side);
    m_surface.for_each_outgoing(v, [&](Index h) {
      if (is_wall(h)) { return; }
      const Index w = m_surface.target(h);
      const bool is_inside = is_free(w);
      if (is_inside) { reach(w, {at + m_length[h], h, here.root}); }
      const Reached there = reached_beside(h);
      if (is_inside && there.distance > at) { return; } // perhaps not reached for good
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
  m_is_numbered = false;
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
    m_exchanged.insert(m_exchanged.end(), all.begin(), all.end());
    m_is_numbered = false;
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
  m_is_numbered = false;
}

void Edge_exchange::append(Index side, Index next)
{
  m_is_changed[side] = m_is_changed[next] = 1;
  extend(side, m_sides[next].halfedges);
  m_order.erase(std::find(m_order.begin(), m_order.end(), next));
}

} // namespace internal

} // namespace meridian
