// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/cut/internal/straighten_paths.h>

#include <meridian/base/exceptions.h>

namespace meridian {

namespace internal {

bool Path_straightener::straighten_all()
{
  std::vector<char> seen(m_surface.number_of_halfedges(), 0);
  std::vector<Index> firsts;
  for (Index h = 0; h < m_surface.number_of_halfedges(); ++h)
  {
    if (!m_is_cut[h] || seen[h]) { continue; }
    firsts.push_back(h);
    for (Index g : path_through(h)) { seen[g] = seen[m_surface.opposite[g]] = 1; }
  }
  bool is_shorter = false;
  for (Index h : firsts)
  {
    if (m_is_cut[h]) { is_shorter = straighten(path_through(h)) || is_shorter; }
  }
  return is_shorter;
}

Index Path_straightener::continued(Index h) const
{
  const Index v = m_surface.target(h);
  if (m_degree[v] != 2 || m_surface.is_boundary_vertex(v)) { return -1; }
  Index next = -1;
  m_surface.for_each_outgoing(v, [&](Index g) {
    if (m_is_cut[g] && g != m_surface.opposite[h]) { next = g; }
  });
  return next;
}

Path_straightener::Path Path_straightener::path_through(Index h) const
{
  Index first = m_surface.opposite[h];
  for (Index g = continued(first); g >= 0; g = continued(g))
  {
    first = g;
    if (g == m_surface.opposite[h])
    {
      throw Invalid_input_error(
        "straighten_edge_cut: a closed loop of the cut has no node; the edges are no cut graph");
    }
  }
  Path path;
  for (Index g = m_surface.opposite[first]; g >= 0; g = continued(g)) { path.push_back(g); }
  return path;
}

void Path_straightener::set(const Path& path, bool is_cut)
{
  for (Index h : path)
  {
    m_is_cut[h] = m_is_cut[m_surface.opposite[h]] = is_cut;
    for (Index v : {m_surface.source(h), m_surface.target(h)}) { m_degree[v] += is_cut ? 1 : -1; }
  }
}

Path_straightener::Walk Path_straightener::begin_walk(Index h)
{
  while (!is_wall(h)) { h = m_surface.turn_right(h); }
  return {h, ++m_marks};
}

void Path_straightener::step(Walk& walk)
{
  Index h = walk.at < 0 ? walk.first : walk.at;
  Index g = h;
  do {
    m_mark[g] = walk.mark;
    if (g != h) { walk.inwards.push_back(g); }
    g = m_surface.turn_left(g);
  } while (g >= 0 && !is_wall(g));
  h = m_surface.next(h);
  while (!is_wall(h)) { h = m_surface.next(m_surface.opposite[h]); }
  walk.at = h;
}

std::vector<Index> Path_straightener::mark_boundary(Index h, Index g)
{
  Walk a = begin_walk(h), b = begin_walk(g);
  while (!a.is_closed() && !b.is_closed())
  {
    step(a);
    step(b);
    if (a.at == b.first || b.at == a.first || a.first == b.first)
      throw Invalid_input_error("straighten_edge_cut: the edges are no cut graph; more than a disc is left");
  }
  Walk& shorter = a.is_closed() ? a : b;
  m_near = shorter.mark;
  return std::move(shorter.inwards);
}

double Path_straightener::length(const Path& path) const
{
  double sum = 0;
  for (Index h : path) { sum += m_surface.length(h); }
  return sum;
}

bool Path_straightener::straighten(const Path& path)
{
  const Index from = m_surface.source(path.front()), to = m_surface.target(path.back());
  set(path, false);
  if (!is_used(from) || !is_used(to)) // the loose end of a path over a sphere
  {
    set(path, true);
    return false;
  }
  const std::vector<Index> inwards = mark_boundary(path.front(), m_surface.opposite[path.back()]);

  constexpr double less = 1 - 1e-12; // rounding must not keep the rounds going
  Path best = path;
  const auto improve = [&](const Path& other) {
    if (!other.empty()) { best = other; }
  };
  if (m_slide)
  {
    improve(search(inwards, length(path) * less, [&](Index h) { return !is_near(m_surface.opposite[h]); }));
  }
  else
    for (bool near : {true, false}) // whether `from` is left on the boundary marked; its sectors may lie on both
    {
      std::vector<Index> starts;
      m_surface.for_each_outgoing(from, [&](Index h) {
        if (!is_wall(h) && is_near(h) == near) { starts.push_back(h); }
      });
      improve(search(starts, length(best) * less,
                     [&](Index h) { return m_surface.target(h) == to && is_near(m_surface.opposite[h]) != near; }));
    }
  set(best, true);
  return best != path;
}

} // namespace internal

} // namespace meridian
