// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MESH_CRITICAL_POINTS_H
#define MERIDIAN_MESH_CRITICAL_POINTS_H

#include <meridian/field/critical_points.h>
#include <meridian/mesh/internal/convert.h>
#include <meridian/mesh/internal/morse_graph.h>
#include <meridian/mesh/make_triangle_surface.h>
#include <meridian/mesh/parameters.h>

namespace meridian {

/// \ingroup PkgMeridianFaceGraph
/// a critical vertex of a field.
template <class TriangleMesh> struct Critical_vertex
{
  /// the vertex; on a boundary loop, which is one place of the field, one of its vertices
  typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex;
  Critical_kind kind; ///< minimum, saddle or maximum
  int multiplicity;   ///< of a saddle: `m` where `m + 1` valleys meet; 1 for extrema
};

/*!
 * \ingroup PkgMeridianFaceGraph
 *
 * finds the critical vertices of a field: where the walk around a vertex does not pass between lower and higher exactly
 * twice (\cite banchoff1970). Vertices of one value are told apart by their numbers.
 *
 * \declared{meridian/fields.h}
 *
 * \tparam TriangleMesh a model of `ReadableTriangleMesh`
 * \tparam VertexFieldMap a model of `ReadablePropertyMap` from vertices to `double`
 * \tparam OutputIterator an output iterator of `Critical_vertex<TriangleMesh>`
 * \tparam NamedParameters a sequence of named parameters
 * \param tm a connected triangle mesh
 * \param field the field; on a boundary loop its mean counts
 * \param out receives the critical vertices
 * \param np optional: `vertex_point_map` (a `ReadablePropertyMap`; default: `get(CGAL::vertex_point, tm)`)
 * \returns how many there are; minima - saddles + maxima is the Euler characteristic of the mesh with its boundary
 *   loops closed, saddles counted by multiplicity
 * \throws Invalid_input_error if a value is not finite
 * \par Complexity
 * \f$ O(n \log n) \f$
 */
template <class TriangleMesh, class VertexFieldMap, class OutputIterator,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
Critical_counts critical_points(const TriangleMesh& tm, VertexFieldMap field, OutputIterator out,
                                const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::check_parameters<CGAL::internal_np::vertex_point_t>(np);
  const Ordered_surface m = internal::order_by_map(internal::read_surface(tm, np), tm, field);
  const auto own = internal::vertices_of(tm);
  for (const Critical_point& p : m.critical)
  {
    *out++ = Critical_vertex<TriangleMesh>{own[internal::nearest_root_vertex(m, p.vertex)], p.kind, p.multiplicity};
  }
  return count(m.critical);
}

} // namespace meridian

#endif // MERIDIAN_MESH_CRITICAL_POINTS_H
