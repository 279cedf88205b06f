// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/surface/open_along.h>

#include <algorithm>

namespace meridian {

Opened_surface open_along(const Refined_surface& s)
{
  Opened_surface opened;
  opened.triangles = s.triangles;
  const Index n = s.number_of_vertices();
  std::vector<char> has_seam(n, 0);
  for (Index h = 0; h < s.number_of_halfedges(); ++h)
    if (s.seam[h])
    {
      has_seam[s.source(h)] = 1;
      if (s.edge(h) == h) { opened.seams.push_back({h, s.opposite[h]}); }
    }
  std::vector<std::vector<Index>> sectors; // of corners
  for (Index v = 0; v < n; ++v)
  {
    if (!has_seam[v]) { continue; }
    sectors.clear();
    s.for_each_outgoing(v, [&](Index h) {
      if (sectors.empty() || s.seam[h]) { sectors.emplace_back(); }
      sectors.back().push_back(h);
    });
    const Index first = sectors.front().front();
    if (!s.is_boundary_vertex(v) && !s.seam[first] && sectors.size() > 1) // the walk began inside a sector
    {
      sectors.front().insert(sectors.front().begin(), sectors.back().begin(), sectors.back().end());
      sectors.pop_back();
    }
    std::size_t keeper = 0;
    for (std::size_t i = 1; i < sectors.size(); ++i)
      if (*std::min_element(sectors[i].begin(), sectors[i].end())
          < *std::min_element(sectors[keeper].begin(), sectors[keeper].end()))
      {
        keeper = i;
      }
    for (std::size_t i = 1; i < sectors.size(); ++i)
    {
      const Index copy = n + static_cast<Index>(opened.copy_of.size());
      for (Index h : sectors[(keeper + i) % sectors.size()]) { opened.triangles[s.face(h)][h % 3] = copy; }
      opened.copy_of.push_back(v);
    }
  }
  return opened;
}

Triangle_surface surface_of(const Refined_surface& s, const Opened_surface& opened)
{
  Triangle_surface o;
  o.triangles = opened.triangles;
  o.points = s.points;
  for (Index v : opened.copy_of) { o.points.push_back(s.points[v]); }
  connect(o);
  return o;
}

} // namespace meridian
