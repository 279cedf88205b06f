// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MESH_HARMONIC_FIELD_H
#define MERIDIAN_MESH_HARMONIC_FIELD_H

#include <meridian/base/Stage_runner.h>
#include <meridian/field/order_surface.h>
#include <meridian/mesh/internal/field_values.h>
#include <meridian/mesh/internal/run_options.h>
#include <meridian/mesh/make_triangle_surface.h>
#include <meridian/mesh/parameters.h>

namespace meridian {

/*!
 * \ingroup PkgMeridianFaceGraph
 *
 * writes the field that is harmonic between minima and maxima, where it is 0 and 1. Along a boundary loop it is
 * constant, without flux: the loop is one place of the field.
 *
 * \declared{meridian/fields.h}
 *
 * \tparam TriangleMesh a model of `ReadableTriangleMesh`
 * \tparam VertexRange a range of vertex descriptors
 * \tparam VertexFieldMap a model of `WritablePropertyMap` from vertices to `double`
 * \tparam NamedParameters a sequence of named parameters
 * \param tm a connected triangle mesh
 * \param minima, maxima where the field is prescribed; no vertex, and no boundary loop, has both. Both empty: two
 *   vertices far apart
 * \param field receives the values
 * \param np optional:
 *   - `laplacian_weights` (a `Weights`; default: `Weights::POSITIVE`, with which no other vertex is an extremum)
 *   - `sparse_linear_solver` (a model of `SparseSolverTraits`; default: a Cholesky factorization)
 *   - `vertex_point_map` (a `ReadablePropertyMap`; default: `get(CGAL::vertex_point, tm)`)
 *   - `visitor` (a `std::reference_wrapper` of, or pointer to, a `Progress_observer`)
 * \throws Invalid_input_error if minima and maxima do not go together, Solver_error if the system cannot be solved,
 *   Cancelled if the visitor says so
 * \par Complexity
 * One factorization.
 */
template <class TriangleMesh, class VertexRange, class VertexFieldMap,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
void harmonic_field(const TriangleMesh& tm, const VertexRange& minima, const VertexRange& maxima, VertexFieldMap field,
                    const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::check_parameters<internal_np::laplacian_weights_t, CGAL::internal_np::sparse_linear_solver_t,
                             CGAL::internal_np::vertex_point_t, CGAL::internal_np::visitor_t>(np);
  const Triangle_surface root = internal::read_surface(tm, np);
  Order_options options;
  options.field = Harmonic_field{internal::weights_of(np, Weights::POSITIVE)};
  options.minima = internal::numbers_of(tm, minima);
  options.maxima = internal::numbers_of(tm, maxima);
  options.solvers = internal::solvers_of(np);
  Stage_times seconds;
  const Ordered_surface m = order_surface(root, options, Stage_runner{internal::observer_of(np), seconds});
  internal::write_field(tm, summarize_field(root, m).field, field);
}

} // namespace meridian

#endif // MERIDIAN_MESH_HARMONIC_FIELD_H
