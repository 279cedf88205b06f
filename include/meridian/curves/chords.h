// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CURVES_CHORDS_H
#define MERIDIAN_CURVES_CHORDS_H

#include <meridian/base/vectors.h>
#include <meridian/curves/Normal_curves.h>
#include <meridian/surface/Triangle_surface.h>

#include <cstdint>
#include <vector>

namespace meridian {

// Curves as chords of faces: which of them cross, and what regions they divide a face into. All is read from orders.

/// \param curves, x a crossing
/// \param left on which side of the curve
/// \returns the gap beside a crossing, to the left or to the right of the curve
Gap gap_beside(const Normal_curves& curves, Index x, bool left);

/// \param curves, gap a gap between crossings
/// \returns a point in a gap, as a fraction along its edge
double middle_of(const Normal_curves& curves, const Gap& gap);

/// \param curves, x a crossing
/// \returns the face in which a curve runs from `x` to the crossing after it
inline Index face_after(const Normal_curves& curves, Index x)
{
  return curves.surface().face(curves.surface().opposite[curves[x].halfedge]);
}

/// \param curves, x, face an end of a chord
/// \returns the other end of the chord of `face` that has an end at `x`; -1 if that is the corner on the other side
inline Index chord_across(const Normal_curves& curves, Index x, Index face)
{
  return curves.surface().face(curves[x].halfedge) == face ? curves[x].prev : curves[x].next;
}

/// \param curves, x, face an end of a chord
/// \returns the end at which a chord of the partner enters `face` and crosses the chord that ends at `x`, or -1
Index partner_across(const Normal_curves& curves, Index x, Index face);

/// \param curves, curve, face a curve and a face
/// \returns how often a curve crosses its partner in one face
Index count_in_face(const Normal_curves& curves, Index curve, Index face);

/// \param curves all curves
/// \returns for each pair how often its curves cross each other
/// \throws Internal_error if other chords cross, or a chord has both ends on one edge
std::vector<Index> count_crossings(const Normal_curves& curves);

/// \param curves, curve a curve
/// \returns whether a curve is simple and crosses its partner once, and nothing else
bool crosses_partner_once(const Normal_curves& curves, Index curve);

/// \param curves, curve a curve
/// \returns the length of a curve
double length(const Normal_curves& curves, Index curve);

/// \param curves, curve a curve
/// \returns whether a curve that crosses its partner once crosses it from right to left
bool runs_from_right(const Normal_curves& curves, Index curve);

namespace internal {

// Where an end of a chord of `face` stands in the order around it.
std::int64_t around(const Normal_curves& curves, Index x, Index face);

// The side of a face that a crossing lies on.
Index side(const Normal_curves& curves, Index x, Index face);

// How many crossings of a side, from its source on, come up to the last whose chord ends at the corner across from it.
Index count_before_corner(const Normal_curves& curves, Index h, Index face);

} // namespace internal

/// calls `visit(gap, x)` for the gaps of the region of `face` that `gap` lies on, counterclockwise: the chord that ends
/// at `x` comes after the gap, or a corner if that is -1. The region is to the left of the way from `x` into the face.
/// \param curves, gap, face a gap on a side of a face
/// \param visit the function
template <class Visit> void for_each_gap_around(const Normal_curves& curves, const Gap& gap, Index face, Visit visit)
{
  const Triangle_surface& s = curves.surface();
  Index h = 3 * face;
  while (s.edge(h) != gap.edge) { ++h; }
  const auto turned = [&](Index g, Index k) { // to places along a halfedge, and back
    return s.edge(g) == g ? k : static_cast<Index>(curves.on(s.edge(g)).size()) - k;
  };
  const Index first = h, first_place = turned(h, gap.place);
  Index k = first_place;
  do {
    const auto& list = curves.on(s.edge(h));
    const Index n = static_cast<Index>(list.size());
    if (k == n)
    {
      visit(Gap{s.edge(h), turned(h, k)}, Index(-1));
      const Index chords =
        internal::count_before_corner(curves, s.prev(h), face); // that end at the corner, from across
      h = chords > 0 ? s.prev(h) : s.next(h);
      k = chords;
      continue;
    }
    const Index x = list[s.edge(h) == h ? k : n - 1 - k];
    visit(Gap{s.edge(h), turned(h, k)}, x);
    Index end = chord_across(curves, x, face);
    if (end < 0) // on to the corner; between two chords that end there nothing else lies
    {
      if (k > 0 && chord_across(curves, list[s.edge(h) == h ? k - 1 : n - k], face) < 0) { continue; }
      h = s.prev(h);
      k = 0;
      continue;
    }
    const Index other = curves.meeting(curves[x].curve) == face ? partner_across(curves, x, face) : -1;
    if (other >= 0) // go on along the partner, to its end on the left
    {
      const std::int64_t a = internal::around(curves, x, face), b = internal::around(curves, end, face),
                         c = internal::around(curves, other, face);
      const bool is_left = b < a ? b < c && c < a : c > b || c < a;
      end = is_left ? other : chord_across(curves, other, face);
    }
    h = internal::side(curves, end, face);
    k = turned(h, curves[end].place); // one crossing further; for a turned edge, the gap before it
    if (s.edge(h) == h) { ++k; }
  } while (h != first || k != first_place);
}

} // namespace meridian

#endif // MERIDIAN_CURVES_CHORDS_H
