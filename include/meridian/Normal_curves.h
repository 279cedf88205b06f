// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_NORMAL_CURVES_H
#define MERIDIAN_NORMAL_CURVES_H

#include <meridian/Triangle_surface.h>

#include <algorithm>
#include <tuple>
#include <vector>

namespace meridian {

/*!
 * \ingroup PkgMeridianGenerators
 *
 * closed curves in normal position: they cross edges and never pass through a vertex, and the crossings of every edge
 * stand in a total order.
 *
 * Sequences of edges and orders on edges are all that the topology is read from: between two crossings a curve runs through a
 * face as a chord, and two chords cross if and only if their ends alternate around the face. Where on its edge a crossing
 * lies is a number beside it, for lengths alone. Curves `2i` and `2i + 1` are partners, who may cross; no two others do.
 */
class Normal_curves
{
public:
  using Id = Index; ///< of a crossing

  /// a crossing of a curve with an edge.
  struct Crossing
  {
    Index halfedge; ///< by which the curve leaves a face
    Index curve;
    Id prev, next;  ///< along the curve
    double t;       ///< fraction along the edge `surface().edge(halfedge)`
    Index place;    ///< among the crossings of the edge
  };
  /// a stretch of an edge between two crossings, or between a crossing and an end. Place `k` has `k` crossings before it.
  struct Gap
  {
    Index edge, place;
    bool operator<(const Gap& g) const { return edge != g.edge ? edge < g.edge : place < g.place; }
    bool operator==(const Gap& g) const { return edge == g.edge && place == g.place; }
  };
  /// a crossing to be made: in gap `place` of its edge. Several in one gap are ordered by `t`.
  struct Step { Index halfedge, place; double t; };

  Normal_curves(const Triangle_surface& surface, Index curves)
    : m_surface(surface), m_first(curves, -1), m_meeting((curves + 1) / 2, -1), m_slot(surface.number_of_halfedges(), -1) {}

  const Triangle_surface& surface() const { return m_surface; }
  Index number_of_curves() const { return static_cast<Index>(m_first.size()); }
  bool is_present(Index curve) const { return m_first[curve] >= 0; }
  static Index partner(Index curve) { return curve ^ 1; }
  const Crossing& operator[](Id x) const { return m_crossings[x]; }
  Index edge(Id x) const { return m_surface.edge(m_crossings[x].halfedge); }
  void move(Id x, double t) { m_crossings[x].t = t; }
  /// \returns the crossings of an edge, from the source of `edge` to its target
  const std::vector<Id>& on(Index edge) const
  { return m_slot[edge] < 0 ? m_none : m_lists[m_slot[edge]]; }
  /// \returns the crossings of a curve, in order
  std::vector<Id> crossings(Index curve) const
  {
    std::vector<Id> all;
    if (!is_present(curve)) { return all; }
    Id x = m_first[curve];
    do { all.push_back(x); x = m_crossings[x].next; } while (x != m_first[curve]);
    return all;
  }
  /// \returns the gap beside a crossing, to the left or to the right of the curve
  Gap beside(Id x, bool left) const
  {
    const Index h = m_crossings[x].halfedge, e = m_surface.edge(h), k = m_crossings[x].place;
    return {e, (left == (h == e)) ? k + 1 : k}; // the target of `h` is on the left
  }
  /// \returns a point in a gap, as a fraction along its edge
  double middle(const Gap& g) const
  {
    const auto& list = on(g.edge);
    const double from = g.place == 0 ? 0 : m_crossings[list[g.place - 1]].t;
    const double to = g.place == static_cast<Index>(list.size()) ? 1 : m_crossings[list[g.place]].t;
    return (from + to) / 2;
  }

  /// adds a curve, which must not be there yet.
  void add(Index curve, const std::vector<Step>& steps)
  {
    const Id first = static_cast<Id>(m_crossings.size()), n = static_cast<Id>(steps.size());
    std::vector<Id> order(n);
    for (Id i = 0; i < n; ++i)
    {
      m_crossings.push_back({steps[i].halfedge, curve, first + (i + n - 1) % n, first + (i + 1) % n, steps[i].t, -1});
      order[i] = i;
    }
    m_first[curve] = first;
    const auto key = [&](Id i) { return std::make_tuple(m_surface.edge(steps[i].halfedge), steps[i].place, steps[i].t, i); };
    std::sort(order.begin(), order.end(), [&](Id a, Id b) { return key(a) > key(b); }); // from the end, so that places stay
    for (Id i : order)
    {
      auto& list = make_list(m_surface.edge(steps[i].halfedge));
      list.insert(list.begin() + steps[i].place, first + i);
      number(list, steps[i].place);
    }
    find_meeting(curve);
  }
  void remove(Index curve)
  {
    for (Id x : crossings(curve)) { unlist(x); }
    m_first[curve] = -1;
    m_meeting[curve / 2] = -1;
  }

