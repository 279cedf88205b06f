// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MESH_GEODESIC_DISTANCE_H
#define MERIDIAN_MESH_GEODESIC_DISTANCE_H

#include <meridian/field/geodesic_distance.h>
#include <meridian/mesh/internal/field_values.h>
#include <meridian/mesh/internal/run_options.h>
#include <meridian/mesh/make_triangle_surface.h>
#include <meridian/mesh/parameters.h>
#include <meridian/surface/check_surface.h>

#include <type_traits>

namespace meridian {

/*!
 * \ingroup PkgMeridianFaceGraph
 *
 * writes the distance of each vertex within the surface from the nearest of some vertices (see `geodesic_distance()` on
 * a `Triangle_surface`).
 *
 * \declared{meridian/fields.h}
 *
 * \tparam TriangleMesh a model of `ReadableTriangleMesh`
 * \tparam VertexRange a range of vertex descriptors
 * \tparam VertexFieldMap a model of `WritablePropertyMap` from vertices to `double`
 * \tparam NamedParameters a sequence of named parameters
 * \param tm a connected triangle mesh
 * \param sources the vertices
 * \param field receives the distances, in the unit of the points
 * \param np optional: `sparse_linear_solver`, `vertex_point_map` as for `harmonic_field()`
 * \throws Invalid_input_error if there is no source, Solver_error if a system cannot be solved
 * \par Complexity
 * Two factorizations.
 */
template <class TriangleMesh, class VertexRange, class VertexFieldMap,
          class NamedParameters = CGAL::parameters::Default_named_parameters,
          std::enable_if_t<internal::is_mesh<TriangleMesh>, int> = 0>
void geodesic_distance(const TriangleMesh& tm, const VertexRange& sources, VertexFieldMap field,
                       const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::check_parameters<CGAL::internal_np::sparse_linear_solver_t, CGAL::internal_np::vertex_point_t>(np);
  const Triangle_surface root = internal::read_surface(tm, np);
  check_surface(root);
  internal::write_field(
    tm, geodesic_distance(root, internal::numbers_of(tm, sources), internal::solvers_of(np).symmetric), field);
}

} // namespace meridian

#endif // MERIDIAN_MESH_GEODESIC_DISTANCE_H
