// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_SURFACE_TRIANGLE_SURFACE_H
#define MERIDIAN_SURFACE_TRIANGLE_SURFACE_H

#include <meridian/base/vectors.h>

#include <algorithm>
#include <array>
#include <vector>

namespace meridian {

/// \ingroup PkgMeridianSurface
/// an oriented triangulated 2-manifold, with or without boundary, in plain arrays.
///
/// Halfedge `3*f + k` runs from corner `k` of face `f` to the next corner. Every algorithm of the
/// package works on this type; models of CGAL's `FaceGraph` are converted once, at the rim.
struct Triangle_surface
{
  std::vector<Point> points;                   ///< one a vertex
  std::vector<std::array<Index, 3>> triangles; ///< vertices of each face, counterclockwise
  std::vector<Index> opposite;                 ///< the twin of each halfedge, -1 on the boundary
  std::vector<Index> outgoing;                 ///< a halfedge leaving each vertex; the boundary one where there is one

  /// \returns how many vertices there are, those without faces too
  Index number_of_vertices() const { return static_cast<Index>(points.size()); }
  /// \returns how many faces there are
  Index number_of_faces() const { return static_cast<Index>(triangles.size()); }
  Index number_of_halfedges() const { return 3 * number_of_faces(); } ///< \returns three a face
  /// \returns how many halfedges have no twin
  Index number_of_boundary_halfedges() const
  {
    return static_cast<Index>(std::count(opposite.begin(), opposite.end(), -1));
  }
  /// \returns how many edges there are, those on the boundary too
  Index number_of_edges() const { return (number_of_halfedges() + number_of_boundary_halfedges()) / 2; }

  static Index face(Index h) { return h / 3; } ///< \param h a halfedge \returns its face
  /// \param h a halfedge \returns the one after it in its face
  static Index next(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
  /// \param h a halfedge \returns the one before it in its face
  static Index prev(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }
  /// \param h a halfedge \returns the vertex it leaves
  Index source(Index h) const { return triangles[h / 3][h % 3]; }
  Index target(Index h) const { return source(next(h)); } ///< \param h a halfedge \returns the vertex it comes to
  Index apex(Index h) const { return source(prev(h)); }   ///< \param h a halfedge \returns the corner across from it
  /// \param h a halfedge \returns the next halfedge leaving the same vertex, counterclockwise; -1 past the boundary
  Index turn_left(Index h) const { return opposite[prev(h)]; }
  /// \param h a halfedge \returns the next halfedge leaving the same vertex, clockwise; -1 past the boundary
  Index turn_right(Index h) const { return opposite[h] < 0 ? -1 : next(opposite[h]); }
  /// \param v a vertex with faces \returns whether it lies on the boundary
  bool is_boundary_vertex(Index v) const { return opposite[outgoing[v]] < 0; }
  /// \param h a halfedge \returns one of the two halfedges of its edge, the same whichever is given
  Index edge(Index h) const { return opposite[h] < 0 ? h : std::min(h, opposite[h]); }

  /// calls `f(h)` for each halfedge leaving `v`, counterclockwise, once for each face at `v`
  /// \param v a vertex with faces
  /// \param f the function
  template <class Function> void for_each_outgoing(Index v, Function f) const
  {
    const Index first = outgoing[v];
    Index h = first;
    do {
      f(h);
      h = turn_left(h);
    } while (h >= 0 && h != first);
  }

  /// \param u, v vertices, `u` with faces \returns the halfedge from `u` to `v`, or -1
  Index find_halfedge(Index u, Index v) const;

  /// \param h a halfedge \param t a fraction from its source, from 0 to 1 \returns the position there
  Point point_on(Index h, double t) const;
  /// \param h a halfedge \returns its length
  double length(Index h) const { return distance(points[source(h)], points[target(h)]); }
};

/// \ingroup PkgMeridianSurface
/// finds a halfedge for every vertex, that on the boundary where there is one.
/// \param s the surface
/// \pre the twins are known
void find_outgoing(Triangle_surface& s);

/// \ingroup PkgMeridianSurface
/// finds the twins of all halfedges and a halfedge for every vertex.
/// \param s the surface
///
/// \pre every edge has at most two faces, which run along it in opposite directions, and the faces
///      of every vertex form one fan
/// \throws Internal_error if an edge is used twice in one direction
/// \par Complexity
/// Linear: halfedges are sorted by their lower vertex with one counting pass.
void connect(Triangle_surface& s);

/// \ingroup PkgMeridianSurface
/// \returns the boundary loops, each as its halfedges in order (the surface on their left), sorted by
///          lowest vertex; linear
/// \param s the surface
std::vector<std::vector<Index>> boundary_loops(const Triangle_surface& s);

} // namespace meridian

#endif // MERIDIAN_SURFACE_TRIANGLE_SURFACE_H