  /// replaces the crossings from `first` to `last` of one curve by others, each at an end of its edge: at the target of its
  /// halfedge if `at_target` is set, at the source otherwise.
  /// \returns a function that takes the change back
  auto reroute(Id first, Id last, const std::vector<Index>& halfedges, bool at_target)
  {
    struct Undo
    {
      std::vector<std::pair<Index, std::vector<Id>>> lists;
      Id before, after, first, last, curve_first, size;
      Index curve;
    };
    const Index curve = m_crossings[first].curve;
    Undo undo{{}, m_crossings[first].prev, m_crossings[last].next, first, last, m_first[curve], static_cast<Id>(m_crossings.size()), curve};
    for (Id x = first;; x = m_crossings[x].next)
    {
      undo.lists.emplace_back(edge(x), on(edge(x)));
      unlist(x);
      if (x == last) { break; }
    }
    Id at = undo.before;
    for (Index h : halfedges)
    {
      const Index e = m_surface.edge(h);
      const bool at_end = at_target == (e == h); // of the edge
      undo.lists.emplace_back(e, on(e));
      auto& list = make_list(e);
      const Id x = static_cast<Id>(m_crossings.size());
      m_crossings.push_back({h, curve, at, -1, at_end ? 1. : 0., -1});
      list.insert(at_end ? list.end() : list.begin(), x);
      number(list, at_end ? static_cast<Index>(list.size()) - 1 : 0);
      m_crossings[at].next = x;
      at = x;
    }
    m_crossings[at].next = undo.after;
    m_crossings[undo.after].prev = at;
    m_first[curve] = undo.after;
    return [this, undo = std::move(undo)]() {
      for (auto i = undo.lists.rbegin(); i != undo.lists.rend(); ++i)
      {
        auto& list = make_list(i->first);
        list = i->second;
        number(list, 0);
      }
      m_crossings[undo.before].next = undo.first;
      m_crossings[undo.after].prev = undo.last;
      m_first[undo.curve] = undo.curve_first;
      m_crossings.resize(undo.size);
    };
  }

  /// \returns the face in which a curve runs from `x` to the crossing after it
  Index face_after(Id x) const { return m_surface.face(m_surface.opposite[m_crossings[x].halfedge]); }
  /// \returns the other end of the chord that begins or ends at `x` in `face`
  Id across(Id x, Index face) const
  { return m_surface.face(m_crossings[x].halfedge) == face ? m_crossings[x].prev : m_crossings[x].next; }
  /// \returns where an end of a chord of `face` stands in the order around it
  std::int64_t around(Id x, Index face) const
  {
    const Index h = side(x, face), e = m_surface.edge(h), k = m_crossings[x].place;
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
        if (m_crossings[y].curve == partner(m_crossings[x].curve) && m_crossings[y].halfedge != h && alternate(x, y, face)) { return y; }
    return -1;
  }
  /// \returns how often a curve crosses its partner in one face
  Index count_in_face(Index curve, Index face) const
  {
    Index count = 0;
    for (Index h = 3 * face; h < 3 * face + 3; ++h)
      for (Id x : on(m_surface.edge(h)))
      {
        if (m_crossings[x].curve != curve || m_crossings[x].halfedge == h) { continue; }
        for (Index g = 3 * face; g < 3 * face + 3; ++g)
          for (Id y : on(m_surface.edge(g)))
            count += m_crossings[y].curve == partner(curve) && m_crossings[y].halfedge != g && alternate(x, y, face);
      }
    return count;
  }
  /// \returns a face where a curve crosses its partner, or -1
  Index meeting(Index curve) const { return m_meeting[curve / 2]; }
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

