// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MESH_PARAMETERIZE_H
#define MERIDIAN_MESH_PARAMETERIZE_H

#include <meridian/base/Stage_runner.h>
#include <meridian/base/exceptions.h>
#include <meridian/map/parameterize_disc.h>
#include <meridian/mesh/internal/marked_surface.h>
#include <meridian/mesh/internal/run_options.h>
#include <meridian/mesh/internal/write_texture.h>
#include <meridian/mesh/make_triangle_surface.h>
#include <meridian/mesh/parameters.h>
#include <meridian/surface/check_surface.h>
#include <meridian/surface/measures.h>
#include <meridian/surface/open_along.h>

#include <string>

namespace meridian {

/*!
 * \ingroup PkgMeridianFaceGraph
 *
 * maps a mesh that is a disc, or one where it is opened along some edges, into the unit square (see
 * `parameterize_disc()`).
 *
 * \declared{meridian/unwrap.h}
 *
 * \tparam TriangleMesh a model of `ReadableTriangleMesh`
 * \tparam HalfedgeUVMap a model of `WritablePropertyMap` from halfedges to points of the plane that are constructible
 *         from two numbers
 * \tparam NamedParameters a sequence of named parameters
 * \param tm a connected triangle mesh
 * \param uv receives, for each halfedge of a face, the coordinates of its target in that face
 * \param np optional:
 *   - `edge_is_constrained_map` (a `ReadablePropertyMap` from edges to `bool`; default: none): the seams, as
 *     `cut_to_disc()` writes them
 *   - `map_options` (a `Map_options`)
 *   - `vertex_point_map` (a `ReadablePropertyMap`; default: `get(CGAL::vertex_point, tm)`)
 *   - `sparse_linear_solver` (a model of `SparseSolverTraits`; default: a Cholesky factorization)
 *   - `visitor` (a `std::reference_wrapper` of, or pointer to, a `Progress_observer`)
 * \returns the map and its distortion; its vertices are numbered in the order of `vertices(tm)`, copies behind them
 * \throws Invalid_input_error if the mesh is no disc, Solver_error if no method gives a map, Cancelled
 * \par Complexity
 * that of `parameterize_disc()`
 */
template <class TriangleMesh, class HalfedgeUVMap, class NamedParameters = CGAL::parameters::Default_named_parameters>
Parameterization parameterize(const TriangleMesh& tm, HalfedgeUVMap uv,
                              const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::check_parameters<CGAL::internal_np::vertex_point_t, CGAL::internal_np::edge_is_constrained_t,
                             CGAL::internal_np::sparse_linear_solver_t, CGAL::internal_np::visitor_t,
                             internal_np::map_options_t>(np);
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  Triangle_surface disc = internal::read_surface(tm, np);
  internal::if_given(get_parameter(np, CGAL::internal_np::edge_is_constrained), [&](auto is_cut) {
    const Refined_surface marked = internal::marked_surface(disc, tm, is_cut);
    disc = surface_of(marked, open_along(marked));
  });
  check_is_disc(disc);
  Map_options options = choose_parameter(get_parameter(np, internal_np::map_options), Map_options());
  options.make_solver = internal::solvers_of(np, {options.make_solver, {}}).symmetric;
  Stage_times seconds;
  const Stage_runner run{internal::observer_of(np), seconds};
  Parameterization map;
  run(Stage::PARAMETERIZE,
      [&] { map = parameterize_disc(disc, options, [&](double done) { run.progress(Stage::PARAMETERIZE, done); }); });
  internal::write_texture(tm, disc.triangles, map.at, uv);
  return map;
}

} // namespace meridian

#endif // MERIDIAN_MESH_PARAMETERIZE_H
