// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/curves/chords.h>

#include <meridian/base/exceptions.h>

#include <algorithm>

namespace meridian {

namespace internal {

std::int64_t around(const Normal_curves& curves, Index x, Index face)
{
  const Triangle_surface& s = curves.surface();
  const Index h = side(curves, x, face), e = s.edge(h), k = curves[x].place;
  const Index along = h == e ? k : static_cast<Index>(curves.on(e).size()) - 1 - k;
  return (static_cast<std::int64_t>(h % 3) << 32) + along;
}

Index side(const Normal_curves& curves, Index x, Index face)
{
  const Triangle_surface& s = curves.surface();
  const Index h = curves[x].halfedge;
  return s.face(h) == face ? h : s.opposite[h];
}

Index count_before_corner(const Normal_curves& curves, Index h, Index face)
{
  const Triangle_surface& s = curves.surface();
  if (!curves.has_open_curves()) { return 0; }
  const auto& list = curves.on(s.edge(h));
  const Index n = static_cast<Index>(list.size());
  for (Index k = n; k-- > 0;)
    if (chord_across(curves, list[s.edge(h) == h ? k : n - 1 - k], face) < 0) { return k + 1; }
  return 0;
}

namespace {

bool alternate(const Normal_curves& curves, Index x, Index y, Index face)
{
  const std::int64_t a = around(curves, x, face), b = around(curves, chord_across(curves, x, face), face);
  const std::int64_t c = around(curves, y, face), d = around(curves, chord_across(curves, y, face), face);
  const auto inside = [&](std::int64_t p) { return std::min(a, b) < p && p < std::max(a, b); };
  return inside(c) != inside(d);
}

// Adds up how often partners cross in one face. False if other chords do, or if one has both ends on one edge.
bool match_chords(const Normal_curves& curves, Index face, std::vector<Index>& count)
{
  const Triangle_surface& s = curves.surface();
  std::vector<Index> open; // chords whose second end is still to come, by their first
  for (Index h = 3 * face; h < 3 * face + 3; ++h)
  {
    const auto close = [&](Index x) {
      if (open.empty() || open.back() != x) { return false; }
      open.pop_back();
      return true;
    };
    // chords from there may end at the corner that comes first
    const auto& beyond = curves.on(s.edge(s.next(h)));
    for (std::size_t i = 0; i < beyond.size() && curves.has_open_curves(); ++i)
    {
      const Index x = beyond[s.edge(s.next(h)) == s.next(h) ? beyond.size() - 1 - i : i];
      if (chord_across(curves, x, face) >= 0) { continue; }
      if (h % 3 < 2) { open.push_back(x); }
      else if (!close(x)) { return false; }
    }
    const auto& list = curves.on(s.edge(h));
    for (std::size_t i = 0; i < list.size(); ++i)
    {
      const Index x = list[s.edge(h) == h ? i : list.size() - 1 - i], y = chord_across(curves, x, face);
      if (y < 0)
      {
        if (h % 3 == 0) { open.push_back(x); }
        else if (!close(x)) { return false; }
        continue;
      }
      if (curves.edge(x) == curves.edge(y)) { return false; }
      if (side(curves, y, face) > h)
      {
        open.push_back(x);
        continue;
      }
      if (!open.empty() && open.back() == y)
      {
        open.pop_back();
        continue;
      }
      if (open.size() < 2 || curves[x].curve / 2 >= static_cast<Index>(count.size()) || open[open.size() - 2] != y
          || curves[open.back()].curve != Normal_curves::partner(curves[x].curve))
      {
        return false;
      }
      ++count[curves[x].curve / 2];
      open.erase(open.end() - 2);
    }
  }
  return open.empty();
}

// The same in several faces.
bool count_in_faces(const Normal_curves& curves, std::vector<Index>& faces, std::vector<Index>& count)
{
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return std::all_of(faces.begin(), faces.end(), [&](Index face) { return match_chords(curves, face, count); });
}

} // namespace

} // namespace internal

Gap gap_beside(const Normal_curves& curves, Index x, bool left)
{
  const Triangle_surface& s = curves.surface();
  const Index h = curves[x].halfedge, e = s.edge(h), k = curves[x].place;
  return {e, (left == (h == e)) ? k + 1 : k}; // the target of `h` is on the left
}

double middle_of(const Normal_curves& curves, const Gap& g)
{
  const auto& list = curves.on(g.edge);
  const double from = g.place == 0 ? 0 : curves[list[g.place - 1]].t;
  const double to = g.place == static_cast<Index>(list.size()) ? 1 : curves[list[g.place]].t;
  return (from + to) / 2;
}

Index partner_across(const Normal_curves& curves, Index x, Index face)
{
  const Triangle_surface& s = curves.surface();
  for (Index h = 3 * face; h < 3 * face + 3; ++h)
    for (Index y : curves.on(s.edge(h)))
      if (curves[y].curve == Normal_curves::partner(curves[x].curve) && curves[y].halfedge != h
          && internal::alternate(curves, x, y, face))
      {
        return y;
      }
  return -1;
}

Index count_in_face(const Normal_curves& curves, Index curve, Index face)
{
  const Triangle_surface& s = curves.surface();
  Index count = 0;
  for (Index h = 3 * face; h < 3 * face + 3; ++h)
    for (Index x : curves.on(s.edge(h)))
    {
      if (curves[x].curve != curve || curves[x].halfedge == h) { continue; }
      for (Index g = 3 * face; g < 3 * face + 3; ++g)
        for (Index y : curves.on(s.edge(g)))
          count += curves[y].curve == Normal_curves::partner(curve) && curves[y].halfedge != g
                   && internal::alternate(curves, x, y, face);
    }
  return count;
}

std::vector<Index> count_crossings(const Normal_curves& curves)
{
  std::vector<Index> faces, count(curves.number_of_pairs(), 0);
  for (Index c = 0; c < curves.number_of_curves(); ++c)
    for (Index x : curves.crossings(c)) { faces.push_back(face_after(curves, x)); }
  if (!internal::count_in_faces(curves, faces, count))
  {
    throw Internal_error("count_crossings: two curves cross that should not");
  }
  return count;
}

bool crosses_partner_once(const Normal_curves& curves, Index curve)
{
  std::vector<Index> faces, count(curves.number_of_pairs(), 0);
  for (Index x : curves.crossings(curve)) { faces.push_back(face_after(curves, x)); }
  return internal::count_in_faces(curves, faces, count) && count[curve / 2] == 1;
}

bool runs_from_right(const Normal_curves& curves, Index curve)
{
  const Index face = curves.meeting(curve);
  for (Index x : curves.crossings(curve))
  {
    if (face < 0 || face_after(curves, x) != face) { continue; }
    const Index end = curves[x].next, y = partner_across(curves, end, face); // the partner enters the face at y
    if (y < 0) { continue; }
    const std::int64_t from = internal::around(curves, y, face),
                       to = internal::around(curves, chord_across(curves, y, face), face),
                       at = internal::around(curves, end, face);
    // counterclockwise from where it leaves to where it enters
    return from < to ? at < from || at > to : to < at && at < from;
  }
  return false;
}

double length(const Normal_curves& curves, Index c)
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

} // namespace meridian
