// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MESH_INTERNAL_REFINE_MESH_H
#define MERIDIAN_MESH_INTERNAL_REFINE_MESH_H

#include <meridian/base/exceptions.h>
#include <meridian/base/vectors.h>
#include <meridian/mesh/internal/convert.h>
#include <meridian/mesh/parameters.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/Triangle_surface.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>

#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace meridian {
namespace internal {

// Divides a mesh as a refined surface divides its root. Vertices and faces that are not divided, and all edges that are
// not crossed, stay what they are, with whatever properties they have; a divided face becomes its first part.
//
// The mesh is one that the root was made of, so its vertices and faces come in the root's order.
template <class Mesh> class Mesh_refiner
{
public:
  using Graph = boost::graph_traits<Mesh>;
  using Vertex = typename Graph::vertex_descriptor;
  using Halfedge = typename Graph::halfedge_descriptor;
  using Face = typename Graph::face_descriptor;

  Mesh_refiner(const Triangle_surface& root, const Refined_surface& refined, Mesh& mesh)
    : m_root(root), m_refined(refined), m_mesh(mesh), m_vertex(refined.number_of_vertices(), Graph::null_vertex()),
      m_halfedge(refined.number_of_halfedges(), Graph::null_halfedge())
  {
    std::size_t v = 0;
    for (Vertex w : vertices(mesh)) { m_vertex[v++] = w; }
    for (Face f : faces(mesh)) { m_face.push_back(f); }
    m_side = halfedges_of(mesh);
  }
  Mesh_refiner(Triangle_surface&&, const Refined_surface&, Mesh&) = delete;
  Mesh_refiner(const Triangle_surface&, Refined_surface&&, Mesh&) = delete;

  void run()
  {
    divide_edges();
    std::vector<std::vector<Index>> parts(m_root.number_of_faces());
    for (Index f = 0; f < m_refined.number_of_faces(); ++f) { parts[m_refined.face_of[f]].push_back(f); }
    for (Index f = 0; f < m_root.number_of_faces(); ++f)
    {
      if (parts[f].size() > 1) { divide_face(m_face[f], parts[f]); }
    }
  }

  // Of the refined surface's vertices and halfedges.
  Vertex vertex(Index v) const { return m_vertex[v]; }
  Halfedge halfedge_of(Index h) const { return m_halfedge[h]; }

private:
  // Whether the other side of an edge of the refined surface lies in another face of the root, or nowhere.
  bool is_on_side(Index h) const
  {
    const Index o = m_refined.opposite[h];
    return o < 0 || m_refined.face_of[m_refined.face(o)] != m_refined.face_of[m_refined.face(h)];
  }

  void divide_edges()
  {
    // the halfedge that leaves a vertex along the sides of a root face
    std::vector<std::vector<Index>> sides(m_root.number_of_faces());
    for (Index h = 0; h < m_refined.number_of_halfedges(); ++h)
    {
      if (is_on_side(h)) { sides[m_refined.face_of[m_refined.face(h)]].push_back(h); }
    }
    for (Index h = 0; h < m_root.number_of_halfedges(); ++h)
    {
      const Index o = m_root.opposite[h];
      if (o >= 0 && o < h) { continue; } // done from there
      divide_edge(m_side[h], along_side(h, sides[m_root.face(h)]));
    }
  }

  // The halfedges of the refined surface along one of its root, in order.
  std::vector<Index> along_side(Index h, const std::vector<Index>& sides) const
  {
    std::vector<Index> along;
    for (Index at = m_root.source(h); at != m_root.target(h); at = m_refined.target(along.back()))
    {
      std::size_t i = 0;
      while (i < sides.size() && m_refined.source(sides[i]) != at) { ++i; }
      if (i == sides.size()) { throw Internal_error("refine_mesh: a side of a face has a gap"); }
      along.push_back(sides[i]);
    }
    return along;
  }

  void divide_edge(Halfedge side, const std::vector<Index>& along)
  {
    for (std::size_t i = 0; i < along.size(); ++i)
    {
      Halfedge part = side;
      if (i + 1 < along.size())
      {
        part = CGAL::Euler::split_edge(side, m_mesh); // the first part; `side` is the rest
        m_vertex[m_refined.target(along[i])] = target(part, m_mesh);
      }
      join(along[i], part);
    }
  }

  // Says that a halfedge of the refined surface is one of the mesh, and so for the opposite one.
  void join(Index h, Halfedge own)
  {
    m_halfedge[h] = own;
    if (m_refined.opposite[h] >= 0) { m_halfedge[m_refined.opposite[h]] = opposite(own, m_mesh); }
  }

  void divide_face(Face whole, const std::vector<Index>& parts)
  {
    for (Index f : parts)
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
      {
        Vertex& v = m_vertex[m_refined.source(h)];
        if (v == Graph::null_vertex()) { v = add_vertex(m_mesh); } // inside of the face
      }
    for (Index f : parts)
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
      {
        if (m_halfedge[h] != Graph::null_halfedge()) { continue; }
        const Halfedge own = halfedge(add_edge(m_mesh), m_mesh);
        set_target(own, m_vertex[m_refined.target(h)], m_mesh);
        set_target(opposite(own, m_mesh), m_vertex[m_refined.source(h)], m_mesh);
        join(h, own);
      }
    for (Index f : parts)
    {
      const Face part = f == parts.front() ? whole : add_face(m_mesh);
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
      {
        set_next(m_halfedge[h], m_halfedge[m_refined.next(h)], m_mesh);
        set_face(m_halfedge[h], part, m_mesh);
        // a new vertex has none yet; the others keep theirs, which may be on the border
        if (m_refined.origin(m_refined.target(h)).kind == Origin::FACE)
        {
          set_halfedge(m_vertex[m_refined.target(h)], m_halfedge[h], m_mesh);
        }
      }
      set_halfedge(part, m_halfedge[3 * f], m_mesh);
    }
  }

  const Triangle_surface& m_root;
  const Refined_surface& m_refined;
  Mesh& m_mesh;
  std::vector<Vertex> m_vertex;     // of each vertex of the refined surface
  std::vector<Halfedge> m_halfedge; // of its halfedges, where a face is divided or an edge of it is
  std::vector<Face> m_face;         // of each face of the root
  std::vector<Halfedge> m_side;     // of each halfedge of the root
};

// What lies between three values as an origin does between the corners of its face, or between the ends of its edge.
// Differences are weighed, so that with exact numbers a new point lies on the face or edge exactly.
template <class Number, class Value> auto interpolate(const Triangle_surface& root, const Origin& o, const Value& at)
{
  if (o.kind == Origin::VERTEX) { return at(o.index[0]); }
  if (o.kind == Origin::EDGE) { return at(o.index[0]) + Number(o.weight[0]) * (at(o.index[1]) - at(o.index[0])); }
  const auto& t = root.triangles[o.index[0]];
  return at(t[0]) + Number(o.weight[1]) * (at(t[1]) - at(t[0])) + Number(o.weight[2]) * (at(t[2]) - at(t[0]));
}

// Gives the points of new vertices, constructed with a number type.
template <class Number, class Refiner, class VertexPointMap>
void place_new_vertices(const Triangle_surface& root, const Refined_surface& s, const Refiner& refiner,
                        VertexPointMap vpm)
{
  using Mesh_point = typename boost::property_traits<VertexPointMap>::value_type;
  using Mesh_number = typename CGAL::Kernel_traits<Mesh_point>::Kernel::FT;
  for (Index v = s.root_vertices; v < s.number_of_vertices(); ++v)
  {
    if constexpr (std::is_floating_point_v<Number>)
    {
      const Point& p = s.points[v];
      put(vpm, refiner.vertex(v), Mesh_point(Mesh_number(p[0]), Mesh_number(p[1]), Mesh_number(p[2])));
      continue;
    }
    const auto coordinate = [&](const auto& read) {
      const Number x =
        interpolate<Number>(root, s.origin(v), [&](Index w) { return Number(read(get(vpm, refiner.vertex(w)))); });
      if constexpr (std::is_constructible_v<Mesh_number, Number>) { return Mesh_number(x); }
      else { return Mesh_number(CGAL::to_double(x)); }
    };
    put(vpm, refiner.vertex(v),
        Mesh_point(coordinate([](const auto& p) { return p.x(); }), coordinate([](const auto& p) { return p.y(); }),
                   coordinate([](const auto& p) { return p.z(); })));
  }
}

// Fills the maps that were given. The field has one value a vertex of the root, or none.
template <class Refiner, class Mesh, class NamedParameters>
void write_maps(const Triangle_surface& root, const Refined_surface& s, const std::vector<double>& field,
                const Refiner& refiner, Mesh& tm, const NamedParameters& np)
{
  using CGAL::parameters::get_parameter;
  if_given(get_parameter(np, CGAL::internal_np::edge_is_constrained), [&](auto map) {
    for (Index h = 0; h < s.number_of_halfedges(); ++h) { put(map, edge(refiner.halfedge_of(h), tm), s.seam[h] != 0); }
  });
  if_given(get_parameter(np, CGAL::internal_np::vertex_is_constrained), [&](auto map) {
    for (Index v = 0; v < s.number_of_vertices(); ++v) { put(map, refiner.vertex(v), false); }
    for (Index h = 0; h < s.number_of_halfedges(); ++h)
    {
      if (s.seam[h]) { put(map, refiner.vertex(s.target(h)), true); }
    }
  });
  if_given(get_parameter(np, internal_np::vertex_field_map), [&](auto map) {
    for (Index v = 0; v < s.number_of_vertices() && !field.empty(); ++v)
    {
      put(map, refiner.vertex(v), interpolate<double>(root, s.origin(v), [&](Index w) { return field[w]; }));
    }
  });
  if_given(get_parameter(np, internal_np::vertex_origin_map), [&](auto map) {
    for (Index v = 0; v < s.number_of_vertices(); ++v) { put(map, refiner.vertex(v), s.origin(v)); }
  });
  if_given(get_parameter(np, internal_np::face_origin_map), [&](auto map) {
    for (Index h = 0; h < s.number_of_halfedges(); h += 3)
    {
      put(map, face(refiner.halfedge_of(h), tm), s.face_of[s.face(h)]);
    }
  });
}

// Divides a mesh, gives its new points, and fills the maps that were given.
template <class Mesh, class NamedParameters>
Mesh_refiner<Mesh> refine_in_place(const Triangle_surface& root, const Refined_surface& s,
                                   const std::vector<double>& field, Mesh& tm, const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  Mesh_refiner<Mesh> refiner(root, s, tm);
  refiner.run();
  const auto points = choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point), get(CGAL::vertex_point, tm));
  using Mesh_point = typename boost::property_traits<std::decay_t<decltype(points)>>::value_type;
  using Kernel = typename CGAL::Kernel_traits<Mesh_point>::Kernel;
  using Traits = std::decay_t<decltype(choose_parameter(get_parameter(np, CGAL::internal_np::geom_traits), Kernel()))>;
  place_new_vertices<typename Traits::FT>(root, s, refiner, points);
  write_maps(root, s, field, refiner, tm, np);
  return refiner;
}

// The halfedges of a mesh along a walk on the refined surface that it was divided as.
template <class Mesh>
std::vector<typename Mesh_refiner<Mesh>::Halfedge> halfedges_along(const Refined_surface& s,
                                                                   const Mesh_refiner<Mesh>& refiner, const Mesh& tm,
                                                                   const std::vector<Index>& walk, bool is_closed)
{
  std::vector<typename Mesh_refiner<Mesh>::Halfedge> halfedges;
  for (std::size_t i = 0; i + (is_closed ? 0 : 1) < walk.size(); ++i)
  {
    const Index v = walk[i], w = walk[(i + 1) % walk.size()], h = s.find_halfedge(v, w);
    halfedges.push_back(h >= 0 ? refiner.halfedge_of(h) : opposite(refiner.halfedge_of(s.find_halfedge(w, v)), tm));
  }
  return halfedges;
}

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_MESH_INTERNAL_REFINE_MESH_H
