// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_SURFACE_REFINED_SURFACE_H
#define MERIDIAN_SURFACE_REFINED_SURFACE_H

#include <meridian/surface/Triangle_surface.h>

#include <array>
#include <numeric>

namespace meridian {

/// \ingroup PkgMeridianSurface
/// where a vertex of a refined surface lies on the surface that it refines, called its root.
struct Origin
{
  enum Kind : std::uint8_t
  {
    VERTEX,
    EDGE,
    FACE
  };
  Kind kind = VERTEX;
  std::array<Index, 2> index{-1, -1};    ///< the vertex; the two ends, lower first; or the face
  std::array<double, 3> weight{0, 0, 0}; ///< nothing; the fraction from the first end; or barycentric coordinates

  static Origin on_vertex(Index v) { return {VERTEX, {v, -1}, {0, 0, 0}}; }
  static Origin on_edge(Index v, Index w, double t)
  {
    return v < w ? Origin{EDGE, {v, w}, {t, 0, 0}} : Origin{EDGE, {w, v}, {1 - t, 0, 0}};
  }
  static Origin in_face(Index f, const Point& b) { return {FACE, {f, -1}, {b[0], b[1], b[2]}}; }
};

/// \ingroup PkgMeridianSurface
/// a subdivision of a root surface that remembers where everything came from.
///
/// The vertices of the root come first and keep their indices. A root vertex that is only passed by
/// stays what it is; faces that no curve crosses keep their indices too.
struct Refined_surface : Triangle_surface
{
  Index root_vertices = 0;
  std::vector<Origin> origins; ///< of the vertices from `root_vertices` on
  std::vector<Index> face_of;  ///< the root face that holds each face
  std::vector<char> seam;      ///< the edge constraint map: one flag a halfedge, equal on twins

  Refined_surface() = default;
  explicit Refined_surface(const Triangle_surface& root)
    : Triangle_surface(root), root_vertices(root.number_of_vertices()), face_of(root.number_of_faces()),
      seam(root.number_of_halfedges(), 0)
  {
    std::iota(face_of.begin(), face_of.end(), Index(0));
  }

  Origin origin(Index v) const { return v < root_vertices ? Origin::on_vertex(v) : origins[v - root_vertices]; }
  bool is_seam_or_boundary(Index h) const { return opposite[h] < 0 || seam[h]; }
};

/// \ingroup PkgMeridianSurface
/// \returns whether the refined edge between two origins lies on an edge of the root; if so, that
///          edge's ends are written to `ends` and the two fractions along it to `t`
inline bool on_common_root_edge(const Origin& x, const Origin& y, std::array<Index, 2>& ends, std::array<double, 2>& t)
{
  if (x.kind == Origin::FACE || y.kind == Origin::FACE) { return false; }
  if (x.kind == Origin::VERTEX && y.kind == Origin::VERTEX)
    ends = {std::min(x.index[0], y.index[0]), std::max(x.index[0], y.index[0])};
  else ends = x.kind == Origin::EDGE ? x.index : y.index;
  const std::array<const Origin*, 2> both{&x, &y};
  for (int i = 0; i < 2; ++i)
  {
    const Origin& o = *both[i];
    if (o.kind == Origin::EDGE)
    {
      if (o.index != ends) { return false; }
      t[i] = o.weight[0];
    }
    else if (o.index[0] == ends[0]) { t[i] = 0; }
    else if (o.index[0] == ends[1]) { t[i] = 1; }
    else { return false; }
  }
  return true;
}

/// \ingroup PkgMeridianSurface
/// \returns barycentric coordinates of an origin in a root face that holds it
inline Point barycentric_in(const Triangle_surface& root, Index face, const Origin& o)
{
  if (o.kind == Origin::FACE) { return {o.weight[0], o.weight[1], o.weight[2]}; }
  Point b{0, 0, 0};
  const auto corner = [&](Index v) {
    for (int k = 0; k < 3; ++k)
      if (root.triangles[face][k] == v) { return k; }
    throw Internal_error("barycentric_in: a vertex does not lie on the face that is said to hold it");
  };
  if (o.kind == Origin::VERTEX)
  {
    b[corner(o.index[0])] = 1;
    return b;
  }
  b[corner(o.index[0])] = 1 - o.weight[0];
  b[corner(o.index[1])] = o.weight[0];
  return b;
}

/// \ingroup PkgMeridianSurface
/// \returns the origin of the point at fraction `t` of halfedge `h`
inline Origin origin_on(const Triangle_surface& root, const Refined_surface& s, Index h, double t)
{
  const Origin x = s.origin(s.source(h)), y = s.origin(s.target(h));
  std::array<Index, 2> ends;
  std::array<double, 2> at;
  if (on_common_root_edge(x, y, ends, at)) { return Origin::on_edge(ends[0], ends[1], at[0] + t * (at[1] - at[0])); }
  const Index f = s.face_of[s.face(h)];
  const Point bx = barycentric_in(root, f, x), by = barycentric_in(root, f, y);
  return Origin::in_face(f, bx + t * (by - bx));
}

/// \ingroup PkgMeridianSurface
/// \returns the position of an origin
inline Point position(const Triangle_surface& root, const Origin& o)
{
  if (o.kind == Origin::VERTEX) { return root.points[o.index[0]]; }
  if (o.kind == Origin::EDGE)
  {
    const Point &a = root.points[o.index[0]], &b = root.points[o.index[1]];
    return a + o.weight[0] * (b - a);
  }
  const auto& corner = root.triangles[o.index[0]];
  return (o.weight[0] * root.points[corner[0]] + o.weight[1] * root.points[corner[1]])
         + o.weight[2] * root.points[corner[2]];
}

} // namespace meridian

#endif // MERIDIAN_SURFACE_REFINED_SURFACE_H
