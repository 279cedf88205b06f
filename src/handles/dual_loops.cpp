// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/handles/internal/dual_loops.h>

#include <meridian/base/Union_find.h>
#include <meridian/base/vectors.h>
#include <meridian/surface/Face_tree.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace meridian {

namespace internal {

Node_tree::Node_tree(const Triangle_surface& s, const Closed_model& g) : m_surface(s), m_graph(g)
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
  m_tour = walk_tree(tree, 0, s.number_of_halfedges(), [&](Index h) { return g.node[s.target(h)]; });
}

boost::dynamic_bitset<> Node_tree::parity_of(const std::vector<Edge_place>& strip) const
{
  // on the tour of the tree, where the number of crossings on the way from its root changes parity
  std::vector<Index> changes;
  std::vector<Index> own;
  for (const Edge_place& c : strip)
  {
    own.push_back(m_surface.edge(c.halfedge));
    for (Index h : {c.halfedge, m_surface.opposite[c.halfedge]})
      if (m_tour.is_down[h])
      {
        const Index below = m_graph.node[m_surface.target(h)];
        changes.push_back(m_tour.enter[below]);
        changes.push_back(m_tour.leave[below]);
      }
  }
  std::sort(changes.begin(), changes.end());
  std::sort(own.begin(), own.end());
  const auto at = [&](Index v) {
    return (std::upper_bound(changes.begin(), changes.end(), m_tour.enter[m_graph.node[v]]) - changes.begin()) & 1;
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

// Whether a tree of faces crosses an edge.
bool crosses(const Triangle_surface& s, const Face_tree& tree, Index h)
{
  const Index o = s.opposite[h];
  return tree.by[s.face(o)] == h || tree.by[s.face(h)] == o;
}

// The length of the loop of an edge that the tree does not cross.
double loop_length(const Triangle_surface& s, const Face_tree& tree, Index h)
{
  const Index f = s.face(h), g = s.face(s.opposite[h]);
  const Point middle = s.point_on(h, 0.5);
  return tree.distance[f] + tree.distance[g] + distance(tree.entry(s, f), middle) + distance(tree.entry(s, g), middle);
}

// The loop of an edge, without what it has twice.
std::vector<Edge_place> make_loop(const Triangle_surface& s, const std::vector<Index>& by, Index h)
{
  std::vector<Edge_place> there, back;
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
  return there;
}

// The loops that a closed strip of faces falls into where it returns to one of them: each has every face once.
std::vector<std::vector<Edge_place>> simple_parts(const Triangle_surface& s, const std::vector<Edge_place>& strip)
{
  std::vector<std::vector<Edge_place>> parts;
  std::vector<Edge_place> open;
  std::map<Index, std::size_t> place; // of each face in `open`
  for (const Edge_place& c : strip)
  {
    const auto known = place.find(s.face(c.halfedge));
    if (known != place.end())
    {
      const auto first = open.begin() + static_cast<std::ptrdiff_t>(known->second);
      parts.emplace_back(first, open.end());
      for (auto at = first; at != open.end(); ++at) { place.erase(s.face(at->halfedge)); }
      open.erase(first, open.end());
    }
    place[s.face(c.halfedge)] = open.size();
    open.push_back(c);
  }
  parts.push_back(std::move(open));
  return parts;
}

double length_of(const Triangle_surface& s, const std::vector<Edge_place>& crossings)
{
  double length = 0;
  for (std::size_t i = 0; i < crossings.size(); ++i)
  {
    const Edge_place &a = crossings[i], &b = crossings[(i + 1) % crossings.size()];
    length += distance(s.point_on(a.halfedge, a.t), s.point_on(b.halfedge, b.t));
  }
  return length;
}

} // namespace

std::vector<Dual_loop> loops_at(const Triangle_surface& s, const Closed_model& g, Index base, std::vector<double>& far)
{
  const Face_tree tree = grow_face_tree(s, base);
  for (Index f = 0; f < s.number_of_faces(); ++f) { far[f] = std::min(far[f], tree.distance[f]); }
  std::vector<std::pair<double, Index>> rest; // by the length of their loops, the longest first
  for (Index h = 0; h < s.number_of_halfedges(); ++h)
  {
    if (s.opposite[h] < h || crosses(s, tree, h)) { continue; }
    rest.emplace_back(-loop_length(s, tree, h), h);
  }
  std::sort(rest.begin(), rest.end());
  Union_find nodes(g.number_of_nodes);
  std::vector<Dual_loop> loops;
  for (const auto& [length, h] : rest)
  {
    if (nodes.unite(g.node[s.source(h)], g.node[s.target(h)])) { continue; }
    loops.push_back({make_loop(s, tree.by, h), -length, -length, {}});
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

std::vector<Dual_loop> find_dual_loops(const Triangle_surface& s, int bases, std::size_t wanted,
                                       const std::vector<std::vector<Edge_place>>& others, const Progress& progress)
{
  const Closed_model g = make_closed_model(s);
  const Node_tree tree(s, g);
  std::vector<double> far(s.number_of_faces(), std::numeric_limits<double>::infinity());
  std::vector<Dual_loop> all;
  Index base = 0;
  for (int i = 0; i < bases; ++i)
  {
    auto loops = loops_at(s, g, base, far);
    all.insert(all.end(), std::make_move_iterator(loops.begin()), std::make_move_iterator(loops.end()));
    base = static_cast<Index>(std::max_element(far.begin(), far.end()) - far.begin());
    progress((i + 1.) / bases);
  }
  for (const auto& strip : others)
    for (auto& crossings : simple_parts(s, strip))
    {
      const double length = length_of(s, crossings);
      all.push_back({std::move(crossings), length, length, {}});
    }
  std::stable_sort(all.begin(), all.end(), [](const Dual_loop& a, const Dual_loop& b) { return a.length < b.length; });
  for (Dual_loop& loop : all) { loop.parity = tree.parity_of(loop.crossings); }
  // Several rounds of the greedy choice, each from what the ones before left.
  std::vector<Dual_loop> candidates;
  for (int round = 0; round < 4; ++round)
  {
    std::vector<Dual_loop> chosen, left;
    std::vector<std::pair<std::size_t, boost::dynamic_bitset<>>> reduced;
    for (Dual_loop& loop : all)
    {
      boost::dynamic_bitset<> rest = loop.parity;
      for (const auto& [bit, row] : reduced)
      {
        if (rest[bit]) { rest ^= row; }
      }
      const bool is_new = reduced.size() < wanted && rest.any();
      if (is_new) { reduced.emplace_back(rest.find_first(), rest); }
      (is_new ? candidates : left).push_back(std::move(loop));
    }
    all = std::move(left);
  }
  return candidates;
}

} // namespace internal

} // namespace meridian
