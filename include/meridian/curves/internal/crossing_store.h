// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CURVES_INTERNAL_CROSSING_STORE_H
#define MERIDIAN_CURVES_INTERNAL_CROSSING_STORE_H

#include <meridian/surface/Triangle_surface.h>

#include <functional>
#include <unordered_map>
#include <vector>

namespace meridian {
namespace internal {

// Curves as chains of crossings with edges, an order of the crossings on every edge, and the ends of open curves at
// vertices. Every change can be taken back: see Trial.
class Crossing_store
{
public:
  using Id = Index; ///< of a crossing

  /// a crossing of a curve with an edge.
  struct Crossing
  {
    Index halfedge; ///< by which the curve leaves a face
    Index curve;
    Id prev, next; ///< along the curve; -1 where an open curve ends
    double t;      ///< fraction along the edge `surface().edge(halfedge)`
    Index place;   ///< among the crossings of the edge
  };
  /// an end of an open curve.
  struct End
  {
    Index curve;
    bool is_last; ///< whether the curve runs to it
    bool operator==(const End& e) const { return curve == e.curve && is_last == e.is_last; }
  };

  Crossing_store(const Triangle_surface& surface, Index curves)
    : m_surface(surface), m_curves(curves), m_slot(surface.number_of_halfedges(), -1)
  {}

  const Triangle_surface& surface() const { return m_surface; }
  Index number_of_curves() const { return static_cast<Index>(m_curves.size()); }
  bool is_present(Index curve) const { return m_curves[curve].first >= 0 || is_open(curve); }
  bool is_open(Index curve) const { return m_curves[curve].ends[0] >= 0; }
  /// \returns the vertex at an end of an open curve
  Index vertex(const End& e) const { return m_curves[e.curve].ends[e.is_last]; }
  /// \returns the curves' ends at a vertex, in no order that means anything
  const std::vector<End>& ends_at(Index v) const
  {
    const auto found = m_ends.find(v);
    return found == m_ends.end() ? m_no_ends : found->second;
  }
  bool has_open_curves() const { return !m_ends.empty(); }
  /// \returns the curve that runs along an edge from end to end without a crossing, or -1
  Index along(Index edge) const
  {
    const auto found = m_along.find(edge);
    return found == m_along.end() ? -1 : found->second;
  }
  const Crossing& operator[](Id x) const { return m_crossings[x]; }
  Index edge(Id x) const { return m_surface.edge(m_crossings[x].halfedge); }
  void move(Id x, double t) { edit(x).t = t; }
  /// \returns the crossings of an edge, from the source of `edge` to its target
  const std::vector<Id>& on(Index edge) const { return m_slot[edge] < 0 ? m_none : m_lists[m_slot[edge]]; }
  /// \returns whether nothing crosses an edge and nothing runs along it
  bool is_free(Index edge) const { return on(edge).empty() && along(edge) < 0; }
  /// \returns the crossing nearest to an end of an open curve, or -1 if it runs along an edge
  Id nearest(const End& e) const { return e.is_last ? m_curves[e.curve].last : m_curves[e.curve].first; }
  /// \returns the crossings of a curve, in order
  std::vector<Id> crossings(Index curve) const
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

