// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_SURFACE_INSERT_CURVES_H
#define MERIDIAN_SURFACE_INSERT_CURVES_H

#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/Surface_curve.h>
#include <meridian/surface/internal/split_face.h>

#include <map>

namespace meridian {

/// \ingroup PkgMeridianSurface
/// what `insert_curves()` did.
struct Insertion
{
  std::vector<std::vector<Index>> vertices; ///< for each curve, its points as vertices of the refined surface
  Index first_new_face = 0;                 ///< faces from this index on were appended
  std::vector<Index> parent;                ///< the face that each appended face was part of
};

/*!
 * \ingroup PkgMeridianSurface
 *
 * refines a surface so that every curve becomes a set of edges, and flags these as seam.
 *
 * Each face that is crossed is divided by its chords and the parts are triangulated so that their
 * smallest angle is as large as it can be; no point is added that is not on a curve. A curve of one
 * point divides an edge and flags nothing.
 *
 * \param root the surface that `s` refines
 * \param s the surface to refine. A face keeps its index for its first part.
 * \param curves the curves; on one edge, different points have different fractions, and points of one node have the
 *   same
 * \param mark_seam whether the curves' edges are flagged
 *
 * \returns the curves' vertices and the new faces' parents. New vertices are numbered along the curves.
 *
 * \pre the curves are simple and disjoint (they may share vertices of the surface, and nodes)
 * \throws Internal_error if two chords of a face cross
 *
 * \par Complexity
 * \f$ O(k \log k) \f$ for `k` points; faces that are not crossed are not touched.
 */
inline Insertion insert_curves(const Triangle_surface& root, Refined_surface& s,
                               const std::vector<Surface_curve>& curves, bool mark_seam = true)
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

#endif // MERIDIAN_SURFACE_INSERT_CURVES_H
