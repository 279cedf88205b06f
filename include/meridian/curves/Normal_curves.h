// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CURVES_NORMAL_CURVES_H
#define MERIDIAN_CURVES_NORMAL_CURVES_H

#include <meridian/base/vectors.h>
#include <meridian/curves/internal/crossing_store.h>
#include <meridian/surface/Triangle_surface.h>

#include <cstdint>
#include <vector>

namespace meridian {

/*!
 * \ingroup PkgMeridianGenerators
 *
 * curves in normal position: they cross edges, never pass through a vertex, and the crossings of every edge stand in a
 * total order. A curve is closed, or open and ends at two vertices.
 *
 * Sequences of edges and orders on edges are all that the topology is read from: between two crossings a curve runs
 * through a face as a chord, and two chords cross if and only if their ends alternate around the face. An open curve
 * leaves its first vertex, and comes to its last, across the edge on the other side of a face; or it runs along one
 * edge and crosses none. Where on its edge a crossing lies is a number beside it, for lengths alone. Closed curves `2i`
 * and `2i + 1` are partners, who may cross; no two others do.
 */
class Normal_curves : public internal::Crossing_store
{
public:
  /// a stretch of an edge between two crossings, or between a crossing and an end. Place `k` has `k` crossings before
  /// it.
  struct Gap
  {
    Index edge, place;
    bool operator<(const Gap& g) const { return edge != g.edge ? edge < g.edge : place < g.place; }
    bool operator==(const Gap& g) const { return edge == g.edge && place == g.place; }
  };
  /// a crossing to be made: in gap `place` of its edge. Several in one gap are ordered by `t`.
  struct Step
  {
    Index halfedge, place;
    double t;
  };

  Normal_curves(const Triangle_surface& surface, Index curves)
    : Crossing_store(surface, curves), m_surface(Crossing_store::surface()), m_meeting((curves + 1) / 2, -1)
  {}

  static Index partner(Index curve) { return curve ^ 1; }
  /// \returns the gap beside a crossing, to the left or to the right of the curve
  Gap beside(Id x, bool left) const;
  /// \returns a point in a gap, as a fraction along its edge
  double middle(const Gap& g) const;

  /// adds a closed curve, which must not be there yet.
  void add(Index curve, const std::vector<Step>& steps);
  /// adds an open curve. Without steps it runs along the edge that joins its ends, which nothing may cross.
  /// \returns the curve
  Index add(Index from, Index to, const std::vector<Step>& steps);
  void remove(Index curve);

  /// \returns the face in which a curve runs from `x` to the crossing after it
  Index face_after(Id x) const { return m_surface.face(m_surface.opposite[(*this)[x].halfedge]); }
  /// \returns the other end of the chord that begins or ends at `x` in `face`; -1 if that is the corner on the other
  ///          side
  Id across(Id x, Index face) const
  {
    return m_surface.face((*this)[x].halfedge) == face ? (*this)[x].prev : (*this)[x].next;
  }
  /// \returns where an end of a chord of `face` stands in the order around it
  std::int64_t around(Id x, Index face) const;
  /// \returns whether the chords of `face` that end at `x` and `y` cross
  bool alternate(Id x, Id y, Index face) const;
  /// \returns the end at which a chord of the partner enters `face` and crosses the chord that ends at `x`, or -1
  Id crossed_by(Id x, Index face) const;
  /// \returns how often a curve crosses its partner in one face
  Index count_in_face(Index curve, Index face) const;
  /// \returns a face where a curve crosses its partner, or -1
  Index meeting(Index curve) const
  {
    return curve / 2 < static_cast<Index>(m_meeting.size()) ? m_meeting[curve / 2] : -1;
  }
  /// says that a curve crosses its partner in `face`
  void set_meeting(Index curve, Index face) { m_meeting[curve / 2] = face; }
  /// \returns for each pair how often its curves cross each other
  /// \throws Internal_error if other chords cross, or a chord has both ends on one edge
  std::vector<Index> count_crossings() const;
  /// \returns whether a curve is simple and crosses its partner once, and nothing else
  bool crosses_partner_once(Index curve) const;

  /// \returns whether a curve is simple and crosses no other
  bool is_disjoint(Index curve) const;

  /// \returns whether a curve that crosses its partner once crosses it from right to left
  bool runs_from_right(Index curve) const;

  /// calls `visit(gap, x)` for the gaps of the region of `face` that `gap` lies on, counterclockwise: `x` is the end of
  /// the chord that comes after the gap, or -1 if a corner does. The region lies to the left of the way from `x` into
  /// the face.
  template <class Visit> void for_each_gap_around(const Gap& gap, Index face, Visit visit) const
  {
    Index h = 3 * face;
    while (m_surface.edge(h) != gap.edge) { ++h; }
    const auto size = [&](Index g) { return static_cast<Index>(on(m_surface.edge(g)).size()); };
    // places along a halfedge
    const auto turned = [&](Index g, Index k) { return m_surface.edge(g) == g ? k : size(g) - k; };
    const Index first = h, first_place = turned(h, gap.place);
    Index k = first_place;
    do {
      const auto& list = on(m_surface.edge(h));
      const Index n = static_cast<Index>(list.size());
      if (k == n)
      {
        visit(Gap{m_surface.edge(h), turned(h, k)}, Id(-1));
        const Index chords = count_before_corner(m_surface.prev(h), face); // that end at the corner, from across
        h = chords > 0 ? m_surface.prev(h) : m_surface.next(h);
        k = chords;
        continue;
      }
      const Id x = list[m_surface.edge(h) == h ? k : n - 1 - k];
      visit(Gap{m_surface.edge(h), turned(h, k)}, x);
      Id end = across(x, face);
      if (end < 0) // on to the corner; between two chords that end there nothing else lies
      {
        if (k > 0 && across(list[m_surface.edge(h) == h ? k - 1 : n - k], face) < 0) { continue; }
        h = m_surface.prev(h);
        k = 0;
        continue;
      }
      const Id other = meeting((*this)[x].curve) == face ? crossed_by(x, face) : -1;
      if (other >= 0) // go on along the partner, to its end on the left
      {
        const std::int64_t a = around(x, face), b = around(end, face), c = around(other, face);
        const bool is_left = b < a ? b < c && c < a : c > b || c < a;
        end = is_left ? other : across(other, face);
      }
      h = side(end, face);
      k = turned(h, (*this)[end].place); // one crossing further; for a turned edge, the gap before it
      if (m_surface.edge(h) == h) { ++k; }
    } while (h != first || k != first_place);
  }

private:
  // How many crossings of a side, from its source on, come up to the last whose chord ends at the corner across from
  // it.
  Index count_before_corner(Index h, Index face) const;
  // Counts where partners cross. False if others do, or if a chord has both ends on one edge.
  bool count_in_faces(std::vector<Index>& faces, std::vector<Index>& count) const;
  void find_meeting(Index curve);
  Index side(Id x, Index face) const;
  // Appends the crossings of a curve that has none, and joins them in order.
  void link_new(Index curve, const std::vector<Step>& steps);

  const Triangle_surface& m_surface;
  std::vector<Index> m_meeting; // of each pair: the face where its chords cross, or -1
};

namespace internal {

double length(const Normal_curves& curves, Index c);

} // namespace internal

} // namespace meridian

#endif // MERIDIAN_CURVES_NORMAL_CURVES_H
