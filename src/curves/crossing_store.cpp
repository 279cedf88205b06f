// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/curves/internal/crossing_store.h>

#include <meridian/base/exceptions.h>

#include <algorithm>

namespace meridian {

namespace internal {

const std::vector<Crossing_store::End>& Crossing_store::ends_at(Index v) const
{
  const auto found = m_ends.find(v);
  return found == m_ends.end() ? m_no_ends : found->second;
}

Index Crossing_store::along(Index edge) const
{
  const auto found = m_along.find(edge);
  return found == m_along.end() ? -1 : found->second;
}

std::vector<Crossing_store::Id> Crossing_store::crossings(Index curve) const
{
  std::vector<Id> all;
  const Id first = m_curves[curve].first;
  for (Id x = first; x >= 0;)
  {
    all.push_back(x);
    x = m_crossings[x].next;
    if (x == first) { break; }
  }
  return all;
}

void Crossing_store::reroute(Id first, Id last, const std::vector<Index>& halfedges, bool at_target)
{
  const Index curve = m_crossings[first].curve;
  const bool open = is_open(curve);
  const Id after = m_crossings[last].next;
  Id at = m_crossings[first].prev;
  for (Id x = first;; x = m_crossings[x].next)
  {
    unlist(x);
    if (x == last) { break; }
  }
  for (Index h : halfedges)
  {
    const Id x = append_at(h, curve, at_target);
    join(curve, at, x);
    at = x;
  }
  join(curve, at, after);
  if (!open) { edit_curve(curve).first = after; }
  else if (nearest({curve, false}) < 0) { lay_along(curve); }
}

void Crossing_store::extend(const End& end, Index to, const std::vector<Index>& halfedges, Index around)
{
  const Index curve = end.curve;
  if (nearest(end) < 0) { set_along(edge_along(curve), -1); }
  Id at = nearest(end);
  for (auto i = halfedges.rbegin(); i != halfedges.rend(); ++i)
  {
    const Index h = end.is_last ? m_surface.opposite[*i] : *i;
    const Id x = append_at(h, curve, m_surface.target(h) == around);
    if (end.is_last) { join(curve, at, x); }
    else { join(curve, x, at); }
    at = x;
    if (end.is_last) { join(curve, x, -1); }
    else { join(curve, -1, x); }
  }
  set_end(end, to);
  trim(end);
}

void Crossing_store::trim(const End& end)
{
  const Index v = vertex(end);
  for (Id x = nearest(end);
       x >= 0 && (m_surface.source(m_crossings[x].halfedge) == v || m_surface.target(m_crossings[x].halfedge) == v);
       x = nearest(end))
  {
    unlist(x);
    if (end.is_last) { join(end.curve, m_crossings[x].prev, -1); }
    else { join(end.curve, -1, m_crossings[x].next); }
  }
  if (nearest(end) < 0) { lay_along(end.curve); }
}

Index Crossing_store::edge_along(Index curve) const
{
  const Index from = vertex({curve, false}), to = vertex({curve, true});
  const Index h = m_surface.find_halfedge(from, to), g = h >= 0 ? h : m_surface.find_halfedge(to, from);
  if (g < 0) { throw Internal_error("edge_along: the ends of a curve are not joined by an edge"); }
  return m_surface.edge(g);
}

void Crossing_store::remove(Index curve)
{
  const auto ids = crossings(curve);
  clear(curve);
  for (Id x : ids) { unlist(x); }
}

bool Crossing_store::has_changed_beside(Index curve, std::uint64_t since) const
{
  const auto ends_changed = [&](Index v) {
    const auto found = m_ends_changed.find(v);
    return found != m_ends_changed.end() && found->second > since;
  };
  for (Id x : crossings(curve))
  {
    const Index h = m_crossings[x].halfedge;
    if (m_list_changed[m_slot[edge(x)]] > since) { return true; }
    if (m_any_ends_changed > since && (ends_changed(m_surface.source(h)) || ends_changed(m_surface.target(h))))
    {
      return true;
    }
  }
  return false;
}

Index Crossing_store::append_curve()
{
  m_curves.emplace_back();
  m_changed.push_back(++m_clock);
  note([this] {
    m_curves.pop_back();
    m_changed.pop_back();
  });
  return number_of_curves() - 1;
}

Crossing_store::Curve& Crossing_store::edit_curve(Index c)
{
  m_changed[c] = ++m_clock;
  note([this, c, old = m_curves[c]] {
    m_curves[c] = old;
    m_changed[c] = ++m_clock;
  });
  return m_curves[c];
}

Crossing_store::Chained_crossing& Crossing_store::edit(Id x)
{
  note([this, x, old = m_crossings[x]] { m_crossings[x] = old; });
  return m_crossings[x];
}

Crossing_store::Id Crossing_store::append(Index halfedge, Index curve, double t, Index place)
{
  m_changed[curve] = ++m_clock;
  const Id x = static_cast<Id>(m_crossings.size());
  m_crossings.push_back({{halfedge, -1, t}, curve, -1, -1});
  note([this] { m_crossings.pop_back(); });
  auto& list = edit_list(m_surface.edge(halfedge));
  list.insert(list.begin() + place, x);
  number(list, place);
  return x;
}

Crossing_store::Id Crossing_store::append_at(Index halfedge, Index curve, bool at_target)
{
  const Index e = m_surface.edge(halfedge);
  const bool at_end = at_target == (e == halfedge); // of the edge
  return append(halfedge, curve, at_end ? 1. : 0., at_end ? static_cast<Index>(on(e).size()) : 0);
}

void Crossing_store::unlist(Id x)
{
  m_changed[m_crossings[x].curve] = ++m_clock;
  auto& list = edit_list(edge(x));
  const Index place = m_crossings[x].place;
  list.erase(list.begin() + place);
  number(list, place);
}

void Crossing_store::join(Index curve, Id x, Id y)
{
  if (x >= 0) { edit(x).next = y; }
  else { edit_curve(curve).first = y; }
  if (y >= 0) { edit(y).prev = x; }
  else { edit_curve(curve).last = x; }
}

void Crossing_store::set_end(const End& e, Index v)
{
  const Index old = vertex(e);
  if (old >= 0) { edit_ends(old, e, false); }
  if (v >= 0) { edit_ends(v, e, true); }
  edit_curve(e.curve).ends[e.is_last] = v;
}

void Crossing_store::set_along(Index e, Index curve)
{
  note([this, e, old = along(e)] { put_along(e, old); });
  put_along(e, curve);
}

void Crossing_store::lay_along(Index curve)
{
  const Index e = edge_along(curve);
  if (!is_free(e) || m_surface.opposite[e] < 0)
  {
    throw Internal_error("Crossing_store: a curve runs along an edge that is not free");
  }
  set_along(e, curve);
}

void Crossing_store::link(Index curve, const std::vector<std::pair<Id, bool>>& chain, const std::array<Index, 2>& ends)
{
  Id at = -1;
  for (const auto& [x, is_turned] : chain)
  {
    Chained_crossing& crossing = edit(x);
    crossing.curve = curve;
    if (is_turned) { crossing.halfedge = m_surface.opposite[crossing.halfedge]; }
    join(curve, at, x);
    at = x;
  }
  join(curve, at, -1);
  for (bool is_last : {false, true}) { set_end({curve, is_last}, ends[is_last]); }
  trim({curve, false});
  if (nearest({curve, true}) >= 0) { trim({curve, true}); }
}

void Crossing_store::clear(Index curve)
{
  if (is_open(curve))
  {
    if (nearest({curve, false}) < 0) { set_along(edge_along(curve), -1); }
    for (bool is_last : {false, true}) { set_end({curve, is_last}, -1); }
  }
  edit_curve(curve) = Curve();
}

std::vector<Crossing_store::Id>& Crossing_store::edit_list(Index e)
{
  if (m_slot[e] < 0)
  {
    m_slot[e] = static_cast<Index>(m_lists.size());
    m_lists.emplace_back();
    m_list_changed.emplace_back();
  }
  auto& list = m_lists[m_slot[e]];
  m_list_changed[m_slot[e]] = ++m_clock;
  note([this, e, old = list] {
    m_lists[m_slot[e]] = old;
    m_list_changed[m_slot[e]] = ++m_clock;
    number(old, 0);
  });
  return list;
}

void Crossing_store::edit_ends(Index v, const End& e, bool is_new)
{
  auto& ends = m_ends[v];
  note_ends(v);
  note([this, v, old = ends] {
    m_ends[v] = old;
    note_ends(v);
  });
  if (is_new) { ends.push_back(e); }
  else { ends.erase(std::find(ends.begin(), ends.end(), e)); }
}

void Crossing_store::put_along(Index e, Index curve)
{
  if (curve < 0) { m_along.erase(e); }
  else { m_along[e] = curve; }
}

} // namespace internal

} // namespace meridian
