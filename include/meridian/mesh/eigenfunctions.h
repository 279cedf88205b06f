// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MESH_EIGENFUNCTIONS_H
#define MERIDIAN_MESH_EIGENFUNCTIONS_H

#include <meridian/field/eigenfunctions.h>
#include <meridian/mesh/internal/field_values.h>
#include <meridian/mesh/internal/run_options.h>
#include <meridian/mesh/make_triangle_surface.h>
#include <meridian/mesh/parameters.h>

#include <cstddef>
#include <iterator>
#include <vector>

namespace meridian {

/*!
 * \ingroup PkgMeridianFaceGraph
 *
 * writes eigenfunctions of the Laplacian, those of the smallest eigenvalues first, without the constant one. The
 * integral of the square of each is 1, and it is the same all along a boundary loop.
 *
 * \declared{meridian/fields.h}
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

} // namespace meridian

#endif // MERIDIAN_MESH_EIGENFUNCTIONS_H
