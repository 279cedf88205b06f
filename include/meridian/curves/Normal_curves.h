// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CURVES_NORMAL_CURVES_H
#define MERIDIAN_CURVES_NORMAL_CURVES_H

#include <meridian/base/vectors.h>
#include <meridian/curves/internal/crossing_store.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/edge_places.h>

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
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
  using Id = internal::Crossing_store::Id;                             ///< of a crossing
  using Chained_crossing = internal::Crossing_store::Chained_crossing; ///< in the chain of its curve
  using End = internal::Crossing_store::End;                           ///< of an open curve
  /// what is done while a trial lives is taken back at its end, unless it is kept. Trials may be nested.
  struct Trial : internal::Crossing_store::Trial
  {
    /// \param curves what is tried with
    explicit Trial(Normal_curves& curves) : internal::Crossing_store::Trial(curves.m_store) {}
  };

  /// \param surface the surface, which must outlive the curves
  /// \param curves how many closed curves there may be; none is there yet
  Normal_curves(const Triangle_surface& surface, Index curves)
    : m_store(surface, curves), m_meeting((curves + 1) / 2, -1)
  {}
  Normal_curves(Triangle_surface&& surface, Index curves) = delete;

  // Curves and their crossings, in order
  /// \returns the surface
  const Triangle_surface& surface() const { return m_store.surface(); }
  /// \returns how many numbers of curves there are
  Index number_of_curves() const { return m_store.number_of_curves(); }
  /// \param curve a closed curve \returns its partner
  static Index partner(Index curve) { return curve ^ 1; }
  /// \param curve a number \returns whether there is such a curve
  bool is_present(Index curve) const { return m_store.is_present(curve); }
  /// \param curve a curve \returns whether it is open
  bool is_open(Index curve) const { return m_store.is_open(curve); }
  /// \param x a crossing \returns what it is
  const Chained_crossing& operator[](Id x) const { return m_store[x]; }
  /// \param x a crossing \returns its edge
  Index edge(Id x) const { return m_store.edge(x); }
  /// \param edge an edge \returns its crossings, from the source of `edge` to its target
  const std::vector<Id>& on(Index edge) const { return m_store.on(edge); }
  /// \param curve a curve \returns its crossings, in order
  std::vector<Id> crossings(Index curve) const { return m_store.crossings(curve); }

  // Ends of open curves
  /// \param e an end \returns its vertex
  Index vertex(const End& e) const { return m_store.vertex(e); }
  /// \param v a vertex \returns the curves' ends there, in no order that means anything
  const std::vector<End>& ends_at(Index v) const { return m_store.ends_at(v); }
  /// \returns whether any curve is open
  bool has_open_curves() const { return m_store.has_open_curves(); }
  /// \param e an end of an open curve \returns the crossing nearest to it, or -1 if it runs along an edge
  Id nearest(const End& e) const { return m_store.nearest(e); }
  /// \param edge an edge \returns the curve that runs along it from end to end without a crossing, or -1
  Index along(Index edge) const { return m_store.along(edge); }
  /// \param curve a curve \returns the edge that an open curve without crossings runs along
  Index edge_along(Index curve) const { return m_store.edge_along(curve); }
  /// \param edge an edge \returns whether nothing crosses it and nothing runs along it
  bool is_free(Index edge) const { return m_store.is_free(edge); }

  /// \returns how many pairs of partners there may be
  Index number_of_pairs() const { return static_cast<Index>(m_meeting.size()); }
  /// \param curve a curve \returns a face where it crosses its partner, or -1
  Index meeting(Index curve) const { return curve / 2 < number_of_pairs() ? m_meeting[curve / 2] : -1; }
  /// says where partners cross. \param curve one of them \param face the face, or -1
  void set_meeting(Index curve, Index face) { m_meeting[curve / 2] = face; }

  /// adds a closed curve, which must not be there yet.
  /// \param curve its number
  /// \param steps its crossings, in order. The place of each is that of a gap; several in one gap are ordered by `t`
  void add(Index curve, const std::vector<Crossing>& steps);
  /// adds an open curve. Without steps it runs along the edge that joins its ends, which nothing may cross.
  /// \param from, to its ends, vertices \param steps its crossings, in order
  /// \returns the curve
  Index add(Index from, Index to, const std::vector<Crossing>& steps);
  /// takes a curve away. \param curve its number
  void remove(Index curve);

  // Changes of course, as `Crossing_store` describes them
  /// \param x a crossing \param t its new fraction along its edge
  void move(Id x, double t) { m_store.move(x, t); }
  /// \param first, last crossings of a curve \param halfedges crossed instead \param at_target next to which ends
  void reroute(Id first, Id last, const std::vector<Index>& halfedges, bool at_target);
  /// \param end an end \param to where it goes \param halfedges crossed from there \param around a vertex near them
  void extend(const End& end, Index to, const std::vector<Index>& halfedges, Index around);
  /// \param end an end, whose crossings that only lead round its vertex are left out
  void trim(const End& end) { m_store.trim(end); }

  /// \returns a number that grows with every change of course
  std::uint64_t clock() const { return m_store.clock(); }
  /// \param v a vertex \param since what `clock()` returned
  /// \returns whether since then a curve that ends there, or something beside it, has changed its course
  bool has_changed_at(Index v, std::uint64_t since) const;
  /// notes that a curve is as tight as its neighbours let it be. \param curve it \param length its length
  void set_tight(Index curve, double length);
  /// \param curve a curve \returns its length, if it was noted to be tight and nothing beside it has changed since
  std::optional<double> tight_length(Index curve) const;

private:
  // Appends the crossings of a curve that has none, and joins them in order.
  void link_new(Index curve, const std::vector<Crossing>& steps);

  internal::Crossing_store m_store;
  std::vector<Index> m_meeting;                          // of each pair: the face where its chords cross, or -1
  std::vector<std::pair<std::uint64_t, double>> m_tight; // of each curve: when it was noted to be tight, its length
};

} // namespace meridian

#endif // MERIDIAN_CURVES_NORMAL_CURVES_H
