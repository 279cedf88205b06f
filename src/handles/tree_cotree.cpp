// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/handles/internal/tree_cotree.h>

#include <meridian/base/Union_find.h>

#include <algorithm>
#include <iterator>
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
}

std::vector<int> Tree_cotree::integrate(const std::map<Index, int>& flow) const
{
  std::vector<std::pair<Index, int>> steps; // where on the tour of the faces' tree the sum changes
  for (const auto& [e, amount] : flow)
    for (Index h : {e, m_surface.opposite[e]})
    {
      if (h < 0 || !m_tour.is_down[h]) { continue; } // down into the face of `h`
      const int into = h == e ? -amount : amount;
      steps.emplace_back(m_tour.enter[m_surface.face(h)], into);
      steps.emplace_back(m_tour.leave[m_surface.face(h)], -into);
    }
  std::sort(steps.begin(), steps.end());
  int sum = 0;
  for (auto& step : steps) { step.second = sum += step.second; }
  const auto at = [&](Index face) {
    auto after = std::upper_bound(steps.begin(), steps.end(), m_tour.enter[face],
                                  [](Index t, const auto& step) { return t < step.first; });
    return after == steps.begin() ? 0 : std::prev(after)->second;
  };
  std::vector<int> sums;
  for (Index e : m_edges)
  {
    const auto own = flow.find(e);
    const Index o = m_surface.opposite[e];
    sums.push_back((own == flow.end() ? 0 : own->second) + at(m_surface.face(e))
                   - at(o < 0 ? m_outside : m_surface.face(o)));
  }
  return sums;
}

} // namespace internal

} // namespace meridian
