// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_SURFACE_TRIANGLE_SURFACE_H
#define MERIDIAN_SURFACE_TRIANGLE_SURFACE_H

#include <meridian/base/exceptions.h>
#include <meridian/base/vectors.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
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

  Index number_of_vertices() const { return static_cast<Index>(points.size()); }
  Index number_of_faces() const { return static_cast<Index>(triangles.size()); }
  Index number_of_halfedges() const { return 3 * number_of_faces(); }
  Index number_of_boundary_halfedges() const
  {
    return static_cast<Index>(std::count(opposite.begin(), opposite.end(), -1));
  }
  Index number_of_edges() const { return (number_of_halfedges() + number_of_boundary_halfedges()) / 2; }

  static Index face(Index h) { return h / 3; }
  static Index next(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static Index prev(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }
  Index source(Index h) const { return triangles[h / 3][h % 3]; }
  Index target(Index h) const { return source(next(h)); }
  Index apex(Index h) const { return source(prev(h)); } ///< the corner across from `h`
  /// the next halfedge leaving the same vertex, counterclockwise; -1 past the boundary
  Index turn_left(Index h) const { return opposite[prev(h)]; }
  /// the next halfedge leaving the same vertex, clockwise; -1 past the boundary
  Index turn_right(Index h) const { return opposite[h] < 0 ? -1 : next(opposite[h]); }
  bool is_boundary_vertex(Index v) const { return opposite[outgoing[v]] < 0; }
  /// one of the two halfedges of an edge, the same whichever is given
  Index edge(Index h) const { return opposite[h] < 0 ? h : std::min(h, opposite[h]); }

  /// calls `f(h)` for each halfedge leaving `v`, counterclockwise, once for each face at `v`
  template <class Function> void for_each_outgoing(Index v, Function f) const
  {
    const Index first = outgoing[v];
    Index h = first;
    do {
      f(h);
      h = turn_left(h);
    } while (h >= 0 && h != first);
  }

  /// \returns the halfedge from `u` to `v`, or -1
  Index find_halfedge(Index u, Index v) const
  {
    Index found = -1;
    for_each_outgoing(u, [&](Index h) {
      if (target(h) == v) { found = h; }
    });
    return found;
  }

  Point point_on(Index h, double t) const
  {
    const Point &a = points[source(h)], &b = points[target(h)];
    return a + t * (b - a);
  }
  double length(Index h) const { return distance(points[source(h)], points[target(h)]); }
};

/// \ingroup PkgMeridianSurface
/// finds a halfedge for every vertex, that on the boundary where there is one.
/// \pre the twins are known
inline void find_outgoing(Triangle_surface& s)
{
  s.outgoing.assign(s.number_of_vertices(), -1);
  for (Index h = 0; h < s.number_of_halfedges(); ++h)
    if (s.outgoing[s.source(h)] < 0 || s.opposite[h] < 0) { s.outgoing[s.source(h)] = h; }
}

/// \ingroup PkgMeridianSurface
/// finds the twins of all halfedges and a halfedge for every vertex.
///
/// \pre every edge has at most two faces, which run along it in opposite directions, and the faces
///      of every vertex form one fan
/// \throws Internal_error if an edge is used twice in one direction
/// \par Complexity
/// Linear: halfedges are sorted by their lower vertex with one counting pass.
inline void connect(Triangle_surface& s)
{
  const Index n = s.number_of_vertices(), halfedges = s.number_of_halfedges();
  std::vector<Index> begin(n + 1, 0), bucket(halfedges);
  const auto lower = [&](Index h) { return std::min(s.source(h), s.target(h)); };
  for (Index h = 0; h < halfedges; ++h) { ++begin[lower(h) + 1]; }
  for (Index v = 0; v < n; ++v) { begin[v + 1] += begin[v]; }
  std::vector<Index> fill(begin.begin(), begin.end() - 1);
  for (Index h = 0; h < halfedges; ++h) { bucket[fill[lower(h)]++] = h; }

  s.opposite.assign(halfedges, -1);
  std::vector<std::pair<Index, Index>> around; // (upper vertex, halfedge)
  for (Index v = 0; v < n; ++v)
  {
    around.clear();
    for (Index i = begin[v]; i < begin[v + 1]; ++i)
    {
      const Index h = bucket[i];
      around.emplace_back(std::max(s.source(h), s.target(h)), h);
    }
    std::sort(around.begin(), around.end());
    for (std::size_t i = 0; i + 1 < around.size(); ++i)
    {
      if (around[i].first != around[i + 1].first) { continue; }
      const Index g = around[i].second, h = around[i + 1].second;
      if (s.source(g) == s.source(h) || s.opposite[g] >= 0)
        throw Internal_error("connect: an edge has two faces on one side");
      s.opposite[g] = h;
      s.opposite[h] = g;
    }
  }
  find_outgoing(s);
}

/// \ingroup PkgMeridianSurface
/// \returns the boundary loops, each as its halfedges in order (the surface on their left), sorted by
///          lowest vertex; linear
inline std::vector<std::vector<Index>> boundary_loops(const Triangle_surface& s)
{
  std::vector<std::vector<Index>> loops;
  std::vector<char> seen(s.number_of_vertices(), 0);
  for (Index v = 0; v < s.number_of_vertices(); ++v)
  {
    if (seen[v] || s.outgoing[v] < 0 || !s.is_boundary_vertex(v)) { continue; }
    loops.emplace_back();
    for (Index u = v; !seen[u]; u = s.target(s.outgoing[u]))
    {
      seen[u] = 1;
      loops.back().push_back(s.outgoing[u]);
    }
  }
  return loops;
}

} // namespace meridian

#endif // MERIDIAN_SURFACE_TRIANGLE_SURFACE_H
