// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_BASE_RESULT_MESH_H
#define MERIDIAN_BASE_RESULT_MESH_H

#include <meridian/base/vectors.h>

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace meridian {

/// \ingroup PkgMeridianResults
/// where a vertex of a result lies on the input file: on a vertex, inside an edge or inside a face.
struct Result_origin
{
  /// what a vertex may lie on.
  enum Kind : std::uint8_t
  {
    VERTEX,
    EDGE,
    FACE
  };
  Kind kind = VERTEX;                        ///< what it lies on
  std::array<std::int32_t, 2> index{-1, -1}; ///< a vertex; two vertices, the lower first; or a triangle of the input
  std::array<double, 3> weight{0, 0, 0};     ///< nothing; the fraction from the first; or barycentric coordinates

  /// \param o another origin \returns whether both are the same, to the bit
  bool operator==(const Result_origin& o) const { return kind == o.kind && index == o.index && weight == o.weight; }
};

/// \ingroup PkgMeridianResults
/// a mesh made from an input file, with the map that leads back: the vertices of the file first, then new ones, then
/// copies.
struct Result_mesh
{
  std::vector<Point> points;                      ///< one a vertex
  std::vector<std::array<std::int32_t, 3>> faces; ///< the vertices of each
  std::vector<std::int32_t> copy_of;              ///< for each vertex the one it doubles, or -1
  std::vector<Result_origin> origin;              ///< for each vertex
  std::vector<std::int32_t> face_of;              ///< for each face the polygon of the input
  std::vector<std::int32_t> component_of;         ///< for each face
  /// for each face the disc that it is in, those of all components numbered through; empty: each component is one disc
  std::vector<std::int32_t> chart_of;
  /// pairs of sides that were one edge; side `3*f + k` leaves corner `k` of face `f`
  std::vector<std::array<std::int32_t, 2>> seams;
};

/// \ingroup PkgMeridianResults
/// a named curve of a result: vertices in order, the first repeated at the end if it is closed.
struct Result_curve
{
  std::string name;                 ///< in the file
  std::vector<std::int32_t> points; ///< vertices of the result
  /// of flow lines: values at vertices of the input around, linear along its edges
  std::map<std::int32_t, double> field;
};

/// \ingroup PkgMeridianResults
/// \returns the position of an origin, by the one formula
/// \param o the origin
/// \param points the points of the input
/// \param triangle a function: the corners of triangle `i` of the input, as `for_each_triangle()` counts them
template <class Triangles>
Point position_of(const Result_origin& o, const std::vector<Point>& points, const Triangles& triangle)
{
  if (o.kind == Result_origin::VERTEX) { return points[o.index[0]]; }
  Point p;
  for (int i = 0; i < 3; ++i)
  {
    if (o.kind == Result_origin::EDGE)
    {
      const double a = points[o.index[0]][i], b = points[o.index[1]][i];
      p[i] = a + o.weight[0] * (b - a);
      continue;
    }
    const auto& corner = triangle(o.index[0]);
    p[i] =
      (o.weight[0] * points[corner[0]][i] + o.weight[1] * points[corner[1]][i]) + o.weight[2] * points[corner[2]][i];
  }
  return p;
}

} // namespace meridian

#endif // MERIDIAN_BASE_RESULT_MESH_H
