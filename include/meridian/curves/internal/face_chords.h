// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CURVES_INTERNAL_FACE_CHORDS_H
#define MERIDIAN_CURVES_INTERNAL_FACE_CHORDS_H

#include <meridian/base/vectors.h>
#include <meridian/curves/internal/crossing_store.h>
#include <meridian/surface/Triangle_surface.h>

#include <cstdint>
#include <vector>

namespace meridian {
namespace internal {

// Curves as chords of faces: which of them cross, and what regions they divide a face into. Curves `2i` and `2i + 1`
// are partners, who may cross in one face.
class Face_chords : public Crossing_store
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

  Face_chords(const Triangle_surface& surface, Index curves)
    : Crossing_store(surface, curves), m_meeting((curves + 1) / 2, -1)
  {}

  static Index partner(Index curve) { return curve ^ 1; }
  /// \returns the gap beside a crossing, to the left or to the right of the curve
  Gap beside(Id x, bool left) const;
  /// \returns a point in a gap, as a fraction along its edge
  double middle(const Gap& g) const;

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
  Index meeting(Index curve) const { return curve / 2 < number_of_pairs() ? m_meeting[curve / 2] : -1; }
  /// says that a curve crosses its partner in `face`
  void set_meeting(Index curve, Index face) { m_meeting[curve / 2] = face; }

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

protected:
  Index number_of_pairs() const { return static_cast<Index>(m_meeting.size()); }
  // The side of a face that a crossing lies on.
  Index side(Id x, Index face) const;

private:
  // How many crossings of a side, from its source on, come up to the last whose chord ends at the corner across from
  // it.
  Index count_before_corner(Index h, Index face) const;

  std::vector<Index> m_meeting; // of each pair: the face where its chords cross, or -1
};

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_CURVES_INTERNAL_FACE_CHORDS_H
