// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MESH_SHORTEST_BASIS_H
#define MERIDIAN_MESH_SHORTEST_BASIS_H

#include <meridian/base/exceptions.h>
#include <meridian/handles/find_shortest_basis.h>
#include <meridian/mesh/internal/loops.h>
#include <meridian/mesh/internal/refine_mesh.h>
#include <meridian/mesh/internal/run_options.h>
#include <meridian/mesh/make_triangle_surface.h>
#include <meridian/mesh/parameters.h>
#include <meridian/result/recount.h>

namespace meridian {

/*!
 * \ingroup PkgMeridianFaceGraph
 *
 * refines a connected triangle mesh so that short loops that are a basis of its first homology are edges of it (see
 * `find_shortest_basis()`). They may cross.
 *
 * \declared{meridian/generators.h}
 *
 * \tparam TriangleMesh a model of `RefinableTriangleMesh`
 * \tparam OutputIterator an output iterator of `std::vector`s of halfedges
 * \tparam NamedParameters a sequence of named parameters
 * \param tm the mesh
 * \param loops receives the closed loops, twice as many as the genus, the shortest first
 * \param np optional: `basis_options` (a `Basis_options`); `vertex_point_map`, `geom_traits`, `sparse_linear_solver`,
 *   `visitor`, and the maps of `cut_to_disc()` but the field
 * \returns the basis, recounted; its vertices have other numbers than those of `tm`
 * \throws Invalid_input_error, Cancelled as that function. The mesh is not touched then.
 */
template <class TriangleMesh, class OutputIterator, class NamedParameters = CGAL::parameters::Default_named_parameters>
Homology_basis shortest_basis(TriangleMesh& tm, OutputIterator loops,
                              const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::check_refining_parameters<internal_np::basis_options_t, CGAL::internal_np::sparse_linear_solver_t>(np);
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const Triangle_surface root = internal::read_surface(tm, np);
  const auto options = choose_parameter(get_parameter(np, internal_np::basis_options), Basis_options());
  Homology_basis basis = find_shortest_basis(root, internal::with_run(options, np));
  const Generator_verification recount = verify_generators(root, basis);
  if (!recount) { throw Internal_error("shortest_basis: the recount found " + recount.failures.front()); }
  const auto refiner = internal::refine_in_place(root, basis.surface, {}, tm, np);
  for (const Generator_curve& loop : basis.loops)
  {
    *loops++ = internal::halfedges_along(basis.surface, refiner, tm, loop.vertices, true);
  }
  return basis;
}

} // namespace meridian

#endif // MERIDIAN_MESH_SHORTEST_BASIS_H