  /// replaces the crossings from `first` to `last` of one curve by others, each at an end of its edge: at the target of
  /// its halfedge if `at_target` is set, at the source otherwise.
  void reroute(Id first, Id last, const std::vector<Index>& halfedges, bool at_target)
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
  /// moves an end of an open curve to vertex `to`: from there the curve crosses `halfedges`, near to vertex `around`,
  /// on its way to what is left of it. The halfedges are those by which it leaves faces on its way from `to`. What
  /// leads round `to` alone is left out.
  void extend(const End& end, Index to, const std::vector<Index>& halfedges, Index around)
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
  /// leaves out the crossings next to an end that only lead round its vertex.
  void trim(const End& end)
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
  /// \returns the edge that an open curve without crossings runs along
  Index edge_along(Index curve) const
  {
    const Index from = vertex({curve, false}), to = vertex({curve, true});
    const Index h = m_surface.find_halfedge(from, to), g = h >= 0 ? h : m_surface.find_halfedge(to, from);
    if (g < 0) { throw Internal_error("edge_along: the ends of a curve are not joined by an edge"); }
    return m_surface.edge(g);
  }
  /// joins two curves that end at one vertex, and passes it: the new curve crosses `halfedges`, near to the vertex, on
  /// its way from the first to the second.
  /// \returns the new curve
  Index splice(const End& from, const End& to, const std::vector<Index>& halfedges)
  {
    const Index v = vertex(from);
    std::vector<std::pair<Id, bool>> chain; // crossings, and whether they are turned over
    const auto take = [&](Index curve, bool is_turned) {
      auto ids = crossings(curve);
      if (is_turned) { std::reverse(ids.begin(), ids.end()); }
      for (Id x : ids) { chain.emplace_back(x, is_turned); }
    };
    const Index curve = append_curve();
    take(from.curve, !from.is_last);
    for (Index h : halfedges) { chain.emplace_back(append_at(h, curve, m_surface.target(h) == v), false); }
    const std::size_t size = chain.size();
    take(to.curve, to.is_last);
    std::size_t same = 0; // crossings that the two have in common next to the vertex, if no halfedge is between them
    while (halfedges.empty() && same < size && size + same < chain.size()
           && edge(chain[size - 1 - same].first) == edge(chain[size + same].first))
    {
      ++same;
    }
    for (std::size_t i = size - same; i < size + same; ++i) { unlist(chain[i].first); }
    chain.erase(chain.begin() + (size - same), chain.begin() + (size + same));
    const std::array<Index, 2> ends{vertex({from.curve, !from.is_last}), vertex({to.curve, !to.is_last})};
    for (Index old : {from.curve, to.curve}) { clear(old); }
    link(curve, chain, ends);
    return curve;
  }
  /// parts a curve at crossing `x`, which is the nearest of its edge to vertex `v`: both parts end there.
  /// \returns the parts
  std::array<Index, 2> split(Id x, Index v)
  {
    const Index old = m_crossings[x].curve;
    const std::array<Index, 2> ends = m_curves[old].ends;
    std::array<std::vector<std::pair<Id, bool>>, 2> chain;
    int part = 0;
    for (Id y : crossings(old))
    {
      if (y == x) { part = 1; }
      else { chain[part].emplace_back(y, false); }
    }
    clear(old);
    unlist(x);
    const Index first = append_curve(), second = append_curve();
    link(first, chain[0], {ends[0], v});
    link(second, chain[1], {v, ends[1]});
    return {first, second};
  }
  void remove(Index curve)
  {
    const auto ids = crossings(curve);
    clear(curve);
    for (Id x : ids) { unlist(x); }
  }

  /// what is done while a trial lives is taken back at its end, unless it is kept. Trials may be nested.
  class Trial
  {
  public:
    explicit Trial(Crossing_store& store) : m_store(store), m_mark(store.m_undo.size()) { ++store.m_trials; }
    Trial(const Trial&) = delete;
    Trial& operator=(const Trial&) = delete;
    void keep() { m_is_kept = true; }
    ~Trial()
    {
      --m_store.m_trials;
      const int outer = std::exchange(m_store.m_trials, 0); // what is taken back is not noted
      for (; !m_is_kept && m_store.m_undo.size() > m_mark; m_store.m_undo.pop_back()) { m_store.m_undo.back()(); }
      m_store.m_trials = outer;
      if (outer == 0) { m_store.m_undo.clear(); }
    }

  private:
    Crossing_store& m_store;
    std::size_t m_mark;
    bool m_is_kept = false;
  };

protected:
  struct Curve
  {
    Id first = -1, last = -1; // `last` of an open curve only
    std::array<Index, 2> ends{-1, -1};
  };

