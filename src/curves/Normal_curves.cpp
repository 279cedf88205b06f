// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/curves/Normal_curves.h>

#include <meridian/curves/chords.h>

#include <algorithm>
#include <numeric>
#include <tuple>

namespace meridian {

void Normal_curves::add(Index curve, const std::vector<Crossing>& steps)
{
  link_new(curve, steps);
  const Id first = nearest({curve, false}), last = nearest({curve, true});
  m_store.join(curve, last, first);
  m_store.edit_curve(curve).first = first;
  if (partner(curve) >= number_of_curves() || !is_present(partner(curve))) { return; }
  for (Id x : crossings(curve))
    if (count_in_face(*this, curve, face_after(*this, x)) > 0) { set_meeting(curve, face_after(*this, x)); }
}

Index Normal_curves::add(Index from, Index to, const std::vector<Crossing>& steps)
{
  const Index curve = m_store.append_curve();
  link_new(curve, steps);
  m_store.set_end({curve, false}, from);
  m_store.set_end({curve, true}, to);
  if (steps.empty()) { m_store.lay_along(curve); }
  return curve;
}

void Normal_curves::remove(Index curve)
{
  if (meeting(curve) >= 0) { set_meeting(curve, -1); }
  m_store.remove(curve);
}

void Normal_curves::reroute(Id first, Id last, const std::vector<Index>& halfedges, bool at_target)
{
  m_store.reroute(first, last, halfedges, at_target);
}

void Normal_curves::extend(const End& end, Index to, const std::vector<Index>& halfedges, Index around)
{
  m_store.extend(end, to, halfedges, around);
}

bool Normal_curves::has_changed_at(Index v, std::uint64_t since) const
{
  const auto& ends = ends_at(v);
  return std::any_of(ends.begin(), ends.end(), [&](const End& e) {
    return m_store.has_changed(e.curve, since) || m_store.has_changed_beside(e.curve, since);
  });
}

void Normal_curves::set_tight(Index curve, double length)
{
  if (m_tight.size() <= static_cast<std::size_t>(curve)) { m_tight.resize(number_of_curves(), {0, -1}); }
  m_tight[curve] = {m_store.clock(), length};
}

std::optional<double> Normal_curves::tight_length(Index curve) const
{
  if (m_tight.size() <= static_cast<std::size_t>(curve)) { return {}; }
  const auto [since, length] = m_tight[curve];
  const Index other = partner(curve);
  if (length < 0 || m_store.has_changed(curve, since) || m_store.has_changed_beside(curve, since)) { return {}; }
  if (meeting(curve) >= 0 && m_store.has_changed(other, since)) { return {}; }
  return length;
}

void Normal_curves::link_new(Index curve, const std::vector<Crossing>& steps)
{
  std::vector<std::size_t> order(steps.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  const auto key = [&](std::size_t i) {
    return std::make_tuple(surface().edge(steps[i].halfedge), steps[i].place, steps[i].t, i);
  };
  // from the end, so that places stay
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key(a) > key(b); });
  std::vector<Id> ids(steps.size());
  for (std::size_t i : order) { ids[i] = m_store.append(steps[i].halfedge, curve, steps[i].t, steps[i].place); }
  Id at = -1;
  for (Id x : ids)
  {
    m_store.join(curve, at, x);
    at = x;
  }
  m_store.join(curve, at, -1);
}

} // namespace meridian
