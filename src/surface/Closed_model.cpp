// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/surface/Closed_model.h>

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
  g.begin.assign(g.number_of_nodes + 1, 0);
  const Index halfedges = s.number_of_halfedges();
  for (Index h = 0; h < halfedges; ++h)
    if (s.opposite[h] >= 0) { ++g.begin[g.node[s.source(h)] + 1]; }
  for (Index a = 0; a < g.number_of_nodes; ++a) { g.begin[a + 1] += g.begin[a]; }
  g.halfedge.resize(g.begin.back());
  g.neighbor.resize(g.begin.back());
  std::vector<Index> fill(g.begin.begin(), g.begin.end() - 1);
  for (Index h = 0; h < halfedges; ++h)
    if (s.opposite[h] >= 0)
    {
      const Index i = fill[g.node[s.source(h)]]++;
      g.halfedge[i] = h;
      g.neighbor[i] = g.node[s.target(h)];
    }
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
