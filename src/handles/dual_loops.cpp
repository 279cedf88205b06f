// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/handles/internal/dual_loops.h>

#include <meridian/base/Union_find.h>
#include <meridian/base/vectors.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace meridian {

namespace internal {

Node_tree::Node_tree(const Triangle_surface& s, const Closed_model& g)
  : m_surface(s), m_graph(g), m_is_down(s.number_of_halfedges(), 0)
{
  Union_find nodes(g.number_of_nodes), faces(s.number_of_faces());
  std::vector<std::vector<Index>> tree(g.number_of_nodes); // of a node: halfedges to its neighbours
  std::vector<Index> rest;
  for (Index h = 0; h < s.number_of_halfedges(); ++h)
  {
    const Index o = s.opposite[h];
    if (o < h) { continue; }
    const Index a = g.node[s.source(h)], b = g.node[s.target(h)];
    if (!nodes.unite(a, b))
    {
      rest.push_back(h);
      continue;
    }
    tree[a].push_back(h);
    tree[b].push_back(o);
  }
  for (Index h : rest)
  {
    if (!faces.unite(s.face(h), s.face(s.opposite[h]))) { m_edges.push_back(h); }
  }
  tour(tree);
}

void Node_tree::tour(const std::vector<std::vector<Index>>& tree)
{
  m_enter.assign(tree.size(), -1);
  m_leave.assign(tree.size(), -1);
  std::vector<std::pair<Index, std::size_t>> stack{{0, 0}};
  Index time = 0;
  m_enter[0] = time++;
  while (!stack.empty())
  {
    auto& [a, next] = stack.back();
    if (next == tree[a].size())
    {
      m_leave[a] = time;
      stack.pop_back();
      continue;
    }
    const Index h = tree[a][next++], b = m_graph.node[m_surface.target(h)];
    if (m_enter[b] >= 0) { continue; }
    m_is_down[h] = 1;
    m_enter[b] = time++;
    stack.emplace_back(b, 0);
  }
}

boost::dynamic_bitset<> Node_tree::parity_of(const std::vector<Passing>& strip) const
{
  // on the tour of the tree, where the number of crossings on the way from its root changes parity
  std::vector<Index> changes;
  std::vector<Index> own;
  for (const Passing& c : strip)
  {
    own.push_back(m_surface.edge(c.halfedge));
    for (Index h : {c.halfedge, m_surface.opposite[c.halfedge]})
      if (m_is_down[h])
      {
        const Index below = m_graph.node[m_surface.target(h)];
        changes.push_back(m_enter[below]);
        changes.push_back(m_leave[below]);
      }
  }
  std::sort(changes.begin(), changes.end());
  std::sort(own.begin(), own.end());
  const auto at = [&](Index v) {
    return (std::upper_bound(changes.begin(), changes.end(), m_enter[m_graph.node[v]]) - changes.begin()) & 1;
  };
  boost::dynamic_bitset<> parity(m_edges.size());
  for (std::size_t i = 0; i < m_edges.size(); ++i)
  {
    const Index h = m_edges[i];
    const auto range = std::equal_range(own.begin(), own.end(), h);
    parity[i] = ((range.second - range.first) + at(m_surface.source(h)) + at(m_surface.target(h))) & 1;
  }
  return parity;
}

namespace {

// Shortest ways through faces from one of them. Distances are measured to the middle of the edge by which a face was
// entered.
class Face_tree
{
public:
  Face_tree(const Triangle_surface& s, Index base)
    : m_surface(s), m_at(s.number_of_faces(), std::numeric_limits<double>::infinity()), m_by(s.number_of_faces(), -1)
  {
    using Entry = std::pair<double, Index>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    m_at[base] = 0;
    queue.emplace(0., base);
    while (!queue.empty())
    {
      const auto [d, f] = queue.top();
      queue.pop();
      if (d > m_at[f]) { continue; }
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
      {
        if (s.opposite[h] < 0) { continue; }
        const Index o = s.face(s.opposite[h]);
        const double reached = d + distance(entry(f), s.point_on(h, 0.5));
        if (!(reached < m_at[o])) { continue; }
        m_at[o] = reached;
        m_by[o] = h;
        queue.emplace(reached, o);
      }
    }
  }

