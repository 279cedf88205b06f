// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/surface/insert_curves.h>

#include <meridian/base/exceptions.h>
#include <meridian/surface/internal/split_face.h>

#include <map>
#include <vector>

namespace meridian {

namespace internal {

namespace {

// Turns the points of curves into vertices of a surface, numbered along the curves, and collects what splits its faces.
class Curve_inserter
{
public:
  Curve_inserter(const Triangle_surface& root, Refined_surface& s) : m_root(root), m_surface(s) {}

  // Returns the vertices of the curve.
  std::vector<Index> add(const Surface_curve& curve)
  {
    std::vector<Index> path;
    for (const Curve_point& p : curve.points) { path.push_back(p.is_vertex() ? p.vertex : vertex_of(p)); }
    const std::size_t n = path.size();
    for (std::size_t i = 0; i + (curve.closed ? 0 : 1) < n; ++i)
    {
      const Curve_point &p = curve.points[i], &q = curve.points[(i + 1) % n];
      if (follows_edge(p, q)) { continue; }
      const Index face = m_surface.face(p.is_vertex() ? q.halfedge : m_surface.opposite[p.halfedge]);
      m_chords.push_back({face, path[i], path[(i + 1) % n]});
    }
    return path;
  }

  void split(Insertion& result)
  {
    split_faces(m_surface, m_new_vertices, m_chords, result.first_new_face, result.parent);
  }

private:
  // The vertex for a point inside an edge: a new one, unless another point of the same node has one.
  Index vertex_of(const Curve_point& p)
  {
    const Index v = m_surface.number_of_vertices();
    if (p.node >= 0)
    {
      const auto [known, is_new] = m_vertex_of_node.try_emplace(p.node, v);
      if (!is_new) { return known->second; }
    }
    m_new_vertices.push_back({{m_surface.edge(p.halfedge), turn_fraction(m_surface, p.halfedge, p.t)}, v});
    const Origin origin = origin_on(m_root, m_surface, p.halfedge, p.t);
    m_surface.origins.push_back(origin);
    m_surface.points.push_back(position(m_root, origin));
    m_surface.outgoing.push_back(-1);
    return v;
  }

  // Whether the way from one point to the next is an edge of the surface already, or a part of one.
  bool follows_edge(const Curve_point& p, const Curve_point& q) const
  {
    const auto is_end = [&](Index v, Index h) { return m_surface.source(h) == v || m_surface.target(h) == v; };
    if (p.is_vertex()) { return q.is_vertex() || is_end(p.vertex, q.halfedge); }
    return q.is_vertex() && is_end(q.vertex, p.halfedge);
  }

  const Triangle_surface& m_root;
  Refined_surface& m_surface;
  std::vector<New_vertex> m_new_vertices;
  std::vector<Chord> m_chords;
  std::map<Index, Index> m_vertex_of_node;
};

// Makes the edges between consecutive vertices of a curve seams.
void mark_as_seam(Refined_surface& s, const std::vector<Index>& path, bool closed)
{
  for (std::size_t i = 0; i + (closed ? 0 : 1) < path.size(); ++i)
  {
    const Index h = s.find_halfedge(path[i], path[(i + 1) % path.size()]);
    const Index g = h >= 0 ? s.opposite[h] : s.find_halfedge(path[(i + 1) % path.size()], path[i]);
    if (h < 0 && g < 0) { throw Internal_error("insert_curves: two consecutive points are not joined by an edge"); }
    if (h >= 0) { s.seam[h] = 1; }
    if (g >= 0) { s.seam[g] = 1; }
  }
}

} // namespace

} // namespace internal

Insertion insert_curves(const Triangle_surface& root, Refined_surface& s, const std::vector<Surface_curve>& curves,
                        bool mark_seam)
{
  Insertion result;
  internal::Curve_inserter inserter(root, s);
  for (const Surface_curve& curve : curves) { result.vertices.push_back(inserter.add(curve)); }
  inserter.split(result);
  for (std::size_t c = 0; c < curves.size() && mark_seam; ++c)
  {
    internal::mark_as_seam(s, result.vertices[c], curves[c].closed);
  }
  return result;
}

} // namespace meridian
