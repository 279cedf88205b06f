// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MESH_CUT_TO_DISC_H
#define MERIDIAN_MESH_CUT_TO_DISC_H

#include <meridian/base/Stage_runner.h>
#include <meridian/base/exceptions.h>
#include <meridian/cut/cut_to_disc.h>
#include <meridian/cut/cut_traits.h>
#include <meridian/field/order_surface.h>
#include <meridian/mesh/internal/morse_graph.h>
#include <meridian/mesh/internal/refine_mesh.h>
#include <meridian/mesh/internal/run_options.h>
#include <meridian/mesh/internal/with_maps.h>
#include <meridian/mesh/make_triangle_surface.h>
#include <meridian/result/recount.h>
#include <meridian/surface/open_along.h>

#include <type_traits>
#include <utility>
#include <vector>

namespace meridian {

namespace internal {

// The cut of a mesh that was read as `root`, as the named parameters ask for it.
template <class TriangleMesh, class NamedParameters>
Cut cut_and_recount(const Triangle_surface& root, const TriangleMesh& tm, const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  Cut_options options = choose_parameter(get_parameter(np, internal_np::cut_options), Cut_options());
  if_given(get_parameter(np, internal_np::cut_traits),
           [&](const auto& traits) { options = with_traits(std::move(options), traits); });
  options = with_run(with_maps(std::move(options), tm, np), np);
  Cut cut = meridian::cut_to_disc(root, options);
  Verification recount;
  Stage_runner{options.observer, cut.seconds}(Stage::VERIFY, [&] { recount = verify_cut(root, cut); });
  if (!recount) { throw Internal_error("cut_to_disc: the recount found " + recount.failures.front()); }
  return cut;
}

// The field that the options of a cut choose, ordered once more for itself.
template <class TriangleMesh, class NamedParameters>
Ordered_surface order_again(const Triangle_surface& root, const TriangleMesh& tm, const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  Cut_options options = choose_parameter(get_parameter(np, internal_np::cut_options), Cut_options());
  options = with_run(with_maps(std::move(options), tm, np), np);
  return order_surface(root, {part_of<Field_options>(options, "morse_graph"), false, options.solvers}, run_unwatched);
}

} // namespace internal

/*!
 * \ingroup PkgMeridianFaceGraph
 *
 * cuts a connected triangle mesh into a disc (see `cut_to_disc(const Triangle_surface&, const Cut_options&)`).
 *
 * \declared{meridian/cut_to_disc.h}
 *
 * \tparam TriangleMesh a model of `ReadableTriangleMesh`
 * \tparam DiscMesh a model of `MutableFaceGraph` with an internal point map; it may be another type
 * \param tm the mesh
 * \param disc receives the disc: the vertices of `tm` in their order, then new ones, then copies
 * \param np optional: `cut_options`, `field_map`, `vertex_weight_map`, `vertex_point_map`, `sparse_linear_solver` and
 *   `visitor` as for the other form
 * \returns the cut, recounted
 * \throws Invalid_input_error if `disc` is not empty; Invalid_input_error, Solver_error, Cancelled as that function
 */
template <
  class TriangleMesh, class DiscMesh, class NamedParameters = CGAL::parameters::Default_named_parameters,
  std::enable_if_t<
    !std::is_same_v<std::remove_const_t<DiscMesh>, Cut_options> && !internal::is_named_parameters<DiscMesh>, int> = 0>
Cut cut_to_disc(const TriangleMesh& tm, DiscMesh& disc, const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::check_parameters<CGAL::internal_np::vertex_point_t, internal_np::cut_options_t, internal_np::cut_traits_t,
                             internal_np::field_map_t, internal_np::vertex_weight_map_t,
                             CGAL::internal_np::sparse_linear_solver_t, CGAL::internal_np::visitor_t>(np);
  internal::check_is_empty(disc);
  const Triangle_surface root = internal::read_surface(tm, np);
  Cut cut = internal::cut_and_recount(root, tm, np);
  const Triangle_surface opened = surface_of(cut.surface, cut.opened);
  internal::build(opened.points, opened.triangles, disc);
  return cut;
}

/// \ingroup PkgMeridianFaceGraph
/// a curve of a cut graph, on the mesh.
template <class TriangleMesh> struct Mesh_curve
{
  Curve_kind kind; ///< what it is
  /// along it, in order
  std::vector<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor> halfedges;
  bool is_closed; ///< whether the last leads back to where the first begins
};

/*!
 * \ingroup PkgMeridianFaceGraph
 *
 * refines a connected triangle mesh along a cut graph that makes a disc of it (see
 * `cut_to_disc(const Triangle_surface&, const Cut_options&)`). Vertices, edges and faces that the graph does not cross
 * stay what they are, with their properties; with `Cut_options::on_edges` all do.
 *
 * \declared{meridian/cut_to_disc.h}
 *
 * \tparam TriangleMesh a model of `RefinableTriangleMesh`
 * \param tm the mesh
 * \param np optional:
 *   - `cut_options` (a `Cut_options`; its vertices are numbered in the order of `vertices(tm)`);
 *   - `cut_traits` (a model of `CutTraits`): what the method shall use in place of its own preference, metric of edges
 *   and places of crossings;
 *   - `field_map` (a `ReadablePropertyMap` from vertices to `double`): the field whose contours are cut;
 *     `vertex_weight_map` (the same): meridians keep to low weights;
 *   - `vertex_point_map` (a `ReadWritePropertyMap`; default: `get(CGAL::vertex_point, tm)`). A new point is constructed
 *     from its neighbours in the map's own kernel: with an exact one it lies on the mesh exactly; in that of
 *     `geom_traits` (a kernel) if it is given;
 *   - `sparse_linear_solver` (a model of `SparseSolverTraits`; default: a Cholesky factorization);
 *   - `visitor` (a `std::reference_wrapper` of, or pointer to, a `Progress_observer`): told of the stages, may end the
 *     run;
 *   - `edge_is_constrained_map` (a `WritablePropertyMap` from edges to `bool`) receives whether an edge is one of the
 *     cut graph, for all edges, `vertex_is_constrained_map` whether a vertex lies on it: the two maps of
 *     `CGAL::Seam_mesh`;
 *   - `vertex_field_map` (a `WritablePropertyMap` from vertices to `double`) receives the field, linear in each face;
 *   - `vertex_origin_map` (the same, to `Origin`) receives where on the mesh a vertex lies, `face_origin_map` (from
 *     faces to `Index`) the number of the face that a face was part of;
 *   - `curve_output_iterator` (an output iterator of `Mesh_curve<TriangleMesh>`) receives the curves that the graph is
 *     made of, as halfedges of the refined mesh;
 *   - `morse_graph` (a `std::reference_wrapper` of a `Morse_graph<TriangleMesh>`) receives the quasi Morse-Smale
 *   complex of the field, on the mesh as it was.
 * \returns the cut, recounted; its vertices and faces have other numbers than those of `tm`
 * \throws Invalid_input_error, Solver_error, Cancelled as that function. The mesh is not touched then.
 */
template <
  class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters,
  std::enable_if_t<!std::is_base_of_v<Triangle_surface, TriangleMesh> && internal::is_named_parameters<NamedParameters>,
                   int> = 0>
Cut cut_to_disc(TriangleMesh& tm, const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::check_parameters<CGAL::internal_np::vertex_point_t, CGAL::internal_np::edge_is_constrained_t,
                             CGAL::internal_np::vertex_is_constrained_t, internal_np::cut_options_t,
                             internal_np::cut_traits_t, internal_np::field_map_t, internal_np::vertex_weight_map_t,
                             internal_np::vertex_field_map_t, internal_np::vertex_origin_map_t,
                             internal_np::face_origin_map_t, internal_np::morse_graph_t,
                             internal_np::curve_output_iterator_t, CGAL::internal_np::geom_traits_t,
                             CGAL::internal_np::sparse_linear_solver_t, CGAL::internal_np::visitor_t>(np);
  const Triangle_surface root = internal::read_surface(tm, np);
  Cut cut = internal::cut_and_recount(root, tm, np);
  internal::if_given(CGAL::parameters::get_parameter(np, internal_np::morse_graph), [&](auto graph) {
    internal::fill_morse_graph(internal::order_again(root, tm, np), tm, graph.get());
  });
  const auto refiner = internal::refine_in_place(root, cut.surface, cut.field, tm, np);
  internal::if_given(CGAL::parameters::get_parameter(np, internal_np::curve_output_iterator), [&](auto out) {
    for (const Named_curve& c : cut.curves)
    {
      *out++ = Mesh_curve<TriangleMesh>{
        c.kind, internal::halfedges_along(cut.surface, refiner, tm, c.vertices, c.is_closed), c.is_closed};
    }
  });
  return cut;
}

} // namespace meridian

#endif // MERIDIAN_MESH_CUT_TO_DISC_H
