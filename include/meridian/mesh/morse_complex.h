// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MESH_MORSE_COMPLEX_H
#define MERIDIAN_MESH_MORSE_COMPLEX_H

#include <meridian/mesh/Morse_graph.h>
#include <meridian/mesh/internal/morse_graph.h>
#include <meridian/mesh/make_triangle_surface.h>
#include <meridian/mesh/parameters.h>

namespace meridian {

/*!
 * \ingroup PkgMeridianFaceGraph
 *
 * builds the quasi Morse-Smale complex of a field: the two descending and the two ascending flow lines of every saddle,
 * as a graph on the critical points (\cite patane2007, section 4).
 *
 * \declared{meridian/fields.h}
 *
 * \tparam TriangleMesh a model of `ReadableTriangleMesh`
 * \tparam VertexFieldMap a model of `ReadablePropertyMap` from vertices to `double`
 * \tparam NamedParameters a sequence of named parameters
 * \param tm a connected triangle mesh
 * \param field the field; on a boundary loop its mean counts
 * \param graph receives the complex. A saddle of multiplicity `m` is `m` vertices of it.
 * \param np optional: `vertex_point_map` as for `critical_points()`
 * \throws Invalid_input_error if a value is not finite
 * \par Complexity
 * that of `make_morse_complex()`
 */
template <class TriangleMesh, class VertexFieldMap, class NamedParameters = CGAL::parameters::Default_named_parameters>
void morse_complex(const TriangleMesh& tm, VertexFieldMap field, Morse_graph<TriangleMesh>& graph,
                   const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::check_parameters<CGAL::internal_np::vertex_point_t>(np);
  internal::fill_morse_graph(internal::order_by_map(internal::read_surface(tm, np), tm, field), tm, graph);
}

} // namespace meridian

#endif // MERIDIAN_MESH_MORSE_COMPLEX_H
