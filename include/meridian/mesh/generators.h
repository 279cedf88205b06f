// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MESH_GENERATORS_H
#define MERIDIAN_MESH_GENERATORS_H

#include <meridian/base/exceptions.h>
#include <meridian/handles/find_generators.h>
#include <meridian/mesh/internal/loops.h>
#include <meridian/mesh/internal/refine_mesh.h>
#include <meridian/mesh/internal/run_options.h>
#include <meridian/mesh/internal/with_maps.h>
#include <meridian/mesh/make_triangle_surface.h>
#include <meridian/mesh/parameters.h>
#include <meridian/result/recount.h>

namespace meridian {

/*!
 * \ingroup PkgMeridianFaceGraph
 *
 * refines a connected triangle mesh so that a meridian and a longitude around every handle are edges of it (see
 * `find_generators(const Triangle_surface&, const Generator_options&)`). What they do not cross stays what it is.
 *
 * \declared{meridian/generators.h}
 *
 * \tparam TriangleMesh a model of `RefinableTriangleMesh`
 * \tparam MeridianOutputIterator, LongitudeOutputIterator output iterators of `std::vector`s of halfedges
 * \tparam NamedParameters a sequence of named parameters
 * \param tm the mesh
 * \param meridians, longitudes receive a closed loop of halfedges for each handle, in the same order; the two of a
 *   handle begin at the vertex that they share
 * \param np optional:
 *   - `generator_options` (a `Generator_options`; its vertices are numbered in the order of `vertices(tm)`)
 *   - `field_map`, `vertex_weight_map` as for `cut_to_disc()`, and all maps that it fills but the field
 *   - `vertex_point_map`, `geom_traits`, `sparse_linear_solver`, `visitor` as for `cut_to_disc()`
 * \returns the generators, recounted; their vertices have other numbers than those of `tm`
 * \throws Invalid_input_error, Solver_error, Cancelled as that function. The mesh is not touched then.
 */
template <class TriangleMesh, class MeridianOutputIterator, class LongitudeOutputIterator,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
Generators generators(TriangleMesh& tm, MeridianOutputIterator meridians, LongitudeOutputIterator longitudes,
                      const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::check_refining_parameters<internal_np::generator_options_t, internal_np::field_map_t,
                                      internal_np::vertex_weight_map_t, internal_np::vertex_field_map_t,
                                      CGAL::internal_np::sparse_linear_solver_t>(np);
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const Triangle_surface root = internal::read_surface(tm, np);
  const auto options = choose_parameter(get_parameter(np, internal_np::generator_options), Generator_options());
  Generators g = find_generators(root, internal::with_run(internal::with_maps(options, tm, np), np));
  const Generator_verification recount = verify_generators(root, g);
  if (!recount) { throw Internal_error("generators: the recount found " + recount.failures.front()); }
  const auto refiner = internal::refine_in_place(root, g.surface, g.field, tm, np);
  for (const Generator_pair& pair : g.pairs)
  {
    *meridians++ = internal::halfedges_along(g.surface, refiner, tm, pair.meridian.vertices, true);
    *longitudes++ = internal::halfedges_along(g.surface, refiner, tm, pair.longitude.vertices, true);
  }
  return g;
}

} // namespace meridian

#endif // MERIDIAN_MESH_GENERATORS_H
