// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/surface/insert_curves.h>

#include <meridian/base/exceptions.h>
#include <meridian/surface/internal/split_face.h>

#include <map>

namespace meridian {

Insertion insert_curves(const Triangle_surface& root, Refined_surface& s, const std::vector<Surface_curve>& curves,
                        bool mark_seam)
{
  Insertion result;
  std::vector<internal::Edge_point> edge_points;
  std::vector<internal::Chord> chords;

  std::map<Index, Index> vertex_of_node;

  const auto is_end = [&](Index v, Index h) { return s.source(h) == v || s.target(h) == v; };

  // Points become vertices, numbered along the curves.
  for (const Surface_curve& curve : curves)
  {
    auto& path = result.vertices.emplace_back();
    for (const Curve_point& p : curve.points)
    {
      if (p.is_vertex())
      {
        path.push_back(p.vertex);
        continue;
      }
      const Index v = s.number_of_vertices();
      if (p.node >= 0)
      {
        const auto [known, is_new] = vertex_of_node.try_emplace(p.node, v);
        if (!is_new)
        {
          path.push_back(known->second);
          continue;
        }
      }
      const Index e = s.edge(p.halfedge);
      edge_points.push_back({e, e == p.halfedge ? p.t : 1 - p.t, v});
      const Origin origin = origin_on(root, s, p.halfedge, p.t);
      s.origins.push_back(origin);
      s.points.push_back(position(root, origin));
      s.outgoing.push_back(-1);
      path.push_back(v);
    }
    const std::size_t n = path.size();
    for (std::size_t i = 0; i + (curve.closed ? 0 : 1) < n; ++i)
    {
      const Curve_point &p = curve.points[i], &q = curve.points[(i + 1) % n];
      if (p.is_vertex() && q.is_vertex()) { continue; } // an edge of the surface already
      // a part of one
      if (p.is_vertex() ? is_end(p.vertex, q.halfedge) : q.is_vertex() && is_end(q.vertex, p.halfedge)) { continue; }
      const Index face = s.face(p.is_vertex() ? q.halfedge : s.opposite[p.halfedge]);
      chords.push_back({face, path[i], path[(i + 1) % n]});
    }
  }

  internal::split_faces(s, edge_points, chords, result.first_new_face, result.parent);

  if (mark_seam)
    for (std::size_t c = 0; c < curves.size(); ++c)
    {
      const auto& path = result.vertices[c];
      for (std::size_t i = 0; i + (curves[c].closed ? 0 : 1) < path.size(); ++i)
      {
        const Index h = s.find_halfedge(path[i], path[(i + 1) % path.size()]);
        const Index g = h >= 0 ? s.opposite[h] : s.find_halfedge(path[(i + 1) % path.size()], path[i]);
        if (h < 0 && g < 0) { throw Internal_error("insert_curves: two consecutive points are not joined by an edge"); }
        if (h >= 0) { s.seam[h] = 1; }
        if (g >= 0) { s.seam[g] = 1; }
      }
    }
  return result;
}

} // namespace meridian
