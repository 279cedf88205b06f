// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/field/critical_points.h>

#include <meridian/surface/Closed_model.h>

namespace meridian {

std::vector<Critical_point> find_critical_points(const Triangle_surface& s, const std::vector<Index>& rank)
{
  std::vector<Critical_point> found;
  std::vector<char> seen(s.number_of_vertices(), 0);
  for (Index v = 0; v < s.number_of_vertices(); ++v)
  {
    if (s.is_boundary_vertex(v))
    {
      if (seen[v]) { continue; }
      for (Index u = v; !seen[u]; u = s.target(s.outgoing[u])) { seen[u] = 1; }
    }
    int changes = 0, first = -1, last = -1;
    for_each_around_node(s, v, [&](Index h) {
      const int higher = rank[s.target(h)] > rank[v];
      if (first < 0) { first = higher; }
      else if (higher != last) { ++changes; }
      last = higher;
    });
    if (first != last) { ++changes; }
    if (changes == 2) { continue; }
    if (changes == 0) { found.push_back({v, first == 1 ? Critical_kind::MINIMUM : Critical_kind::MAXIMUM, 1}); }
    else { found.push_back({v, Critical_kind::SADDLE, changes / 2 - 1}); }
  }
  return found;
}

Critical_counts count(const std::vector<Critical_point>& points)
{
  Critical_counts c;
  for (const auto& p : points) switch (p.kind)
    {
    case Critical_kind::MINIMUM: ++c.minima; break;
    case Critical_kind::MAXIMUM: ++c.maxima; break;
    case Critical_kind::SADDLE: c.saddles += p.multiplicity; break;
    }
  return c;
}

} // namespace meridian
