// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/cut/internal/slit_surface.h>

#include <meridian/base/exceptions.h>
#include <meridian/surface/insert_curves.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace meridian {

namespace internal {

Slit_surface::Slit_surface(const Triangle_surface& root, Refined_surface& s, bool bifurcations,
                           std::vector<char> kept_out)
  : m_root(root), m_surface(s), m_bifurcations(bifurcations), m_kept_out(std::move(kept_out)),
    m_loop(s.number_of_halfedges(), -1), m_is_used(s.number_of_vertices(), 0)
{
  for (Index h = 0; h < s.number_of_halfedges() && !m_kept_out.empty(); ++h) { m_detour += s.length(h); }
  std::vector<char> is_done(s.number_of_halfedges(), 0);
  for (Index first = 0; first < s.number_of_halfedges(); ++first)
  {
    if (is_done[first] || !s.is_seam_or_boundary(first)) { continue; }
    const Index loop = add_loop();
    for (Index h = first; !is_done[h];)
    {
      is_done[h] = 1;
      label_sector(h, loop);
      h = s.next(h);
      while (!s.is_seam_or_boundary(h)) { h = s.next(s.opposite[h]); }
    }
  }
  m_joined = Union_find(number_of_loops());
}

void Slit_surface::add_point(Index v)
{
  if (m_is_used[v]) { return; }
  const Index loop = add_loop();
  m_surface.for_each_outgoing(v, [&](Index h) { m_loop[h] = loop; });
  m_vertices[loop].push_back(v);
  m_is_used[v] = 1;
  m_joined = Union_find(number_of_loops()); // nothing is joined yet
}

std::vector<Index> Slit_surface::insert(Sleeve sleeve)
{
  const auto crossable = [&](Index h) {
    return may_cross(h) && !is_kept_out(m_surface.face(h)) && !is_kept_out(m_surface.face(m_surface.opposite[h]));
  };
  const auto free = [&](Index v) { return is_free(v); };
  const Index a = loop_at(sleeve, true), b = loop_at(sleeve, false);
  Surface_curve curve = shortest_curve(m_surface, sleeve, crossable, free);
  if (curve.points.size() == 2)
  {
    const Index h = m_surface.find_halfedge(sleeve.start, sleeve.end);
    if (h < 0 || !may_cross(h)) { throw Internal_error("link_boundaries: a link runs along a seam"); }
    const bool both_are_points = m_vertices[a].size() == 1 && m_vertices[b].size() == 1;
    if (both_are_points) // one edge between two points would open nothing
    {
      const Index middle = refine(Surface_curve{{Curve_point::on_edge(h, 0.5)}, false}, false).front();
      curve.points.insert(curve.points.begin() + 1, Curve_point::on_vertex(middle));
    }
  }

  const std::vector<Index> path = refine(curve, true);
  for (Index v : path) { m_is_used[v] = 1; }
  if (m_bifurcations)
    for (std::size_t i = 1; i + 1 < path.size(); ++i)
    {
      m_surface.for_each_outgoing(path[i], [&](Index h) { m_loop[h] = a; });
      m_vertices[a].push_back(path[i]);
    }
  m_joined.unite(a, b);
  return path;
}

Index Slit_surface::add_loop()
{
  m_vertices.emplace_back();
  return number_of_loops() - 1;
}

void Slit_surface::label_sector(Index h, Index loop)
{
  m_vertices[loop].push_back(m_surface.source(h));
  m_is_used[m_surface.source(h)] = 1;
  do {
    m_loop[h] = loop;
    h = m_surface.turn_left(h);
  } while (h >= 0 && !m_surface.seam[h]);
}

Index Slit_surface::loop_at(const Sleeve& sleeve, bool start) const
{
  if (!sleeve.halfedges.empty())
    return m_loop[m_surface.prev(start ? sleeve.halfedges.front() : m_surface.opposite[sleeve.halfedges.back()])];
  const Index h = m_surface.find_halfedge(sleeve.start, sleeve.end);
  const Index g = h >= 0 ? h : m_surface.find_halfedge(sleeve.end, sleeve.start);
  return m_loop[(h >= 0) == start ? g : m_surface.next(g)];
}

std::vector<Index> Slit_surface::refine(const Surface_curve& curve, bool mark_seam)
{
  struct Corner
  {
    Index face, vertex, loop;
  };
  std::vector<Corner> corners;
  const auto remember = [&](Index f) {
    for (Index h = 3 * f; h < 3 * f + 3; ++h) { corners.push_back({f, m_surface.source(h), m_loop[h]}); }
  };
  for (const Curve_point& p : curve.points)
    if (!p.is_vertex())
    {
      remember(m_surface.face(p.halfedge));
      remember(m_surface.face(m_surface.opposite[p.halfedge]));
    }
  const auto order = [](const Corner& x, const Corner& y) {
    return std::tie(x.face, x.vertex) < std::tie(y.face, y.vertex);
  };
  std::sort(corners.begin(), corners.end(), order);

  const Insertion done = insert_curves(m_root, m_surface, {curve}, mark_seam);
  m_loop.resize(m_surface.number_of_halfedges(), -1);
  m_was_changed.resize(m_surface.number_of_faces(), 0);
  m_is_used.resize(m_surface.number_of_vertices(), 0);
  parents.insert(parents.end(), done.parent.begin(), done.parent.end());
  const auto relabel = [&](Index f, Index parent) {
    m_was_changed[f] = 1;
    for (Index h = 3 * f; h < 3 * f + 3; ++h)
    {
      const auto c = std::lower_bound(corners.begin(), corners.end(), Corner{parent, m_surface.source(h), -1}, order);
      m_loop[h] = c != corners.end() && c->face == parent && c->vertex == m_surface.source(h) ? c->loop : -1;
    }
  };
  for (const Corner& c : corners) { relabel(c.face, c.face); }
  for (std::size_t i = 0; i < done.parent.size(); ++i)
  {
    relabel(done.first_new_face + static_cast<Index>(i), done.parent[i]);
  }
  return done.vertices.front();
}

} // namespace internal

} // namespace meridian
