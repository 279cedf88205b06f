// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/curves/Normal_curves.h>

#include <meridian/base/exceptions.h>

#include <algorithm>
#include <numeric>
#include <tuple>

namespace meridian {

void Normal_curves::add(Index curve, const std::vector<Step>& steps)
{
  link_new(curve, steps);
  const Id first = nearest({curve, false}), last = nearest({curve, true});
  join(curve, last, first);
  edit_curve(curve).first = first;
  find_meeting(curve);
}

Index Normal_curves::add(Index from, Index to, const std::vector<Step>& steps)
{
  const Index curve = append_curve();
  link_new(curve, steps);
  set_end({curve, false}, from);
  set_end({curve, true}, to);
  if (steps.empty()) { lay_along(curve); }
  return curve;
}

void Normal_curves::remove(Index curve)
{
  if (meeting(curve) >= 0) { set_meeting(curve, -1); }
  Crossing_store::remove(curve);
}

std::vector<Index> Normal_curves::count_crossings() const
{
  std::vector<Index> faces, count(number_of_pairs(), 0);
  for (Index c = 0; c < number_of_curves(); ++c)
    for (Id x : crossings(c)) { faces.push_back(face_after(x)); }
  if (!count_in_faces(faces, count)) { throw Internal_error("count_crossings: two curves cross that should not"); }
  return count;
}

bool Normal_curves::crosses_partner_once(Index curve) const
{
  std::vector<Index> faces, count(number_of_pairs(), 0);
  for (Id x : crossings(curve)) { faces.push_back(face_after(x)); }
  return count_in_faces(faces, count) && count[curve / 2] == 1;
}

bool Normal_curves::is_disjoint(Index curve) const
{
  std::vector<Index> faces, count(number_of_pairs(), 0);
  for (Id x : crossings(curve))
    for (Index h : {(*this)[x].halfedge, m_surface.opposite[(*this)[x].halfedge]})
    {
      faces.push_back(m_surface.face(h));
    }
  return count_in_faces(faces, count)
         && (count.empty() || curve / 2 >= static_cast<Index>(count.size()) || count[curve / 2] == 0);
}

bool Normal_curves::runs_from_right(Index curve) const
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

bool Normal_curves::count_in_faces(std::vector<Index>& faces, std::vector<Index>& count) const
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

void Normal_curves::find_meeting(Index curve)
{
  if (partner(curve) >= number_of_curves() || !is_present(partner(curve))) { return; }
  for (Id x : crossings(curve))
    if (count_in_face(curve, face_after(x)) > 0) { set_meeting(curve, face_after(x)); }
}

void Normal_curves::link_new(Index curve, const std::vector<Step>& steps)
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

namespace internal {

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

} // namespace internal

} // namespace meridian
