// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/cut/internal/name_paths.h>

#include <meridian/base/exceptions.h>
#include <meridian/surface/root_edges.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <numeric>
#include <unordered_map>

namespace meridian {

namespace internal {

namespace {

// The place of each halfedge along the rim of the disc that the seams leave, -1 inside it.
std::vector<Index> number_rim(const Refined_surface& s)
{
  std::vector<Index> place(s.number_of_halfedges(), -1);
  Index first = 0, steps = 0, walls = 0;
  for (Index h = s.number_of_halfedges() - 1; h >= 0; --h)
  {
    if (!s.is_seam_or_boundary(h)) { continue; }
    ++walls;
    first = h;
  }
  Index h = first;
  do {
    place[h] = steps++;
    h = s.next(h);
    while (!s.is_seam_or_boundary(h)) { h = s.next(s.opposite[h]); }
  } while (h != first && steps < walls);
  if (h != first || steps != walls) { throw Internal_error("Graph_chains: the seams are no cut graph"); }
  return place;
}

// Whether the halfedge between two vertices runs along an edge of the root.
bool runs_along(const Refined_surface& s, Index x, Index y, Index from, Index to)
{
  std::array<Index, 2> ends;
  std::array<double, 2> at;
  return on_common_root_edge(s.origin(x), s.origin(y), ends, at) && ends[0] == std::min(from, to)
         && ends[1] == std::max(from, to);
}

} // namespace

Graph_chains::Graph_chains(const Triangle_surface& root, const Refined_surface& s,
                           const std::vector<std::vector<Index>>& paths)
  : m_root(root), m_surface(s), m_place(number_rim(s)), m_is_on_rim(s.number_of_vertices(), 0),
    m_paths(static_cast<Index>(paths.size()))
{
  for (Index h = 0; h < s.number_of_halfedges(); ++h)
  {
    if (m_place[h] >= 0) { m_is_on_rim[s.source(h)] = 1; }
  }
  Index number = 0;
  for (const auto& path : paths)
  {
    const Index h = s.find_halfedge(path[0], path[1]);
    m_questions.emplace_back(m_place[h], number++);
    m_questions.emplace_back(m_place[s.opposite[h]], number++);
  }
  for (const auto& loop : boundary_loops(s))
  {
    m_loops.emplace_back();
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      const Index before = loop[(i + loop.size() - 1) % loop.size()];
      if (m_place[loop[i]] == m_place[before] + 1) { continue; } // of one side
      m_loops.back().push_back(number);
      m_questions.emplace_back(m_place[loop[i]], number++);
    }
  }
  std::sort(m_questions.begin(), m_questions.end());
}

Index Graph_chains::place(Index h) const
{
  while (m_place[h] < 0) { h = m_surface.turn_right(h); }
  return m_place[h];
}

void Graph_chains::add_halfedge(Index h, std::vector<std::pair<Index, Index>>& changes) const
{
  const Index back = m_surface.opposite[h];
  if (m_place[h] >= 0)
  {
    changes.emplace_back(m_place[h], 1);
    changes.emplace_back(m_place[h] + 1, -1);
    return;
  }
  // from one place to the other: along the rim
  if (m_is_on_rim[m_surface.source(h)]) { changes.emplace_back(place(h), 1); }
  if (m_is_on_rim[m_surface.target(h)]) { changes.emplace_back(place(back), -1); }
}

void Graph_chains::add_edge(Index from, Index to, std::vector<std::pair<Index, Index>>& changes) const
{
  for (Index last = -1, at = from; at != to;)
  {
    Index onwards = -1, boundary = -1;
    m_surface.for_each_outgoing(at, [&](Index h) {
      const Index w = m_surface.target(h), before = m_surface.prev(h), u = m_surface.source(before);
      if (w != last && runs_along(m_surface, at, w, from, to)) { onwards = h; }
      if (m_surface.opposite[before] < 0 && u != last && runs_along(m_surface, at, u, from, to)) { boundary = before; }
    });
    last = at;
    if (onwards >= 0)
    {
      add_halfedge(onwards, changes);
      at = m_surface.target(onwards);
    }
    else if (boundary >= 0) // against its direction
    {
      changes.emplace_back(m_place[boundary], -1);
      changes.emplace_back(m_place[boundary] + 1, 1);
      at = m_surface.source(boundary);
    }
    else { throw Internal_error("Graph_chains: two vertices of a walk are not joined by an edge"); }
  }
}

std::vector<Index> Graph_chains::chain_of(const std::vector<Index>& walk) const
{
  std::vector<std::pair<Index, Index>> changes; // of the number, from a place on the rim on
  for (std::size_t i = 0; i < walk.size(); ++i) { add_edge(walk[i], walk[(i + 1) % walk.size()], changes); }
  std::sort(changes.begin(), changes.end());
  std::vector<Index> numbers(m_questions.size(), 0);
  auto change = changes.begin();
  Index sum = 0;
  for (const auto& [place, number] : m_questions)
  {
    for (; change != changes.end() && change->first <= place; ++change) { sum += change->second; }
    numbers[number] = sum;
  }
  std::vector<Index> chain(m_paths, 0);
  for (const auto& sides : m_loops)
    for (Index side : sides)
    {
      if (numbers[side] != numbers[sides.front()]) { return chain; }
    }
  for (Index p = 0; p < m_paths; ++p) { chain[p] = numbers[2 * p] - numbers[2 * p + 1]; }
  return chain;
}

std::vector<Meridian_walk> walks_of_meridians(const Triangle_surface& root, const Cut& cut)
{
  std::vector<Meridian_walk> walks;
  for (const Named_curve& curve : cut.curves)
  {
    if (curve.kind != Curve_kind::MERIDIAN) { continue; }
    auto& walk = walks.emplace_back(Meridian_walk{{}, curve.saddle}).vertices;
    for (Index v : curve.vertices) { walk.push_back(root_vertex(root, cut.surface, v)); }
    walk.erase(std::unique(walk.begin(), walk.end()), walk.end());
  }
  return walks;
}

namespace {

// A simple cycle of paths.
struct Cycle
{
  std::vector<Index> paths, vertices;
};

// The cycle that a chain is, from its lowest path on; nothing if it is no simple cycle.
Cycle trace_cycle(const std::vector<std::vector<Index>>& paths, const std::vector<Index>& chain)
{
  std::unordered_map<Index, Index> leaving; // by vertex, a path of the chain that leaves it
  Index first = -1;
  for (Index p = static_cast<Index>(paths.size()) - 1; p >= 0; --p)
  {
    if (chain[p] == 0) { continue; }
    const Index from = chain[p] > 0 ? paths[p].front() : paths[p].back();
    if (std::abs(chain[p]) > 1 || !leaving.emplace(from, p).second) { return {}; }
    first = p;
  }
  if (first < 0) { return {}; }
  Cycle cycle;
  Index p = first;
  do {
    std::vector<Index> path = paths[p];
    if (chain[p] < 0) { std::reverse(path.begin(), path.end()); }
    cycle.paths.push_back(p);
    cycle.vertices.insert(cycle.vertices.end(), path.begin(), path.end() - 1);
    p = leaving.at(path.back()); // a chain without ends
  } while (p != first);
  return cycle.paths.size() == leaving.size() ? cycle : Cycle(); // one of several
}

// Of cycles, those that stand for themselves: of two that meet, the one of fewer paths, or else the first.
std::vector<char> choose_disjoint(const std::vector<Cycle>& cycles, Index number_of_vertices)
{
  std::vector<std::size_t> order(cycles.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return cycles[i].paths.size() < cycles[j].paths.size(); });
  std::vector<char> is_chosen(cycles.size(), 0), is_taken(number_of_vertices, 0);
  for (std::size_t i : order)
  {
    const auto& vertices = cycles[i].vertices;
    if (vertices.empty() || std::any_of(vertices.begin(), vertices.end(), [&](Index v) { return is_taken[v]; }))
    {
      continue;
    }
    is_chosen[i] = 1;
    for (Index v : vertices) { is_taken[v] = 1; }
  }
  return is_chosen;
}

} // namespace

