// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/handles/internal/tree_cotree.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

namespace meridian {

namespace internal {

Tree_cotree::Tree_cotree(const Triangle_surface& s) : m_surface(s), m_outside(s.number_of_faces())
{
  std::vector<Index> vertex(s.number_of_vertices()), face(m_outside + 1);
  std::iota(vertex.begin(), vertex.end(), Index(0));
  std::iota(face.begin(), face.end(), Index(0));
  const auto join = [](std::vector<Index>& set, Index a, Index b) {
    const auto find = [&](Index i) {
      while (set[i] != i) { i = set[i] = set[set[i]]; }
      return i;
    };
    a = find(a);
    b = find(b);
    set[a] = b;
    return a != b;
  };
  // of a face: halfedges of other faces, across edges of its tree
  std::vector<std::vector<Index>> around(m_outside + 1);
  for (Index h = 0; h < s.number_of_halfedges(); ++h)
  {
    if (s.edge(h) != h || join(vertex, s.source(h), s.target(h))) { continue; }
    const Index o = s.opposite[h], g = o < 0 ? m_outside : s.face(o);
    if (!join(face, s.face(h), g))
    {
      m_edges.push_back(h);
      continue;
    }
    around[g].push_back(h);
    if (o >= 0) { around[s.face(h)].push_back(o); }
  }
  m_is_down.assign(s.number_of_halfedges(), 0);
  m_enter.assign(m_outside + 1, -1);
  m_leave.assign(m_outside + 1, -1);
  std::vector<std::pair<Index, std::size_t>> stack{{around[m_outside].empty() ? 0 : m_outside, 0}};
  Index time = 0;
  m_enter[stack.back().first] = time++;
  while (!stack.empty())
  {
    auto& [f, next] = stack.back();
    if (next == around[f].size())
    {
      m_leave[f] = time;
      stack.pop_back();
      continue;
    }
    const Index h = around[f][next++], g = s.face(h);
    if (m_enter[g] >= 0) { continue; }
    m_is_down[h] = 1;
    m_enter[g] = time++;
    stack.emplace_back(g, 0);
  }
}

std::vector<int> Tree_cotree::integrate(const std::map<Index, int>& flow) const
{
  std::vector<std::pair<Index, int>> steps; // where on the tour of the faces' tree the sum changes
  for (const auto& [e, amount] : flow)
    for (Index h : {e, m_surface.opposite[e]})
    {
      if (h < 0 || !m_is_down[h]) { continue; } // down into the face of `h`
      const int into = h == e ? -amount : amount;
      steps.emplace_back(m_enter[m_surface.face(h)], into);
      steps.emplace_back(m_leave[m_surface.face(h)], -into);
    }
  std::sort(steps.begin(), steps.end());
  int sum = 0;
  for (auto& step : steps) { step.second = sum += step.second; }
  const auto at = [&](Index face) {
    auto after = std::upper_bound(steps.begin(), steps.end(), m_enter[face],
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