  Index append_curve()
  {
    m_curves.emplace_back();
    note([this] { m_curves.pop_back(); });
    return number_of_curves() - 1;
  }
  Curve& edit_curve(Index c)
  {
    note([this, c, old = m_curves[c]] { m_curves[c] = old; });
    return m_curves[c];
  }
  Crossing& edit(Id x)
  {
    note([this, x, old = m_crossings[x]] { m_crossings[x] = old; });
    return m_crossings[x];
  }
  // A crossing at `place` among those of its edge.
  Id append(Index halfedge, Index curve, double t, Index place)
  {
    const Id x = static_cast<Id>(m_crossings.size());
    m_crossings.push_back({halfedge, curve, -1, -1, t, -1});
    note([this] { m_crossings.pop_back(); });
    auto& list = edit_list(m_surface.edge(halfedge));
    list.insert(list.begin() + place, x);
    number(list, place);
    return x;
  }
  // A crossing next to an end of its edge.
  Id append_at(Index halfedge, Index curve, bool at_target)
  {
    const Index e = m_surface.edge(halfedge);
    const bool at_end = at_target == (e == halfedge); // of the edge
    return append(halfedge, curve, at_end ? 1. : 0., at_end ? static_cast<Index>(on(e).size()) : 0);
  }
  void unlist(Id x)
  {
    auto& list = edit_list(edge(x));
    const Index place = m_crossings[x].place;
    list.erase(list.begin() + place);
    number(list, place);
  }
  // Makes two crossings of a curve neighbours; -1 stands for an end.
  void join(Index curve, Id x, Id y)
  {
    if (x >= 0) { edit(x).next = y; }
    else { edit_curve(curve).first = y; }
    if (y >= 0) { edit(y).prev = x; }
    else { edit_curve(curve).last = x; }
  }
  void set_end(const End& e, Index v)
  {
    const Index old = vertex(e);
    if (old >= 0) { edit_ends(old, e, false); }
    if (v >= 0) { edit_ends(v, e, true); }
    edit_curve(e.curve).ends[e.is_last] = v;
  }
  void set_along(Index e, Index curve)
  {
    note([this, e, old = along(e)] { put_along(e, old); });
    put_along(e, curve);
  }

  void lay_along(Index curve)
  {
    const Index e = edge_along(curve);
    if (!is_free(e) || m_surface.opposite[e] < 0)
    {
      throw Internal_error("Crossing_store: a curve runs along an edge that is not free");
    }
    set_along(e, curve);
  }
  // Makes open curves of crossings that are in no curve any more.
  void link(Index curve, const std::vector<std::pair<Id, bool>>& chain, const std::array<Index, 2>& ends)
  {
    Id at = -1;
    for (const auto& [x, is_turned] : chain)
    {
      Crossing& crossing = edit(x);
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
  // Takes the ends off a curve and lets its crossings go.
  void clear(Index curve)
  {
    if (is_open(curve))
    {
      if (nearest({curve, false}) < 0) { set_along(edge_along(curve), -1); }
      for (bool is_last : {false, true}) { set_end({curve, is_last}, -1); }
    }
    edit_curve(curve) = Curve();
  }

private:
  template <class Undo> void note(Undo undo)
  {
    if (m_trials > 0) { m_undo.emplace_back(std::move(undo)); }
  }
  std::vector<Id>& edit_list(Index e)
  {
    if (m_slot[e] < 0)
    {
      m_slot[e] = static_cast<Index>(m_lists.size());
      m_lists.emplace_back();
    }
    auto& list = m_lists[m_slot[e]];
    note([this, e, old = list] {
      m_lists[m_slot[e]] = old;
      number(old, 0);
    });
    return list;
  }
  void number(const std::vector<Id>& list, Index from)
  {
    for (std::size_t i = from; i < list.size(); ++i) { m_crossings[list[i]].place = static_cast<Index>(i); }
  }
  void edit_ends(Index v, const End& e, bool is_new)
  {
    auto& ends = m_ends[v];
    note([this, v, old = ends] { m_ends[v] = old; });
    if (is_new) { ends.push_back(e); }
    else { ends.erase(std::find(ends.begin(), ends.end(), e)); }
  }
  void put_along(Index e, Index curve)
  {
    if (curve < 0) { m_along.erase(e); }
    else { m_along[e] = curve; }
  }

  const Triangle_surface& m_surface;
  std::vector<Crossing> m_crossings;
  std::vector<Curve> m_curves;
  std::vector<Index> m_slot; // of each edge: its list, or -1
  std::vector<std::vector<Id>> m_lists;
  std::unordered_map<Index, std::vector<End>> m_ends; // at vertices where curves end
  std::unordered_map<Index, Index> m_along;           // curves that run along an edge
  std::vector<std::function<void()>> m_undo;
  int m_trials = 0;
  std::vector<Id> m_none; // the list of an edge that has none
  std::vector<End> m_no_ends;
};

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_CURVES_INTERNAL_CROSSING_STORE_H
