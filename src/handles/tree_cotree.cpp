// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/handles/internal/tree_cotree.h>

#include <meridian/base/Union_find.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace meridian {

namespace internal {

Tree_cotree::Tree_cotree(const Triangle_surface& s) : m_surface(s), m_outside(s.number_of_faces())
{
  Union_find vertices(s.number_of_vertices()), faces(m_outside + 1);
  // of a face: halfedges of other faces, across edges of its tree
  std::vector<std::vector<Index>> around(m_outside + 1);
  for (Index h = 0; h < s.number_of_halfedges(); ++h)
  {
    if (s.edge(h) != h || vertices.unite(s.source(h), s.target(h))) { continue; }
    const Index o = s.opposite[h], g = o < 0 ? m_outside : s.face(o);
    if (!faces.unite(s.face(h), g))
    {
      m_edges.push_back(h);
      continue;
    }
    around[g].push_back(h);
    if (o >= 0) { around[s.face(h)].push_back(o); }
  }
  m_tour = walk_tree(around, around[m_outside].empty() ? 0 : m_outside, s.number_of_halfedges(),
                     [&](Index h) { return s.face(h); });
  for (std::size_t i = 0; i < m_edges.size(); ++i)
  {
    const Index o = s.opposite[m_edges[i]];
    m_visits.push_back({m_tour.enter[s.face(m_edges[i])], static_cast<Index>(i), 1});
    m_visits.push_back({m_tour.enter[o < 0 ? m_outside : s.face(o)], static_cast<Index>(i), -1});
  }
  std::sort(m_visits.begin(), m_visits.end(), [](const Visit& a, const Visit& b) { return a.time < b.time; });
}

std::vector<int> Tree_cotree::integrate(const std::vector<std::pair<Index, int>>& flow) const
{
  std::vector<int> sums(m_edges.size(), 0);
  std::vector<std::pair<Index, int>> steps; // where on the tour of the faces' tree the sum changes
  for (const auto& [e, amount] : flow)
  {
    const auto own = std::lower_bound(m_edges.begin(), m_edges.end(), e);
    if (own != m_edges.end() && *own == e) { sums[own - m_edges.begin()] += amount; }
    for (Index h : {e, m_surface.opposite[e]})
    {
      if (h < 0 || !m_tour.is_down[h]) { continue; } // down into the face of `h`
      const int into = h == e ? -amount : amount;
      steps.emplace_back(m_tour.enter[m_surface.face(h)], into);
      steps.emplace_back(m_tour.leave[m_surface.face(h)], -into);
    }
  }
  std::sort(steps.begin(), steps.end());
  int sum = 0;
  auto step = steps.begin();
  for (const Visit& visit : m_visits)
  {
    for (; step != steps.end() && step->first <= visit.time; ++step) { sum += step->second; }
    sums[visit.edge] += visit.sign * sum;
  }
  return sums;
}

} // namespace internal

} // namespace meridian
