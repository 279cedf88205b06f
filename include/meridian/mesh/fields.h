// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MESH_FIELDS_H
#define MERIDIAN_MESH_FIELDS_H

#include <meridian/base/Stage_runner.h>
#include <meridian/base/vectors.h>
#include <meridian/field/Field.h>
#include <meridian/field/edge_weights.h>
#include <meridian/field/eigenfunctions.h>
#include <meridian/field/geodesic_distance.h>
#include <meridian/field/order_surface.h>
#include <meridian/mesh/internal/convert.h>
#include <meridian/mesh/internal/run_options.h>
#include <meridian/mesh/make_triangle_surface.h>
#include <meridian/mesh/parameters.h>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace meridian {

namespace internal {

template <class TriangleMesh>
constexpr bool is_mesh = !std::is_base_of_v<Triangle_surface, std::remove_const_t<TriangleMesh>>;

// The numbers of some vertices of a mesh.
template <class TriangleMesh, class VertexRange>
std::vector<Index> numbers_of(const TriangleMesh& tm, const VertexRange& range)
{
  const Vertex_numbers<TriangleMesh> number(tm);
  std::vector<Index> numbers;
  for (auto v : range) { numbers.push_back(number[v]); }
  return numbers;
}

// Writes one value a vertex.
template <class TriangleMesh, class VertexFieldMap>
void write_field(const TriangleMesh& tm, const std::vector<double>& values, VertexFieldMap field)
{
  std::size_t i = 0;
  for (auto v : vertices(tm)) { put(field, v, values[i++]); }
}

template <class NamedParameters> Weights weights_of(const NamedParameters& np, Weights otherwise)
{
  return CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, internal_np::laplacian_weights),
                                            otherwise);
}

} // namespace internal

/*!
 * \ingroup PkgMeridianFaceGraph
 *
 * writes the field that is harmonic between minima and maxima, where it is 0 and 1.
 *
 * \tparam TriangleMesh a model of `ReadableTriangleMesh`
 * \tparam VertexRange a range of vertex descriptors
 * \tparam VertexFieldMap a model of `WritablePropertyMap` from vertices to `double`
 * \tparam NamedParameters a sequence of named parameters
 * \param tm a connected triangle mesh
 * \param minima, maxima where the field is prescribed, on different boundary loops; both empty: two vertices far apart
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

/*!
 * \ingroup PkgMeridianFaceGraph
 *
 * writes eigenfunctions of the Laplacian, those of the smallest eigenvalues first, without the constant one. The
 * integral of the square of each is 1, and it is the same all along a boundary loop.
 *
 * \tparam TriangleMesh a model of `ReadableTriangleMesh`
 * \tparam FieldMapRange a range of models of `WritablePropertyMap` from vertices to `double`
 * \tparam NamedParameters a sequence of named parameters
 * \param tm a connected triangle mesh
 * \param fields the maps; as many eigenfunctions are sought
 * \param np optional: `laplacian_weights` (not `Weights::MEAN_VALUE`; default: `Weights::INTRINSIC_DELAUNAY`),
 *   `sparse_linear_solver`, `vertex_point_map` as for `harmonic_field()`
 * \returns their eigenvalues; with weights other than cotangents they are of a graph, and in no unit of the surface
 * \throws Invalid_input_error if there are not so many, Solver_error if they are not found
 * \par Complexity
 * One factorization, and some tens of back-substitutions for each eigenfunction
 */
template <class TriangleMesh, class FieldMapRange, class NamedParameters = CGAL::parameters::Default_named_parameters>
std::vector<double> eigenfunctions(const TriangleMesh& tm, const FieldMapRange& fields,
                                   const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::check_parameters<internal_np::laplacian_weights_t, CGAL::internal_np::sparse_linear_solver_t,
                             CGAL::internal_np::vertex_point_t>(np);
  const Triangle_surface root = internal::read_surface(tm, np);
  const int k = static_cast<int>(std::distance(std::begin(fields), std::end(fields)));
  const Eigenfunctions found = eigenfunctions_at_vertices(
    root, k, internal::weights_of(np, Weights::INTRINSIC_DELAUNAY), internal::solvers_of(np).symmetric);
  std::size_t i = 0;
  for (auto field : fields) { internal::write_field(tm, found.functions[i++], field); }
  return found.values;
}

/*!
 * \ingroup PkgMeridianFaceGraph
 *
 * writes the distance of each vertex within the surface from the nearest of some vertices (see `geodesic_distance()` on
 * a `Triangle_surface`).
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

#endif // MERIDIAN_MESH_FIELDS_H
