// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/handles/internal/dual_loops.h>

#include <functional>
#include <numeric>
#include <queue>

namespace meridian {

namespace internal {

Node_tree::Node_tree(const Triangle_surface& s, const Closed_model& g)
  : m_surface(s), m_graph(g), m_is_down(s.number_of_halfedges(), 0)
{
  std::vector<Index> parent(g.number_of_nodes), face(s.number_of_faces()),
    rank(std::max(g.number_of_nodes, s.number_of_faces()), 0);
  std::iota(parent.begin(), parent.end(), Index(0));
  std::iota(face.begin(), face.end(), Index(0));
  boost::disjoint_sets<Index*, Index*> nodes(rank.data(), parent.data());
  std::vector<std::vector<Index>> tree(g.number_of_nodes); // of a node: halfedges to its neighbours
  std::vector<Index> rest;
  for (Index h = 0; h < s.number_of_halfedges(); ++h)
  {
    const Index o = s.opposite[h];
    if (o < h) { continue; }
    const Index a = g.node[s.source(h)], b = g.node[s.target(h)];
    if (nodes.find_set(a) == nodes.find_set(b))
    {
      rest.push_back(h);
      continue;
    }
    nodes.union_set(a, b);
    tree[a].push_back(h);
    tree[b].push_back(o);
  }
  std::vector<Index> order(s.number_of_faces(), 0);
  boost::disjoint_sets<Index*, Index*> faces(order.data(), face.data());
  for (Index h : rest)
  {
    const Index f = s.face(h), f2 = s.face(s.opposite[h]);
    if (faces.find_set(f) == faces.find_set(f2)) { m_edges.push_back(h); }
    else { faces.union_set(f, f2); }
  }
  m_enter.assign(g.number_of_nodes, -1);
  m_leave.assign(g.number_of_nodes, -1);
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
    const Index h = tree[a][next++], b = g.node[s.target(h)];
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

std::vector<Dual_loop> loops_at(const Triangle_surface& s, const Closed_model& g, Index base, std::vector<double>& far)
{
  const Index faces = s.number_of_faces();
  std::vector<double> at(faces, std::numeric_limits<double>::infinity());
  std::vector<Index> by(faces, -1); // the halfedge by which the face before was left
  const auto entry = [&](Index f) { // distances are measured to the middle of the edge by which a face was entered
    const auto& t = s.triangles[f];
    return by[f] >= 0 ? s.point_on(by[f], 0.5) : (1. / 3) * (s.points[t[0]] + s.points[t[1]] + s.points[t[2]]);
  };
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  at[base] = 0;
  queue.emplace(0., base);
  while (!queue.empty())
  {
    const auto [d, f] = queue.top();
    queue.pop();
    if (d > at[f]) { continue; }
    for (Index h = 3 * f; h < 3 * f + 3; ++h)
    {
      if (s.opposite[h] < 0) { continue; }
      const Index o = s.face(s.opposite[h]);
      const double reached = d + distance(entry(f), s.point_on(h, 0.5));
      if (!(reached < at[o])) { continue; }
      at[o] = reached;
      by[o] = h;
      queue.emplace(reached, o);
    }
  }
  for (Index f = 0; f < faces; ++f) { far[f] = std::min(far[f], at[f]); }
  std::vector<std::pair<double, Index>> rest; // by the length of their loops, the longest first
  for (Index h = 0; h < s.number_of_halfedges(); ++h)
  {
    const Index o = s.opposite[h];
    if (o < h || by[s.face(o)] == h || by[s.face(h)] == o) { continue; }
    const Point middle = s.point_on(h, 0.5);
    rest.emplace_back(
      -(at[s.face(h)] + at[s.face(o)] + distance(entry(s.face(h)), middle) + distance(entry(s.face(o)), middle)), h);
  }
  std::sort(rest.begin(), rest.end());
  std::vector<Index> parent(g.number_of_nodes), rank(g.number_of_nodes, 0);
  std::iota(parent.begin(), parent.end(), Index(0));
  boost::disjoint_sets<Index*, Index*> nodes(rank.data(), parent.data());
  std::vector<Dual_loop> loops;
  for (const auto& [length, h] : rest)
  {
    const Index a = g.node[s.source(h)], b = g.node[s.target(h)];
    if (nodes.find_set(a) != nodes.find_set(b))
    {
      nodes.union_set(a, b);
      continue;
    }
    std::vector<Passing> there, back;
    for (Index f = s.face(h); by[f] >= 0; f = s.face(by[f])) { there.push_back({by[f], 0.5}); }
    for (Index f = s.face(s.opposite[h]); by[f] >= 0; f = s.face(by[f])) { back.push_back({s.opposite[by[f]], 0.5}); }
    while (!there.empty() && !back.empty() && there.back().halfedge == s.opposite[back.back().halfedge])
    {
      there.pop_back();
      back.pop_back();
    }
    std::reverse(there.begin(), there.end());
    there.push_back({h, 0.5});
    there.insert(there.end(), back.begin(), back.end());
    loops.push_back({std::move(there), -length, -length, {}});
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
