// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/cut/internal/disc_walk.h>

#include <meridian/cut/internal/network_moves.h>
#include <meridian/surface/Triangle_surface.h>

#include <algorithm>
#include <array>
#include <unordered_map>

namespace meridian {

namespace internal {

std::vector<Disc_side> walk_around(const Normal_curves& curves, std::vector<std::size_t>& begin)
{
  const Triangle_surface& s = curves.surface();
  std::unordered_map<Index, Network_star> stars;
  const auto star_of = [&](Index v) -> const Network_star& {
    const auto [at, is_new] = stars.try_emplace(v);
    if (is_new) { at->second = make_star(curves, v); }
    return at->second;
  };
  std::vector<std::array<char, 2>> is_done(curves.number_of_curves(), {0, 0});
  std::vector<Disc_side> sides;
  begin.clear();
  for (Index c = 0; c < curves.number_of_curves(); ++c)
    for (bool forward : {true, false})
    {
      if (!curves.is_open(c) || is_done[c][forward]) { continue; }
      begin.push_back(sides.size());
      Network_end out{c, !forward}; // by which the next side is left
      while (!is_done[out.curve][!out.is_last])
      {
        is_done[out.curve][!out.is_last] = 1;
        const Network_end in{out.curve, !out.is_last};
        Index v = curves.vertex(in);
        sides.push_back({in.curve, in.is_last, v});
        const Network_star* star = &star_of(v);
        std::size_t i = std::find_if(star->arms.begin(), star->arms.end(), [&](const auto& a) { return a.end == in; })
                        - star->arms.begin();
        if (i == 0 && !star->is_closed)
        {
          do {
            v = s.target(s.outgoing[v]);
          } while (curves.ends_at(v).empty());
          sides.push_back({-1, true, v});
          star = &star_of(v);
          i = star->arms.size();
        }
        out = star->arms[(i + star->arms.size() - 1) % star->arms.size()].end;
      }
    }
  return sides;
}

} // namespace internal

} // namespace meridian
