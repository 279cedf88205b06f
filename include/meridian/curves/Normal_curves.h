// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CURVES_NORMAL_CURVES_H
#define MERIDIAN_CURVES_NORMAL_CURVES_H

#include <meridian/base/vectors.h>
#include <meridian/curves/internal/crossing_store.h>
#include <meridian/surface/Triangle_surface.h>

#include <array>
#include <vector>

namespace meridian {

/*!
 * \ingroup PkgMeridianGenerators
 *
 * curves in normal position: they cross edges, never pass through a vertex, and the crossings of every edge stand in a
 * total order. A curve is closed, or open and ends at two vertices.
 *
 * Sequences of edges and orders on edges are all that the topology is read from (`chords.h` does): between two
 * crossings a curve runs through a face as a chord, and two chords cross if and only if their ends alternate around the
 * face. An open curve leaves its first vertex, and comes to its last, across the edge on the other side of a face; or
 * it runs along one edge and crosses none. Where on its edge a crossing lies is a number beside it, for lengths alone.
 * Closed curves `2i` and `2i + 1` are partners, who may cross; no two others do.
 */
class Normal_curves
{
public:
  using Id = internal::Crossing_store::Id;             ///< of a crossing
  using Crossing = internal::Crossing_store::Crossing; ///< where a curve leaves a face
  using End = internal::Crossing_store::End;           ///< of an open curve
  /// a crossing to be made: in gap `place` of its edge. Several in one gap are ordered by `t`.
  struct Step
  {
    Index halfedge, place;
    double t;
  };
  /// a stretch of an edge between two crossings, or between a crossing and an end. Place `k` has `k` crossings before
  /// it.
  struct Gap
  {
    Index edge, place;
    bool operator<(const Gap& g) const { return edge != g.edge ? edge < g.edge : place < g.place; }
    bool operator==(const Gap& g) const { return edge == g.edge && place == g.place; }
  };
  /// what is done while a trial lives is taken back at its end, unless it is kept. Trials may be nested.
  struct Trial : internal::Crossing_store::Trial
  {
    explicit Trial(Normal_curves& curves) : internal::Crossing_store::Trial(curves.m_store) {}
  };

  /// The surface must outlive the curves.
  Normal_curves(const Triangle_surface& surface, Index curves)
    : m_store(surface, curves), m_meeting((curves + 1) / 2, -1)
  {}
  Normal_curves(Triangle_surface&& surface, Index curves) = delete;

  /// \name Curves and their crossings, in order
  /// @{
  const Triangle_surface& surface() const { return m_store.surface(); }
  Index number_of_curves() const { return m_store.number_of_curves(); }
  static Index partner(Index curve) { return curve ^ 1; }
  bool is_present(Index curve) const { return m_store.is_present(curve); }
  bool is_open(Index curve) const { return m_store.is_open(curve); }
  const Crossing& operator[](Id x) const { return m_store[x]; }
  Index edge(Id x) const { return m_store.edge(x); }
  /// \returns the crossings of an edge, from the source of `edge` to its target
  const std::vector<Id>& on(Index edge) const { return m_store.on(edge); }
  std::vector<Id> crossings(Index curve) const { return m_store.crossings(curve); }
  /// @}

  /// \name Ends of open curves
  /// @{
  Index vertex(const End& e) const { return m_store.vertex(e); }
  /// \returns the curves' ends at a vertex, in no order that means anything
  const std::vector<End>& ends_at(Index v) const { return m_store.ends_at(v); }
  bool has_open_curves() const { return m_store.has_open_curves(); }
  /// \returns the crossing nearest to an end of an open curve, or -1 if it runs along an edge
  Id nearest(const End& e) const { return m_store.nearest(e); }
  /// \returns the curve that runs along an edge from end to end without a crossing, or -1
  Index along(Index edge) const { return m_store.along(edge); }
  /// \returns the edge that an open curve without crossings runs along
  Index edge_along(Index curve) const { return m_store.edge_along(curve); }
  /// \returns whether nothing crosses an edge and nothing runs along it
  bool is_free(Index edge) const { return m_store.is_free(edge); }
  /// @}

  Index number_of_pairs() const { return static_cast<Index>(m_meeting.size()); }
  /// \returns a face where a curve crosses its partner, or -1
  Index meeting(Index curve) const { return curve / 2 < number_of_pairs() ? m_meeting[curve / 2] : -1; }
  void set_meeting(Index curve, Index face) { m_meeting[curve / 2] = face; }

  /// adds a closed curve, which must not be there yet.
  void add(Index curve, const std::vector<Step>& steps);
  /// adds an open curve. Without steps it runs along the edge that joins its ends, which nothing may cross.
  /// \returns the curve
  Index add(Index from, Index to, const std::vector<Step>& steps);
  void remove(Index curve);

  /// \name Changes of course, as `Crossing_store` describes them
  /// @{
  void move(Id x, double t) { m_store.move(x, t); }
  void reroute(Id first, Id last, const std::vector<Index>& halfedges, bool at_target);
  void extend(const End& end, Index to, const std::vector<Index>& halfedges, Index around);
  void trim(const End& end) { m_store.trim(end); }
  Index splice(const End& from, const End& to, const std::vector<Index>& halfedges);
  std::array<Index, 2> split(Id x, Index v) { return m_store.split(x, v); }
  /// @}

private:
  // Appends the crossings of a curve that has none, and joins them in order.
  void link_new(Index curve, const std::vector<Step>& steps);

  internal::Crossing_store m_store;
  std::vector<Index> m_meeting; // of each pair: the face where its chords cross, or -1
};

} // namespace meridian

#endif // MERIDIAN_CURVES_NORMAL_CURVES_H
