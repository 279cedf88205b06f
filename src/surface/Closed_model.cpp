// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/surface/Closed_model.h>

#include <meridian/base/group_by.h>

#include <utility>

namespace meridian {

Closed_model make_closed_model(const Triangle_surface& s)
{
  Closed_model g;
  const Index n = s.number_of_vertices();
  g.node.assign(n, -1);
  for (Index v = 0; v < n; ++v)
    if (!s.is_boundary_vertex(v))
    {
      g.node[v] = g.number_of_nodes++;
      g.representative.push_back(v);
    }
  g.first_loop_node = g.number_of_nodes;
  for (const auto& loop : boundary_loops(s))
  {
    for (Index h : loop) { g.node[s.source(h)] = g.number_of_nodes; }
    ++g.number_of_nodes;
    g.representative.push_back(s.source(loop.front()));
  }
  Groups edges = group_by(g.number_of_nodes, s.number_of_halfedges(),
                          [&](Index h) { return s.opposite[h] < 0 ? -1 : g.node[s.source(h)]; });
  g.begin = std::move(edges.begin);
  g.halfedge = std::move(edges.element);
  g.neighbor.reserve(g.halfedge.size());
  for (Index h : g.halfedge) { g.neighbor.push_back(g.node[s.target(h)]); }
  return g;
}

std::vector<Index> chords_of_loops(const Triangle_surface& s, const Closed_model& g)
{
  std::vector<Index> chords;
  for (Index h = 0; h < s.number_of_halfedges(); ++h)
    if (s.opposite[h] > h && g.node[s.source(h)] == g.node[s.target(h)]) { chords.push_back(h); }
  return chords;
}

} // namespace meridian
