// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MESH_INTERNAL_CONVERT_H
#define MERIDIAN_MESH_INTERNAL_CONVERT_H

#include <meridian/base/exceptions.h>
#include <meridian/base/vectors.h>
#include <meridian/field/Scalar_field.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/check_surface.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <iterator>
#include <map>
#include <string>

namespace meridian {
namespace internal {

// Numbers the vertices of a mesh in the order of `vertices(tm)`, whatever their descriptors are.
template <class TriangleMesh> class Vertex_numbers
{
public:
  using Vertex = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  explicit Vertex_numbers(const TriangleMesh& tm)
  {
    Index i = 0;
    for (Vertex v : vertices(tm)) { m_number[v] = i++; }
  }
  Index operator[](Vertex v) const { return m_number.at(v); }

private:
  std::map<Vertex, Index> m_number;
};

template <class TriangleMesh, class VertexPointMap> Triangle_surface convert(const TriangleMesh& tm, VertexPointMap vpm)
{
  const Vertex_numbers<TriangleMesh> number(tm);
  Triangle_surface s;
  for (auto v : vertices(tm))
  {
    const auto& p = get(vpm, v);
    const Point q{CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
    if (!std::isfinite(q[0]) || !std::isfinite(q[1]) || !std::isfinite(q[2]))
      throw Invalid_input_error("vertex " + std::to_string(number[v])
                                + " has a coordinate that is not a finite number");
    s.points.push_back(q);
  }
  for (auto f : faces(tm))
  {
    std::vector<Index> corners;
    for (auto v : CGAL::vertices_around_face(halfedge(f, tm), tm)) { corners.push_back(number[v]); }
    if (corners.size() != 3)
      throw Invalid_input_error("face " + std::to_string(s.triangles.size()) + " has " + std::to_string(corners.size())
                                + " corners; divide it into triangles first");
    s.triangles.push_back({corners[0], corners[1], corners[2]});
  }
  connect(s);
  check_fans(s);
  return s;
}

// The vertices of a mesh in the order of its surface.
template <class TriangleMesh>
std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> vertices_of(const TriangleMesh& tm)
{
  std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor> all;
  for (auto v : vertices(tm)) { all.push_back(v); }
  return all;
}

// The halfedges of a mesh in the order of its surface: halfedge k of a face leaves its corner k, so that corners are
// the targets from the face's own halfedge on.
template <class TriangleMesh>
std::vector<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor> halfedges_of(const TriangleMesh& tm)
{
  std::vector<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor> all;
  for (auto f : faces(tm))
  {
    const auto last = halfedge(f, tm), first = next(last, tm);
    all.insert(all.end(), {first, next(first, tm), last});
  }
  return all;
}

// Whoever receives a result has nothing yet, least of all the input.
template <class Mesh> void check_is_empty(const Mesh& mesh)
{
  const auto all = vertices(mesh);
  const auto number = std::distance(all.begin(), all.end());
  if (number > 0)
    throw Invalid_input_error("the mesh that shall receive the result has " + std::to_string(number)
                              + " vertices already; give an empty one");
}

// Adds vertices and faces to an empty mesh; returns the vertices.
template <class Mesh>
std::vector<typename boost::graph_traits<Mesh>::vertex_descriptor>
build(const std::vector<Point>& points, const std::vector<std::array<Index, 3>>& triangles, Mesh& mesh)
{
  using Vertex = typename boost::graph_traits<Mesh>::vertex_descriptor;
  const auto vpm = get(CGAL::vertex_point, mesh);
  using Mesh_point = typename boost::property_traits<decltype(vpm)>::value_type;
  std::vector<Vertex> vertex;
  for (const Point& p : points)
  {
    vertex.push_back(add_vertex(mesh));
    put(vpm, vertex.back(), Mesh_point(p[0], p[1], p[2]));
  }
  for (const auto& t : triangles)
  {
    const std::array<Vertex, 3> corners{vertex[t[0]], vertex[t[1]], vertex[t[2]]};
    if (CGAL::Euler::add_face(corners, mesh) == boost::graph_traits<Mesh>::null_face())
      throw Internal_error("a face cannot be added to the mesh");
  }
  return vertex;
}

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_MESH_INTERNAL_CONVERT_H
