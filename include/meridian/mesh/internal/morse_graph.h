// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MESH_INTERNAL_MORSE_GRAPH_H
#define MERIDIAN_MESH_INTERNAL_MORSE_GRAPH_H

#include <meridian/base/Progress_observer.h>
#include <meridian/base/vectors.h>
#include <meridian/curves/morse_complex.h>
#include <meridian/field/Ordered_surface.h>
#include <meridian/field/order_surface.h>
#include <meridian/mesh/Morse_graph.h>
#include <meridian/mesh/internal/convert.h>
#include <meridian/surface/Surface_curve.h>

#include <vector>

namespace meridian {

namespace internal {

// A surface ordered by a field on the vertices of its mesh.
template <class TriangleMesh, class VertexFieldMap>
Ordered_surface order_by_map(const Triangle_surface& root, const TriangleMesh& tm, VertexFieldMap field)
{
  Given_field given;
  for (auto v : vertices(tm)) { given.values.push_back(get(field, v)); }
  Order_options options;
  options.field = std::move(given);
  return order_surface(root, options, run_unwatched);
}

// The vertex of the root that a vertex of an ordered surface is, or lies next to.
inline Index nearest_root_vertex(const Ordered_surface& m, Index v)
{
  if (v < m.surface.root_vertices) { return v; }
  const Origin o = m.surface.origin(v);
  if (o.kind == Origin::EDGE) { return o.index[0]; }
  Index nearest = -1;
  m.surface.for_each_outgoing(v, [&](Index h) {
    const Index w = m.surface.target(h);
    if (w < m.surface.root_vertices && nearest < 0) { nearest = w; }
  });
  return nearest;
}

template <class TriangleMesh>
void fill_morse_graph(const Ordered_surface& m, const TriangleMesh& tm, Morse_graph<TriangleMesh>& graph)
{
  using Mesh_point = typename Morse_edge<TriangleMesh>::Point;
  const auto own = vertices_of(tm);
  const Morse_complex complex = make_morse_complex(m);
  graph.clear();
  for (const Critical_point& p : complex.critical)
  {
    add_vertex(Morse_vertex<TriangleMesh>{own[nearest_root_vertex(m, p.vertex)], p.kind}, graph);
  }
  for (const Complex_edge& e : complex.edges)
  {
    Morse_edge<TriangleMesh> edge;
    edge.length = e.length;
    edge.descends = complex.lines[e.line].descends;
    for (const Curve_point& at : whole_line(complex.lines, e.line))
    {
      const Point p = position(m.surface, at);
      edge.points.push_back(Mesh_point(p[0], p[1], p[2]));
    }
    add_edge(e.from, e.to, edge, graph);
  }
}

} // namespace internal

} // namespace meridian

#endif // MERIDIAN_MESH_INTERNAL_MORSE_GRAPH_H