  /// \returns whether a curve that crosses its partner once crosses it from right to left
  bool runs_from_right(Index curve) const
  {
    const Index face = meeting(curve);
    for (Id x : crossings(curve))
    {
      if (face < 0 || face_after(x) != face) { continue; }
      const Id end = m_crossings[x].next, y = crossed_by(end, face); // the partner enters the face at y
      if (y < 0) { continue; }
      const std::int64_t from = around(y, face), to = around(across(y, face), face), at = around(end, face);
      return from < to ? at < from || at > to : to < at && at < from; // counterclockwise from where it leaves to where it enters
    }
    return false;
  }

  /// calls `visit(gap, x)` for the gaps of the region of `face` that `gap` lies on, counterclockwise: `x` is the end of the chord
  /// that comes after the gap, or -1 if a corner does. The region lies to the left of the way from `x` into the face.
  template <class Visit> void for_each_gap_around(const Gap& gap, Index face, Visit visit) const
  {
    Index h = 3 * face;
    while (m_surface.edge(h) != gap.edge) { ++h; }
    const auto size = [&](Index g) { return static_cast<Index>(on(m_surface.edge(g)).size()); };
    const auto turned = [&](Index g, Index k) { return m_surface.edge(g) == g ? k : size(g) - k; }; // places along a halfedge
    const Index first = h, first_place = turned(h, gap.place);
    Index k = first_place;
    do
    {
      const auto& list = on(m_surface.edge(h));
      const Index n = static_cast<Index>(list.size());
      if (k == n)
      {
        visit(Gap{m_surface.edge(h), turned(h, k)}, Id(-1));
        h = m_surface.next(h);
        k = 0;
        continue;
      }
      const Id x = list[m_surface.edge(h) == h ? k : n - 1 - k];
      visit(Gap{m_surface.edge(h), turned(h, k)}, x);
      Id end = across(x, face);
      const Id other = meeting(m_crossings[x].curve) == face ? crossed_by(x, face) : -1;
      if (other >= 0) // go on along the partner, to its end on the left
      {
        const std::int64_t a = around(x, face), b = around(end, face), c = around(other, face);
        const bool is_left = b < a ? b < c && c < a : c > b || c < a;
        end = is_left ? other : across(other, face);
      }
      h = side(end, face);
      k = turned(h, m_crossings[end].place); // one crossing further; for a turned edge, the gap before it
      if (m_surface.edge(h) == h) { ++k; }
    } while (h != first || k != first_place);
  }

private:
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
        const auto& list = on(m_surface.edge(h));
        for (std::size_t i = 0; i < list.size(); ++i)
        {
          const Id x = list[m_surface.edge(h) == h ? i : list.size() - 1 - i], y = across(x, face);
          if (edge(x) == edge(y)) { return false; }
          if (side(y, face) > h) { open.push_back(x); continue; }
          if (!open.empty() && open.back() == y) { open.pop_back(); continue; }
          if (open.size() < 2 || open[open.size() - 2] != y || m_crossings[open.back()].curve != partner(m_crossings[x].curve)) { return false; }
          ++count[m_crossings[x].curve / 2];
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
    const Index h = m_crossings[x].halfedge;
    return m_surface.face(h) == face ? h : m_surface.opposite[h];
  }
  std::vector<Id>& make_list(Index e)
  {
    if (m_slot[e] < 0)
    {
      m_slot[e] = static_cast<Index>(m_lists.size());
      m_lists.emplace_back();
    }
    return m_lists[m_slot[e]];
  }
  void unlist(Id x)
  {
    auto& list = m_lists[m_slot[edge(x)]];
    list.erase(list.begin() + m_crossings[x].place);
    number(list, m_crossings[x].place);
  }
  void number(const std::vector<Id>& list, Index from)
  { for (std::size_t i = from; i < list.size(); ++i) { m_crossings[list[i]].place = static_cast<Index>(i); } }

  const Triangle_surface& m_surface;
  std::vector<Crossing> m_crossings;
  std::vector<Id> m_first;               // of each curve, -1 if it is not there
  std::vector<Index> m_meeting;          // of each pair: the face where its chords cross, or -1
  std::vector<Index> m_slot;             // of each edge: its list, or -1
  std::vector<std::vector<Id>> m_lists;
  std::vector<Id> m_none;                // the list of an edge that has none
};

} // namespace meridian

#endif // MERIDIAN_NORMAL_CURVES_H