std::vector<Named_curve> name_paths(const Triangle_surface& root, const Refined_surface& s,
                                    std::vector<std::vector<Index>> paths, const std::vector<Meridian_walk>& meridians)
{
  std::vector<Named_curve> curves;
  std::vector<char> is_gone(paths.size(), 0);
  if (!meridians.empty())
  {
    const Graph_chains chains(root, s, paths);
    std::vector<Cycle> cycles;
    for (const Meridian_walk& m : meridians) { cycles.push_back(trace_cycle(paths, chains.chain_of(m.vertices))); }
    const std::vector<char> is_chosen = choose_disjoint(cycles, s.number_of_vertices());
    for (std::size_t i = 0; i < cycles.size(); ++i)
    {
      if (!is_chosen[i]) { continue; }
      for (Index p : cycles[i].paths) { is_gone[p] = 1; }
      curves.push_back({Curve_kind::MERIDIAN, std::move(cycles[i].vertices), true, meridians[i].saddle});
    }
  }
  const Curve_kind rest = curves.size() == meridians.size() ? Curve_kind::LINK : Curve_kind::PATH;
  for (std::size_t p = 0; p < paths.size(); ++p)
  {
    if (!is_gone[p]) { curves.push_back({rest, std::move(paths[p])}); }
  }
  return curves;
}

} // namespace internal

} // namespace meridian
