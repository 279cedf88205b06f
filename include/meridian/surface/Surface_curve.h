// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_SURFACE_SURFACE_CURVE_H
#define MERIDIAN_SURFACE_SURFACE_CURVE_H

#include <meridian/base/vectors.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/edge_places.h>

#include <vector>

namespace meridian {

/// \ingroup PkgMeridianSurface
/// a point of a curve: on a vertex, or inside an edge.
struct Curve_point : Edge_place
{
  Index vertex = -1; ///< the vertex, or -1 for a point inside an edge
  Index node = -1;   ///< points of an edge with the same number from 0 on are one point, where curves meet

  /// \param v a vertex \returns the point there
  static Curve_point on_vertex(Index v) { return {{}, v, -1}; }
  /// \param h the halfedge \param t where on it, from 0 to 1 \returns the point there, with a node of its own
  static Curve_point on_edge(Index h, double t) { return {{h, t}, -1, -1}; }
  /// \returns whether it lies on a vertex
  bool is_vertex() const { return vertex >= 0; }
};

/// \ingroup PkgMeridianSurface
/// a curve on a surface, the one type that producers make and `insert_curves()` takes.
///
/// Between two points it runs straight through one face, or along the edge that joins two vertices.
/// A point inside an edge names the halfedge of the face that the curve comes from; the curve goes on
/// in the face of the opposite halfedge.
struct Surface_curve
{
  std::vector<Curve_point> points; ///< in order
  bool closed = false;             ///< the last point is joined to the first, which is not repeated
};

/// \ingroup PkgMeridianSurface
/// \returns where a point of a curve lies in space
/// \param s the surface
/// \param p the point
inline Point position(const Triangle_surface& s, const Curve_point& p)
{
  return p.is_vertex() ? s.points[p.vertex] : s.point_on(p.halfedge, p.t);
}

/// \ingroup PkgMeridianSurface
/// \returns the length of the curve in the unit of the points
/// \param s the surface
/// \param curve the curve
double length(const Triangle_surface& s, const Surface_curve& curve);

} // namespace meridian

#endif // MERIDIAN_SURFACE_SURFACE_CURVE_H
