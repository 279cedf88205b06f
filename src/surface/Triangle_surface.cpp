// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/surface/Triangle_surface.h>

#include <meridian/base/exceptions.h>
#include <meridian/base/group_by.h>

#include <algorithm>
#include <utility>

namespace meridian {

Index Triangle_surface::find_halfedge(Index u, Index v) const
{
  Index found = -1;
  for_each_outgoing(u, [&](Index h) {
    if (target(h) == v) { found = h; }
  });
  return found;
}

Point Triangle_surface::point_on(Index h, double t) const
{
  const Point &a = points[source(h)], &b = points[target(h)];
  return a + t * (b - a);
}

void find_outgoing(Triangle_surface& s)
{
  s.outgoing.assign(s.number_of_vertices(), -1);
  for (Index h = 0; h < s.number_of_halfedges(); ++h)
    if (s.outgoing[s.source(h)] < 0 || s.opposite[h] < 0) { s.outgoing[s.source(h)] = h; }
}

void connect(Triangle_surface& s)
{
  const Index n = s.number_of_vertices(), halfedges = s.number_of_halfedges();
  const Groups by_lower = group_by(n, halfedges, [&](Index h) { return std::min(s.source(h), s.target(h)); });
  s.opposite.assign(halfedges, -1);
  std::vector<std::pair<Index, Index>> around; // (upper vertex, halfedge)
  for (Index v = 0; v < n; ++v)
  {
    around.clear();
    for (Index i = by_lower.begin[v]; i < by_lower.begin[v + 1]; ++i)
    {
      const Index h = by_lower.element[i];
      around.emplace_back(std::max(s.source(h), s.target(h)), h);
    }
    std::sort(around.begin(), around.end());
    for (std::size_t i = 0; i + 1 < around.size(); ++i)
    {
      if (around[i].first != around[i + 1].first) { continue; }
      const Index g = around[i].second, h = around[i + 1].second;
      if (s.source(g) == s.source(h) || s.opposite[g] >= 0)
        throw Internal_error("connect: an edge has two faces on one side");
      s.opposite[g] = h;
      s.opposite[h] = g;
    }
  }
  find_outgoing(s);
}

std::vector<std::vector<Index>> boundary_loops(const Triangle_surface& s)
{
  std::vector<std::vector<Index>> loops;
  std::vector<char> seen(s.number_of_vertices(), 0);
  for (Index v = 0; v < s.number_of_vertices(); ++v)
  {
    if (seen[v] || s.outgoing[v] < 0 || !s.is_boundary_vertex(v)) { continue; }
    loops.emplace_back();
    for (Index u = v; !seen[u]; u = s.target(s.outgoing[u]))
    {
      seen[u] = 1;
      loops.back().push_back(s.outgoing[u]);
    }
  }
  return loops;
}

} // namespace meridian
