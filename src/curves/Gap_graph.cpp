// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/curves/Gap_graph.h>

#include <meridian/curves/chords.h>

#include <algorithm>

namespace meridian {

namespace internal {

namespace {

// About how far nodes are apart, where no curves are: half of an edge.
double mean_step(const Triangle_surface& s)
{
  double sum = 0;
  for (Index h = 0; h < s.number_of_halfedges(); ++h) { sum += distance(s.points[s.source(h)], s.points[s.target(h)]); }
  return sum / (2. * std::max<Index>(s.number_of_halfedges(), 1));
}

} // namespace

Gap_graph::Gap_graph(const Normal_curves& curves)
  : m_curves(curves), m_surface(curves.surface()), m_first(curves.surface().number_of_halfedges(), -1),
    m_rings(mean_step(curves.surface()))
{}

Gap_graph::Node Gap_graph::node(const Gap& g)
{
  Node& first = m_first[g.edge];
  if (first < 0)
  {
    first = static_cast<Node>(m_nodes.size());
    const auto gaps = static_cast<Index>(m_curves.on(g.edge).size()) + 1;
    for (Gap own{g.edge, 0}; own.place < gaps; ++own.place)
    {
      m_nodes.push_back({m_surface.point_on(own.edge, middle_of(m_curves, own)), {}, {-1, -1}, {-1, -1}, own.edge, 0});
    }
  }
  return first + g.place;
}

Index Gap_graph::region(Node n, bool is_opposite)
{
  const Index known = m_nodes[n].regions[is_opposite], edge = m_nodes[n].edge;
  return known >= 0 ? known : trace_region(n, m_surface.face(is_opposite ? m_surface.opposite[edge] : edge));
}

Index Gap_graph::trace_region(Node n, Index face)
{
  const auto region = static_cast<Index>(m_members.size());
  m_members.insert(m_members.end(), {face, 0});
  const Gap from = gap(n);
  for_each_gap_around(m_curves, from, face, [&](const Gap& g, Index) {
    if (m_surface.opposite[g.edge] < 0 || m_curves.along(g.edge) >= 0) { return; }
    const Node member = node(g);
    m_nodes[member].regions[m_surface.face(g.edge) != face] = region;
    m_members.push_back(member);
    ++m_members[region + 1];
  });
  return region;
}

void Gap_graph::forget_around(Index curve)
{
  for (Index x : m_curves.crossings(curve)) { forget_edge(m_curves.edge(x)); }
  if (2 * m_forgotten >= m_nodes.size()) { forget(); }
}

void Gap_graph::forget()
{
  m_first.assign(m_first.size(), -1);
  m_nodes.clear();
  m_members.clear();
  m_forgotten = 0;
  clear();
}

void Gap_graph::forget_edge(Index edge)
{
  for (Index side : {edge, m_surface.opposite[edge]})
    for (Index h : {m_surface.next(side), m_surface.prev(side)})
    {
      const Index e = m_surface.edge(h);
      if (m_first[e] < 0) { continue; }
      for (Node n = m_first[e]; n < static_cast<Node>(m_nodes.size()) && m_nodes[n].edge == e; ++n)
      {
        m_nodes[n].regions[m_surface.face(e) != m_surface.face(side)] = -1;
      }
    }
  for (Node n = m_first[edge]; n >= 0 && n < static_cast<Node>(m_nodes.size()) && m_nodes[n].edge == edge; ++n)
  {
    ++m_forgotten;
  }
  m_first[edge] = -1;
}

} // namespace internal

} // namespace meridian
