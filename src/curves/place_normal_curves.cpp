// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/curves/place_normal_curves.h>

#include <meridian/base/exceptions.h>
#include <meridian/curves/chords.h>
#include <meridian/curves/place_crossings.h>
#include <meridian/surface/Triangle_surface.h>

#include <algorithm>
#include <cmath>

namespace meridian {

namespace internal {

Meeting find_meeting(const Normal_curves& curves, Index c)
{
  const Index face = curves.meeting(c);
  for (Index x : curves.crossings(c))
  {
    if (face < 0 || face_after(curves, x) != face) { continue; }
    const Index end = curves[x].next, y = partner_across(curves, end, face);
    if (y < 0) { continue; }
    for (Index a : {x, end})
      for (Index b : {y, chord_across(curves, y, face)})
        if (curves.edge(a) == curves.edge(b) && std::abs(curves[a].place - curves[b].place) == 1) { return {a, b}; }
    throw Internal_error("find_meeting: something stands between two curves that cross");
  }
  return {};
}

std::vector<Surface_curve> place_normal_curves(const Normal_curves& curves)
{
  const Triangle_surface& s = curves.surface();
  std::vector<std::vector<Piece_crossing>> all(curves.number_of_curves());
  for (Index c = 0; c < curves.number_of_curves(); ++c)
  {
    const Index p = Normal_curves::partner(c);
    const bool has_partner = p < curves.number_of_curves() && curves.is_present(c) && curves.is_present(p);
    const Meeting meeting = has_partner ? find_meeting(curves, std::min(c, p)) : Meeting{};
    for (Index x : curves.crossings(c))
    {
      Piece_crossing crossing{curves[x], curves.edge(x)};
      if (x == meeting.x || x == meeting.y)
      {
        crossing.node = c / 2;
        crossing.t = (curves[meeting.x].t + curves[meeting.y].t) / 2;
      }
      all[c].push_back(crossing);
    }
  }
  return place_crossings(s, all, true, [&](Index v) { return !s.is_boundary_vertex(v); });
}

} // namespace internal

} // namespace meridian
