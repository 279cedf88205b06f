// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CURVES_INTERNAL_CROSSING_STORE_H
#define MERIDIAN_CURVES_INTERNAL_CROSSING_STORE_H

#include <meridian/base/vectors.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/edge_places.h>

#include <array>
#include <cstdint>
#include <functional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace meridian {
namespace internal {

// Curves as chains of crossings with edges, an order of the crossings on every edge, and the ends of open curves at
// vertices. Every change can be taken back: see Trial.
class Crossing_store
{
public:
  using Id = Index; ///< of a crossing

  /// a crossing in the chain of its curve.
  struct Chained_crossing : Crossing
  {
    Index curve;
    Id prev, next; ///< along the curve; -1 where an open curve ends
  };
  /// an end of an open curve.
  struct End
  {
    Index curve;
    bool is_last; ///< whether the curve runs to it
    bool operator==(const End& e) const { return curve == e.curve && is_last == e.is_last; }
  };

  Crossing_store(const Triangle_surface& surface, Index curves)
    : m_surface(surface), m_curves(curves), m_changed(curves, 0), m_slot(surface.number_of_halfedges(), -1)
  {}

  const Triangle_surface& surface() const { return m_surface; }
  Index number_of_curves() const { return static_cast<Index>(m_curves.size()); }
  bool is_present(Index curve) const { return m_curves[curve].first >= 0 || is_open(curve); }
  bool is_open(Index curve) const { return m_curves[curve].ends[0] >= 0; }
  /// \returns the vertex at an end of an open curve
  Index vertex(const End& e) const { return m_curves[e.curve].ends[e.is_last]; }
  /// \returns the curves' ends at a vertex, in no order that means anything
  const std::vector<End>& ends_at(Index v) const;
  bool has_open_curves() const { return !m_ends.empty(); }
  /// \returns the curve that runs along an edge from end to end without a crossing, or -1
  Index along(Index edge) const;
  const Chained_crossing& operator[](Id x) const { return m_crossings[x]; }
  Index edge(Id x) const { return m_surface.edge(m_crossings[x].halfedge); }
  void move(Id x, double t) { edit(x).t = t; }
  /// \returns the crossings of an edge, from the source of `edge` to its target
  const std::vector<Id>& on(Index edge) const { return m_slot[edge] < 0 ? m_none : m_lists[m_slot[edge]]; }
  /// \returns whether nothing crosses an edge and nothing runs along it
  bool is_free(Index edge) const { return on(edge).empty() && along(edge) < 0; }
  /// \returns the crossing nearest to an end of an open curve, or -1 if it runs along an edge
  Id nearest(const End& e) const { return e.is_last ? m_curves[e.curve].last : m_curves[e.curve].first; }
  /// \returns the crossings of a curve, in order
  std::vector<Id> crossings(Index curve) const;

  /// replaces the crossings from `first` to `last` of one curve by others, each at an end of its edge: at the target of
  /// its halfedge if `at_target` is set, at the source otherwise.
  void reroute(Id first, Id last, const std::vector<Index>& halfedges, bool at_target);
  /// moves an end of an open curve to vertex `to`: from there the curve crosses `halfedges`, near to vertex `around`,
  /// on its way to what is left of it. The halfedges are those by which it leaves faces on its way from `to`. What
  /// leads round `to` alone is left out.
  void extend(const End& end, Index to, const std::vector<Index>& halfedges, Index around);
  /// leaves out the crossings next to an end that only lead round its vertex.
  void trim(const End& end);
  /// \returns the edge that an open curve without crossings runs along
  Index edge_along(Index curve) const;
  void remove(Index curve);

  /// \returns how many changes there have been, those that were taken back among them
  std::uint64_t clock() const { return m_clock; }
  /// \returns whether, since a time, anything has changed on the edges that a curve crosses but the fractions there, or
  ///          another curve has come to, or left, a vertex of them
  bool has_changed_beside(Index curve, std::uint64_t since) const;
  /// \returns whether a curve itself has taken another course since a time
  bool has_changed(Index curve, std::uint64_t since) const { return m_changed[curve] > since; }

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

  struct Curve
  {
    Id first = -1, last = -1; // `last` of an open curve only
    std::array<Index, 2> ends{-1, -1};
  };

  Index append_curve();
  Curve& edit_curve(Index c);
  Chained_crossing& edit(Id x);
  // A crossing at `place` among those of its edge.
  Id append(Index halfedge, Index curve, double t, Index place);
  // A crossing next to an end of its edge.
  Id append_at(Index halfedge, Index curve, bool at_target);
  void unlist(Id x);
  // Makes two crossings of a curve neighbours; -1 stands for an end.
  void join(Index curve, Id x, Id y);
  void set_end(const End& e, Index v);
  void set_along(Index e, Index curve);

  void lay_along(Index curve);
  // Makes open curves of crossings that are in no curve any more.
  void link(Index curve, const std::vector<std::pair<Id, bool>>& chain, const std::array<Index, 2>& ends);
  // Takes the ends off a curve and lets its crossings go.
  void clear(Index curve);

private:
  template <class Undo> void note(Undo undo)
  {
    if (m_trials > 0) { m_undo.emplace_back(std::move(undo)); }
  }
  std::vector<Id>& edit_list(Index e);
  void number(const std::vector<Id>& list, Index from)
  {
    for (std::size_t i = from; i < list.size(); ++i) { m_crossings[list[i]].place = static_cast<Index>(i); }
  }
  void edit_ends(Index v, const End& e, bool is_new);
  void put_along(Index e, Index curve);
  void note_ends(Index v) { m_ends_changed[v] = m_any_ends_changed = ++m_clock; }

  const Triangle_surface& m_surface;
  std::vector<Chained_crossing> m_crossings;
  std::vector<Curve> m_curves;
  std::vector<std::uint64_t> m_changed; // of each curve: when last
  std::vector<Index> m_slot;            // of each edge: its list, or -1
  std::vector<std::vector<Id>> m_lists;
  std::vector<std::uint64_t> m_list_changed;          // of each list: when last
  std::unordered_map<Index, std::vector<End>> m_ends; // at vertices where curves end
  std::unordered_map<Index, Index> m_along;           // curves that run along an edge
  std::unordered_map<Index, std::uint64_t> m_ends_changed;
  std::uint64_t m_clock = 0, m_any_ends_changed = 0;
  std::vector<std::function<void()>> m_undo;
  int m_trials = 0;
  std::vector<Id> m_none; // the list of an edge that has none
  std::vector<End> m_no_ends;
};

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_CURVES_INTERNAL_CROSSING_STORE_H
