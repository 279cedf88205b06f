// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MESH_GENERATORS_H
#define MERIDIAN_MESH_GENERATORS_H

#include <meridian/base/Stage_runner.h>
#include <meridian/base/exceptions.h>
#include <meridian/curves/tighten_loops.h>
#include <meridian/handles/classify_generators.h>
#include <meridian/handles/find_generators.h>
#include <meridian/handles/find_shortest_basis.h>
#include <meridian/mesh/internal/refine_mesh.h>
#include <meridian/mesh/internal/run_options.h>
#include <meridian/mesh/internal/with_maps.h>
#include <meridian/mesh/make_triangle_surface.h>
#include <meridian/mesh/parameters.h>
#include <meridian/result/recount.h>

#include <map>
#include <vector>

namespace meridian {

namespace internal {

// The maps that a refined mesh fills.
template <class... More, class NamedParameters> constexpr void check_refining_parameters(const NamedParameters& np)
{
  check_parameters<CGAL::internal_np::vertex_point_t, CGAL::internal_np::geom_traits_t,
                   CGAL::internal_np::edge_is_constrained_t, CGAL::internal_np::vertex_is_constrained_t,
                   CGAL::internal_np::visitor_t, internal_np::vertex_origin_map_t, internal_np::face_origin_map_t,
                   More...>(np);
}

// The numbers of halfedges of a mesh, loop by loop.
template <class TriangleMesh, class LoopRange>
std::vector<std::vector<Index>> walks_of(const TriangleMesh& tm, const LoopRange& loops)
{
  std::map<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor, Index> number;
  for (auto h : halfedges_of(tm)) { number.emplace(h, static_cast<Index>(number.size())); }
  std::vector<std::vector<Index>> walks;
  for (const auto& loop : loops)
  {
    auto& walk = walks.emplace_back();
    for (auto h : loop)
    {
      const auto found = number.find(h);
      if (found == number.end())
      {
        throw Invalid_input_error("loop " + std::to_string(walks.size() - 1)
                                  + " has a halfedge outside of the mesh, beyond its boundary");
      }
      walk.push_back(found->second);
    }
  }
  return walks;
}

} // namespace internal

/*!
 * \ingroup PkgMeridianFaceGraph
 *
 * refines a connected triangle mesh so that a meridian and a longitude around every handle are edges of it (see
 * `find_generators(const Triangle_surface&, const Generator_options&)`). What they do not cross stays what it is.
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

/*!
 * \ingroup PkgMeridianFaceGraph
 *
 * refines a connected triangle mesh so that short loops that are a basis of its first homology are edges of it (see
 * `find_shortest_basis()`). They may cross.
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

/*!
 * \ingroup PkgMeridianFaceGraph
 *
 * says for each of some loops on which side of the surface it bounds (handle and tunnel loops: \cite dey2007).
 *
 * \tparam TriangleMesh a model of `ReadableTriangleMesh`
 * \tparam LoopRange a range of ranges of halfedges
 * \tparam OutputIterator an output iterator of `Loop_class`
 * \tparam NamedParameters a sequence of named parameters
 * \param tm a connected triangle mesh, oriented outwards or inwards
 * \param loops closed walks of halfedges, such as those of `generators()`
 * \param classes receives one class a loop; `Loop_class::UNKNOWN` if the mesh has a boundary, meets itself or has a
 *   face without area
 * \param np optional: `vertex_point_map` (a `ReadablePropertyMap`; default: `get(CGAL::vertex_point, tm)`)
 * \throws Invalid_input_error if a halfedge has no face
 * \par Complexity
 * one search for self-intersections, and for each edge of a loop the faces above and below it
 */
template <class TriangleMesh, class LoopRange, class OutputIterator,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
void handle_or_tunnel(const TriangleMesh& tm, const LoopRange& loops, OutputIterator classes,
                      const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::check_parameters<CGAL::internal_np::vertex_point_t>(np);
  for (Loop_class c : classify_loops(internal::read_surface(tm, np), internal::walks_of(tm, loops))) { *classes++ = c; }
}

/*!
 * \ingroup PkgMeridianFaceGraph
 *
 * refines a triangle mesh so that loops of its edges, made as short as they can be in their homotopy classes, are edges
 * of it (see `tighten_loops()`).
 *
 * \tparam TriangleMesh a model of `RefinableTriangleMesh`
 * \tparam LoopRange a range of ranges of halfedges
 * \tparam OutputIterator an output iterator of `std::vector`s of halfedges
 * \tparam NamedParameters a sequence of named parameters
 * \param tm a connected triangle mesh
 * \param loops closed walks of halfedges that visit no vertex twice and no vertex in common
 * \param tightened receives the loops, in the same order, simple and disjoint
 * \param np optional: `tighten_options` (a `Tighten_options`); `vertex_point_map`, `geom_traits`, `visitor`, and the
 *   maps of `cut_to_disc()` but the field
 * \returns the lengths before and after; its vertices have other numbers than those of `tm`
 * \throws Invalid_input_error, Cancelled as that function. The mesh is not touched then.
 */
template <class TriangleMesh, class LoopRange, class OutputIterator,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
Tightened_loops tighten(TriangleMesh& tm, const LoopRange& loops, OutputIterator tightened,
                        const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::check_refining_parameters<internal_np::tighten_options_t>(np);
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const Triangle_surface root = internal::read_surface(tm, np);
  const auto options = choose_parameter(get_parameter(np, internal_np::tighten_options), Tighten_options());
  std::vector<std::vector<Index>> walks = internal::walks_of(tm, loops);
  for (auto& walk : walks)
    for (Index& h : walk) { h = root.source(h); }
  Stage_times seconds;
  const Stage_runner run{internal::observer_of(np), seconds};
  Tightened_loops result;
  run(Stage::TIGHTEN,
      [&] { result = tighten_loops(root, walks, options, [&](double done) { run.progress(Stage::TIGHTEN, done); }); });
  const auto refiner = internal::refine_in_place(root, result.surface, {}, tm, np);
  for (const auto& loop : result.vertices)
  {
    *tightened++ = internal::halfedges_along(result.surface, refiner, tm, loop, true);
  }
  return result;
}

} // namespace meridian

#endif // MERIDIAN_MESH_GENERATORS_H
