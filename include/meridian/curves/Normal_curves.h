// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CURVES_NORMAL_CURVES_H
#define MERIDIAN_CURVES_NORMAL_CURVES_H

#include <meridian/curves/internal/crossing_store.h>

#include <numeric>
#include <tuple>
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
  Gap beside(Id x, bool left) const
  {
    const Index h = (*this)[x].halfedge, e = m_surface.edge(h), k = (*this)[x].place;
    return {e, (left == (h == e)) ? k + 1 : k}; // the target of `h` is on the left
  }
  /// \returns a point in a gap, as a fraction along its edge
  double middle(const Gap& g) const
  {
    const auto& list = on(g.edge);
    const double from = g.place == 0 ? 0 : (*this)[list[g.place - 1]].t;
    const double to = g.place == static_cast<Index>(list.size()) ? 1 : (*this)[list[g.place]].t;
    return (from + to) / 2;
  }

  /// adds a closed curve, which must not be there yet.
  void add(Index curve, const std::vector<Step>& steps)
  {
    link_new(curve, steps);
    const Id first = nearest({curve, false}), last = nearest({curve, true});
    join(curve, last, first);
    edit_curve(curve).first = first;
    find_meeting(curve);
  }
  /// adds an open curve. Without steps it runs along the edge that joins its ends, which nothing may cross.
  /// \returns the curve
  Index add(Index from, Index to, const std::vector<Step>& steps)
  {
    const Index curve = append_curve();
    link_new(curve, steps);
    set_end({curve, false}, from);
    set_end({curve, true}, to);
    if (steps.empty()) { lay_along(curve); }
    return curve;
  }
  void remove(Index curve)
  {
    if (meeting(curve) >= 0) { set_meeting(curve, -1); }
    Crossing_store::remove(curve);
  }

  /// \returns the face in which a curve runs from `x` to the crossing after it
  Index face_after(Id x) const { return m_surface.face(m_surface.opposite[(*this)[x].halfedge]); }
  /// \returns the other end of the chord that begins or ends at `x` in `face`; -1 if that is the corner on the other
  ///          side
  Id across(Id x, Index face) const
  {
    return m_surface.face((*this)[x].halfedge) == face ? (*this)[x].prev : (*this)[x].next;
  }
  /// \returns where an end of a chord of `face` stands in the order around it
  std::int64_t around(Id x, Index face) const
  {
    const Index h = side(x, face), e = m_surface.edge(h), k = (*this)[x].place;
    const Index along = h == e ? k : static_cast<Index>(on(e).size()) - 1 - k;
    return (static_cast<std::int64_t>(h % 3) << 32) + along;
  }
  /// \returns whether the chords of `face` that end at `x` and `y` cross
  bool alternate(Id x, Id y, Index face) const
  {
    const std::int64_t a = around(x, face), b = around(across(x, face), face);
    const std::int64_t c = around(y, face), d = around(across(y, face), face);
    const auto inside = [&](std::int64_t p) { return std::min(a, b) < p && p < std::max(a, b); };
    return inside(c) != inside(d);
  }
  /// \returns the end at which a chord of the partner enters `face` and crosses the chord that ends at `x`, or -1
  Id crossed_by(Id x, Index face) const
  {
    for (Index h = 3 * face; h < 3 * face + 3; ++h)
      for (Id y : on(m_surface.edge(h)))
        if ((*this)[y].curve == partner((*this)[x].curve) && (*this)[y].halfedge != h && alternate(x, y, face))
        {
          return y;
        }
    return -1;
  }
  /// \returns how often a curve crosses its partner in one face
  Index count_in_face(Index curve, Index face) const
  {
    Index count = 0;
    for (Index h = 3 * face; h < 3 * face + 3; ++h)
      for (Id x : on(m_surface.edge(h)))
      {
        if ((*this)[x].curve != curve || (*this)[x].halfedge == h) { continue; }
        for (Index g = 3 * face; g < 3 * face + 3; ++g)
          for (Id y : on(m_surface.edge(g)))
            count += (*this)[y].curve == partner(curve) && (*this)[y].halfedge != g && alternate(x, y, face);
      }
    return count;
  }
  /// \returns a face where a curve crosses its partner, or -1
  Index meeting(Index curve) const
  {
    return curve / 2 < static_cast<Index>(m_meeting.size()) ? m_meeting[curve / 2] : -1;
  }
  /// says that a curve crosses its partner in `face`
  void set_meeting(Index curve, Index face) { m_meeting[curve / 2] = face; }
  /// \returns for each pair how often its curves cross each other
  /// \throws Internal_error if other chords cross, or a chord has both ends on one edge
  std::vector<Index> count_crossings() const
  {
    std::vector<Index> faces, count(m_meeting.size(), 0);
    for (Index c = 0; c < number_of_curves(); ++c)
      for (Id x : crossings(c)) { faces.push_back(face_after(x)); }
    if (!count_in_faces(faces, count)) { throw Internal_error("count_crossings: two curves cross that should not"); }
    return count;
  }
  /// \returns whether a curve is simple and crosses its partner once, and nothing else
  bool crosses_partner_once(Index curve) const
  {
    std::vector<Index> faces, count(m_meeting.size(), 0);
    for (Id x : crossings(curve)) { faces.push_back(face_after(x)); }
    return count_in_faces(faces, count) && count[curve / 2] == 1;
  }

  /// \returns whether a curve is simple and crosses no other
  bool is_disjoint(Index curve) const
  {
    std::vector<Index> faces, count(m_meeting.size(), 0);
    for (Id x : crossings(curve))
      for (Index h : {(*this)[x].halfedge, m_surface.opposite[(*this)[x].halfedge]})
      {
        faces.push_back(m_surface.face(h));
      }
    return count_in_faces(faces, count)
           && (count.empty() || curve / 2 >= static_cast<Index>(count.size()) || count[curve / 2] == 0);
  }

  /// \returns whether a curve that crosses its partner once crosses it from right to left
  bool runs_from_right(Index curve) const
  {
    const Index face = meeting(curve);
    for (Id x : crossings(curve))
    {
      if (face < 0 || face_after(x) != face) { continue; }
      const Id end = (*this)[x].next, y = crossed_by(end, face); // the partner enters the face at y
      if (y < 0) { continue; }
      const std::int64_t from = around(y, face), to = around(across(y, face), face), at = around(end, face);
      // counterclockwise from where it leaves to where it enters
      return from < to ? at < from || at > to : to < at && at < from;
    }
    return false;
  }

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
  Index count_before_corner(Index h, Index face) const
  {
    if (!has_open_curves()) { return 0; }
    const auto& list = on(m_surface.edge(h));
    const Index n = static_cast<Index>(list.size());
    for (Index k = n; k-- > 0;)
      if (across(list[m_surface.edge(h) == h ? k : n - 1 - k], face) < 0) { return k + 1; }
    return 0;
  }
  // Counts where partners cross. False if others do, or if a chord has both ends on one edge.
  bool count_in_faces(std::vector<Index>& faces, std::vector<Index>& count) const
  {
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    std::vector<Id> open; // chords whose second end is still to come, by their first
    for (Index face : faces)
    {
      for (Index h = 3 * face; h < 3 * face + 3; ++h)
      {
        const auto close = [&](Id x) {
          if (open.empty() || open.back() != x) { return false; }
          open.pop_back();
          return true;
        };
        // chords from there may end at the corner that comes first
        const auto& beyond = on(m_surface.edge(m_surface.next(h)));
        for (std::size_t i = 0; i < beyond.size() && has_open_curves(); ++i)
        {
          const Id x = beyond[m_surface.edge(m_surface.next(h)) == m_surface.next(h) ? beyond.size() - 1 - i : i];
          if (across(x, face) >= 0) { continue; }
          if (h % 3 < 2) { open.push_back(x); }
          else if (!close(x)) { return false; }
        }
        const auto& list = on(m_surface.edge(h));
        for (std::size_t i = 0; i < list.size(); ++i)
        {
          const Id x = list[m_surface.edge(h) == h ? i : list.size() - 1 - i], y = across(x, face);
          if (y < 0)
          {
            if (h % 3 == 0) { open.push_back(x); }
            else if (!close(x)) { return false; }
            continue;
          }
          if (edge(x) == edge(y)) { return false; }
          if (side(y, face) > h)
          {
            open.push_back(x);
            continue;
          }
          if (!open.empty() && open.back() == y)
          {
            open.pop_back();
            continue;
          }
          if (open.size() < 2 || (*this)[x].curve / 2 >= static_cast<Index>(count.size()) || open[open.size() - 2] != y
              || (*this)[open.back()].curve != partner((*this)[x].curve))
          {
            return false;
          }
          ++count[(*this)[x].curve / 2];
          open.erase(open.end() - 2);
        }
      }
      if (!open.empty()) { return false; }
    }
    return true;
  }
  void find_meeting(Index curve)
  {
    if (partner(curve) >= number_of_curves() || !is_present(partner(curve))) { return; }
    for (Id x : crossings(curve))
      if (count_in_face(curve, face_after(x)) > 0) { m_meeting[curve / 2] = face_after(x); }
  }
  Index side(Id x, Index face) const
  {
    const Index h = (*this)[x].halfedge;
    return m_surface.face(h) == face ? h : m_surface.opposite[h];
  }
  // Appends the crossings of a curve that has none, and joins them in order.
  void link_new(Index curve, const std::vector<Step>& steps)
  {
    std::vector<std::size_t> order(steps.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    const auto key = [&](std::size_t i) {
      return std::make_tuple(m_surface.edge(steps[i].halfedge), steps[i].place, steps[i].t, i);
    };
    // from the end, so that places stay
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key(a) > key(b); });
    std::vector<Id> ids(steps.size());
    for (std::size_t i : order) { ids[i] = append(steps[i].halfedge, curve, steps[i].t, steps[i].place); }
    Id at = -1;
    for (Id x : ids)
    {
      join(curve, at, x);
      at = x;
    }
    join(curve, at, -1);
  }

  const Triangle_surface& m_surface;
  std::vector<Index> m_meeting; // of each pair: the face where its chords cross, or -1
};

namespace internal {

inline double length(const Normal_curves& curves, Index c)
{
  const Triangle_surface& s = curves.surface();
  double sum = 0;
  for (Index x : curves.crossings(c))
  {
    const Index y = curves[x].next;
    sum += distance(s.point_on(curves.edge(x), curves[x].t), s.point_on(curves.edge(y), curves[y].t));
  }
  return sum;
}

} // namespace internal

} // namespace meridian

#endif // MERIDIAN_CURVES_NORMAL_CURVES_H