  double distance_of(Index f) const { return m_at[f]; }

  // Whether the tree crosses an edge.
  bool crosses(Index h) const
  {
    const Index o = m_surface.opposite[h];
    return m_by[m_surface.face(o)] == h || m_by[m_surface.face(h)] == o;
  }

  // The length of the loop of an edge that the tree does not cross.
  double loop_length(Index h) const
  {
    const Index f = m_surface.face(h), g = m_surface.face(m_surface.opposite[h]);
    const Point middle = m_surface.point_on(h, 0.5);
    return m_at[f] + m_at[g] + distance(entry(f), middle) + distance(entry(g), middle);
  }

  // The loop of an edge, without what it has twice.
  std::vector<Passing> loop(Index h) const
  {
    const Triangle_surface& s = m_surface;
    std::vector<Passing> there, back;
    for (Index f = s.face(h); m_by[f] >= 0; f = s.face(m_by[f])) { there.push_back({m_by[f], 0.5}); }
    for (Index f = s.face(s.opposite[h]); m_by[f] >= 0; f = s.face(m_by[f]))
    {
      back.push_back({s.opposite[m_by[f]], 0.5});
    }
    while (!there.empty() && !back.empty() && there.back().halfedge == s.opposite[back.back().halfedge])
    {
      there.pop_back();
      back.pop_back();
    }
    std::reverse(there.begin(), there.end());
    there.push_back({h, 0.5});
    there.insert(there.end(), back.begin(), back.end());
    return there;
  }

private:
  Point entry(Index f) const
  {
    const auto& t = m_surface.triangles[f];
    return m_by[f] >= 0 ? m_surface.point_on(m_by[f], 0.5)
                        : (1. / 3) * (m_surface.points[t[0]] + m_surface.points[t[1]] + m_surface.points[t[2]]);
  }

  const Triangle_surface& m_surface;
  std::vector<double> m_at;
  std::vector<Index> m_by; // the halfedge by which the face before was left
};

} // namespace

std::vector<Dual_loop> loops_at(const Triangle_surface& s, const Closed_model& g, Index base, std::vector<double>& far)
{
  const Face_tree tree(s, base);
  for (Index f = 0; f < s.number_of_faces(); ++f) { far[f] = std::min(far[f], tree.distance_of(f)); }
  std::vector<std::pair<double, Index>> rest; // by the length of their loops, the longest first
  for (Index h = 0; h < s.number_of_halfedges(); ++h)
  {
    if (s.opposite[h] < h || tree.crosses(h)) { continue; }
    rest.emplace_back(-tree.loop_length(h), h);
  }
  std::sort(rest.begin(), rest.end());
  Union_find nodes(g.number_of_nodes);
  std::vector<Dual_loop> loops;
  for (const auto& [length, h] : rest)
  {
    if (nodes.unite(g.node[s.source(h)], g.node[s.target(h)])) { continue; }
    loops.push_back({tree.loop(h), -length, -length, {}});
  }
  return loops;
}

std::vector<Dual_loop> choose_basis(std::vector<Dual_loop> loops, std::size_t wanted)
{
  std::stable_sort(loops.begin(), loops.end(),
                   [](const Dual_loop& a, const Dual_loop& b) { return a.length < b.length; });
  std::vector<Dual_loop> chosen;
  std::vector<std::pair<std::size_t, boost::dynamic_bitset<>>> reduced; // by their first bit
  for (Dual_loop& loop : loops)
  {
    boost::dynamic_bitset<> rest = loop.parity;
    for (const auto& [bit, row] : reduced)
    {
      if (rest[bit]) { rest ^= row; }
    }
    if (rest.none()) { continue; }
    reduced.emplace_back(rest.find_first(), rest);
    chosen.push_back(std::move(loop));
    if (chosen.size() == wanted) { break; }
  }
  return chosen;
}

} // namespace internal

} // namespace meridian
