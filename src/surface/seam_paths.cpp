// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/surface/seam_paths.h>

namespace meridian {

std::vector<std::vector<Index>> seam_paths(const Refined_surface& s)
{
  std::vector<int> degree(s.number_of_vertices(), 0);
  for (Index h = 0; h < s.number_of_halfedges(); ++h)
    if (s.seam[h] && s.edge(h) == h)
    {
      ++degree[s.source(h)];
      ++degree[s.target(h)];
    }
  std::vector<char> is_node(s.number_of_vertices(), 0), is_done(s.number_of_halfedges(), 0);
  for (Index v = 0; v < s.number_of_vertices(); ++v)
  {
    is_node[v] = degree[v] > 0 && (degree[v] != 2 || s.is_boundary_vertex(v));
  }
  std::vector<std::vector<Index>> paths;
  const auto trace = [&](Index h) {
    auto& path = paths.emplace_back(1, s.source(h));
    for (;;)
    {
      is_done[h] = is_done[s.opposite[h]] = 1;
      const Index v = s.target(h), back = s.opposite[h];
      path.push_back(v);
      if (is_node[v] || v == path.front()) { return; }
      s.for_each_outgoing(v, [&](Index k) {
        if (s.seam[k] && k != back) { h = k; }
      });
    }
  };
  for (const bool is_circle : {false, true})
    for (Index v = 0; v < s.number_of_vertices(); ++v)
      if (degree[v] > 0 && (is_circle || is_node[v]))
        s.for_each_outgoing(v, [&](Index h) {
          if (s.seam[h] && !is_done[h]) { trace(h); }
        });
  return paths;
}

} // namespace meridian
