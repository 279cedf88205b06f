// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_SURFACE_REFINED_SURFACE_H
#define MERIDIAN_SURFACE_REFINED_SURFACE_H

#include <meridian/base/vectors.h>
#include <meridian/surface/Triangle_surface.h>

#include <array>
#include <cstdint>
#include <numeric>
#include <vector>

namespace meridian {

/// \ingroup PkgMeridianSurface
/// where a vertex of a refined surface lies on the surface that it refines, called its root.
struct Origin
{
  /// what a vertex may lie on.
  enum Kind : std::uint8_t
  {
    VERTEX,
    EDGE,
    FACE
  };
  Kind kind = VERTEX;                    ///< what it lies on
  std::array<Index, 2> index{-1, -1};    ///< the vertex; the two ends, lower first; or the face
  std::array<double, 3> weight{0, 0, 0}; ///< nothing; the fraction from the first end; or barycentric coordinates

  /// \param v a vertex of the root \returns the origin of what lies on it
  static Origin on_vertex(Index v) { return {VERTEX, {v, -1}, {0, 0, 0}}; }
  /// \param v, w the ends of an edge, in any order \param t the fraction from `v` \returns the origin there
  static Origin on_edge(Index v, Index w, double t)
  {
    return v < w ? Origin{EDGE, {v, w}, {t, 0, 0}} : Origin{EDGE, {w, v}, {1 - t, 0, 0}};
  }
  /// \param f a face of the root \param b barycentric coordinates in it \returns the origin there
  static Origin in_face(Index f, const Point& b) { return {FACE, {f, -1}, {b[0], b[1], b[2]}}; }
};

/// \ingroup PkgMeridianSurface
/// a subdivision of a root surface that remembers where everything came from.
///
/// The vertices of the root come first and keep their indices. A root vertex that is only passed by
/// stays what it is; faces that no curve crosses keep their indices too.
struct Refined_surface : Triangle_surface
{
  Index root_vertices = 0;     ///< how many vertices the root has
  std::vector<Origin> origins; ///< of the vertices from `root_vertices` on
  std::vector<Index> face_of;  ///< the root face that holds each face
  std::vector<char> seam;      ///< the edge constraint map: one flag a halfedge, equal on twins

  Refined_surface() = default;
  /// not refined yet. \param root the root, which is copied
  explicit Refined_surface(const Triangle_surface& root)
    : Triangle_surface(root), root_vertices(root.number_of_vertices()), face_of(root.number_of_faces()),
      seam(root.number_of_halfedges(), 0)
  {
    std::iota(face_of.begin(), face_of.end(), Index(0));
  }

  /// \param v a vertex \returns where it lies on the root
  Origin origin(Index v) const { return v < root_vertices ? Origin::on_vertex(v) : origins[v - root_vertices]; }
  /// \param h a halfedge \returns whether its edge is a seam or on the boundary
  bool is_seam_or_boundary(Index h) const { return opposite[h] < 0 || seam[h]; }
};

/// \ingroup PkgMeridianSurface
/// \returns whether the refined edge between two origins lies on an edge of the root; if so, that
///          edge's ends are written to `ends` and the two fractions along it to `t`
/// \param x, y the origins of its vertices
/// \param ends receives the vertices of the root, lower first
/// \param t receives the fractions of `x` and `y`, from the lower vertex
bool on_common_root_edge(const Origin& x, const Origin& y, std::array<Index, 2>& ends, std::array<double, 2>& t);

/// \ingroup PkgMeridianSurface
/// \returns barycentric coordinates of an origin in a root face that holds it
/// \param root the root
/// \param face the face
/// \param o the origin
Point barycentric_in(const Triangle_surface& root, Index face, const Origin& o);

/// \ingroup PkgMeridianSurface
/// \returns the origin of the point at fraction `t` of halfedge `h`
/// \param root the root
/// \param s a refinement of it
/// \param h a halfedge of `s`
/// \param t the fraction from its source, from 0 to 1
Origin origin_on(const Triangle_surface& root, const Refined_surface& s, Index h, double t);

/// \ingroup PkgMeridianSurface
/// \returns the position of an origin
/// \param root the root
/// \param o the origin
Point position(const Triangle_surface& root, const Origin& o);

} // namespace meridian

#endif // MERIDIAN_SURFACE_REFINED_SURFACE_H
