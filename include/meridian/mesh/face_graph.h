// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MESH_FACE_GRAPH_H
#define MERIDIAN_MESH_FACE_GRAPH_H

#include <meridian/base/Verification.h>
#include <meridian/base/exceptions.h>
#include <meridian/base/vectors.h>
#include <meridian/cut/Cut.h>
#include <meridian/cut/Cut_options.h>
#include <meridian/cut/cut_to_disc.h>
#include <meridian/field/Field.h>
#include <meridian/field/Ordered_surface.h>
#include <meridian/field/Scalar_field.h>
#include <meridian/field/edge_weights.h>
#include <meridian/field/order_surface.h>
#include <meridian/field/solve_harmonic_field.h>
#include <meridian/handles/Generators.h>
#include <meridian/handles/find_generators.h>
#include <meridian/handles/preference.h>
#include <meridian/mesh/internal/convert.h>
#include <meridian/mesh/parameters.h>
#include <meridian/proof/verify_cut.h>
#include <meridian/proof/verify_generators.h>
#include <meridian/result/recount.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/open_along.h>

namespace meridian {

/*!
 * \ingroup PkgMeridianFaceGraph
 *
 * \returns a mesh as a `Triangle_surface`; vertices and faces are numbered in the order of `vertices(tm)` and
 *          `faces(tm)`
 *
 * \tparam TriangleMesh a model of `VertexListGraph`, `FaceListGraph` and `HalfedgeListGraph`
 * \tparam NamedParameters a sequence of named parameters
 * \param tm the mesh
 * \param np optional: `vertex_point_map` (default: `get(CGAL::vertex_point, tm)`)
 * \throws Invalid_input_error if a face is not a triangle, a vertex is isolated or a coordinate is not finite
 * \par Complexity
 * Linear.
 */
template <class TriangleMesh, class NamedParameters = CGAL::parameters::Default_named_parameters>
Triangle_surface make_triangle_surface(const TriangleMesh& tm,
                                       const NamedParameters& np = CGAL::parameters::default_values())
{
  static_assert(internal::uses_only<CGAL::internal_np::vertex_point_t>(static_cast<const NamedParameters*>(nullptr)),
                "make_triangle_surface() was given a named parameter it does not use");
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  return internal::convert(tm, choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                                get_const_property_map(CGAL::vertex_point, tm)));
}

/*!
 * \ingroup PkgMeridianFaceGraph
 *
 * writes the harmonic field with value 0 on `minima` and 1 on `maxima` (see `solve_harmonic_field()`).
 *
 * \tparam VertexFieldMap a model of `WritablePropertyMap` from vertices to `double`
 * \tparam VertexRange a range of vertex descriptors
 * \param tm a connected triangle mesh
 * \param minima, maxima where the field is prescribed; neither is empty, and they lie on different boundary loops
 * \param field receives the values
 * \param weights the discretization
 * \throws Invalid_input_error if an extremum is on both sides, Solver_error if the system cannot be solved
 * \par Complexity
 * One factorization.
 */
template <class TriangleMesh, class VertexRange, class VertexFieldMap>
void solve_harmonic_field(const TriangleMesh& tm, const VertexRange& minima, const VertexRange& maxima,
                          VertexFieldMap field, Weights weights = Weights::POSITIVE)
{
  const internal::Vertex_numbers<TriangleMesh> number(tm);
  Field_options options;
  options.weights = weights;
  for (auto v : minima) { options.minima.push_back(number[v]); }
  for (auto v : maxima) { options.maxima.push_back(number[v]); }
  if (options.minima.empty() || options.maxima.empty())
  {
    throw Invalid_input_error("a field needs a minimum and a maximum");
  }
  const Ordered_surface m = order_surface(make_triangle_surface(tm), options, run_unwatched);
  for (auto v : vertices(tm)) { put(field, v, m.field(m.graph.node[number[v]])); }
}

namespace internal {

// Options with what property maps say: a field, and weights that meridians keep away from.
template <class Options, class TriangleMesh, class NamedParameters>
Options with_maps(Options options, const TriangleMesh& tm, const NamedParameters& np)
{
  using CGAL::parameters::get_parameter;
  const auto read = [&](const auto& map, const auto& use) {
    if constexpr (!std::is_same_v<std::decay_t<decltype(map)>, CGAL::internal_np::Param_not_found>)
    {
      std::vector<double> values;
      for (auto v : vertices(tm)) { values.push_back(get(map, v)); }
      use(std::move(values));
    }
  };
  read(get_parameter(np, internal_np::field_map),
       [&](std::vector<double> values) { options.values = std::move(values); });
  read(get_parameter(np, internal_np::vertex_weight_map),
       [&](std::vector<double> values) { options.preference = preference::low_weight(std::move(values)); });
  return options;
}

} // namespace internal

/*!
 * \ingroup PkgMeridianFaceGraph
 *
 * cuts a connected triangle mesh into a disc (see `cut_to_disc(const Triangle_surface&, const Cut_options&)`).
 *
 * \tparam TriangleMesh a model of `VertexListGraph`, `FaceListGraph` and `HalfedgeListGraph`
 * \tparam DiscMesh a model of `MutableFaceGraph` with an internal point map; it may be another type
 * \param tm the mesh
 * \param disc receives the disc: the vertices of `tm` in their order, then new ones, then copies
 * \param np optional: `cut_options` (a `Cut_options`; its vertices are numbered in the order of `vertices(tm)`),
 *   `field_map` (a `ReadablePropertyMap` from vertices to `double`: the field whose contours are cut),
 *   `vertex_weight_map` (the same: meridians keep to low weights)
 * \returns the cut, recounted
 * \pre `disc` is empty, `tm` is connected
 * \throws Invalid_input_error, Solver_error, Cancelled as the function above
 */
template <class TriangleMesh, class DiscMesh, class NamedParameters = CGAL::parameters::Default_named_parameters,
          // those are for the function above
          std::enable_if_t<!std::is_same_v<std::remove_const_t<DiscMesh>, Cut_options>, int> = 0>
Cut cut_to_disc(const TriangleMesh& tm, DiscMesh& disc, const NamedParameters& np = CGAL::parameters::default_values())
{
  static_assert(
    internal::uses_only<internal_np::cut_options_t, internal_np::field_map_t, internal_np::vertex_weight_map_t>(
      static_cast<const NamedParameters*>(nullptr)),
    "cut_to_disc() was given a named parameter it does not use");
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const Triangle_surface root = make_triangle_surface(tm);
  Cut cut = cut_to_disc(
    root, internal::with_maps(choose_parameter(get_parameter(np, internal_np::cut_options), Cut_options()), tm, np));
  const Verification recount = verify_cut(root, cut);
  if (!recount) { throw Internal_error("cut_to_disc: the recount found " + recount.failures.front()); }
  const Triangle_surface opened = surface_of(cut.surface, cut.opened);
  internal::build(opened.points, opened.triangles, disc);
  return cut;
}

/*!
 * \ingroup PkgMeridianFaceGraph
 *
 * builds the refined surface of a cut, with the edges of the cut graph flagged.
 *
 * \tparam Mesh a model of `MutableFaceGraph` with an internal point map
 * \tparam EdgeIsConstrainedMap a model of `ReadWritePropertyMap` from edges to `bool`
 * \param cut a cut
 * \param refined receives the surface
 * \param is_cut_map receives `true` for the edges of the cut graph, `false` for all others
 * \pre `refined` is empty
 */
template <class Mesh, class EdgeIsConstrainedMap>
void build_refined_mesh(const Cut& cut, Mesh& refined, EdgeIsConstrainedMap is_cut_map)
{
  const auto vertex = internal::build(cut.surface.points, cut.surface.triangles, refined);
  for (auto e : edges(refined)) { put(is_cut_map, e, false); }
  for (Index h = 0; h < cut.surface.number_of_halfedges(); ++h)
    if (cut.surface.seam[h])
    {
      const auto found = halfedge(vertex[cut.surface.source(h)], vertex[cut.surface.target(h)], refined);
      put(is_cut_map, edge(found.first, refined), true);
    }
}

/*!
 * \ingroup PkgMeridianFaceGraph
 *
 * finds a meridian and a longitude around every handle of a connected triangle mesh (see
 * `find_generators(const Triangle_surface&, const Generator_options&)`).
 *
 * \tparam TriangleMesh a model of `VertexListGraph`, `FaceListGraph` and `HalfedgeListGraph`
 * \tparam RefinedMesh a model of `MutableFaceGraph` with an internal point map; it may be another type
 * \tparam VertexOutputIterator an output iterator of ranges of vertices
 * \param tm the mesh
 * \param refined receives the refined mesh: the vertices of `tm` in their order, then new ones
 * \param curves receives the vertices of each curve on `refined`, a `std::vector`: meridian, longitude, meridian, ...
 * \param np optional: `generator_options` (a `Generator_options`; its vertices are numbered in the order of
 *   `vertices(tm)`), `field_map` and `vertex_weight_map` as for `cut_to_disc()`
 * \returns the generators, recounted
 * \pre `refined` is empty, `tm` is connected
 * \throws Invalid_input_error, Solver_error, Cancelled as the function above
 */
template <class TriangleMesh, class RefinedMesh, class VertexOutputIterator,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
Generators find_generators(const TriangleMesh& tm, RefinedMesh& refined, VertexOutputIterator curves,
                           const NamedParameters& np = CGAL::parameters::default_values())
{
  static_assert(
    internal::uses_only<internal_np::generator_options_t, internal_np::field_map_t, internal_np::vertex_weight_map_t>(
      static_cast<const NamedParameters*>(nullptr)),
    "find_generators() was given a named parameter it does not use");
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const Triangle_surface root = make_triangle_surface(tm);
  Generators g = find_generators(
    root, internal::with_maps(choose_parameter(get_parameter(np, internal_np::generator_options), Generator_options()),
                              tm, np));
  const Generator_verification recount = verify_generators(root, g);
  if (!recount) { throw Internal_error("find_generators: the recount found " + recount.failures.front()); }
  const auto vertex = internal::build(g.surface.points, g.surface.triangles, refined);
  for (const Generator_pair& pair : g.pairs)
    for (const Generator_curve* c : {&pair.meridian, &pair.longitude})
    {
      std::vector<typename boost::graph_traits<RefinedMesh>::vertex_descriptor> path;
      for (Index v : c->vertices) { path.push_back(vertex[v]); }
      *curves++ = std::move(path);
    }
  return g;
}

} // namespace meridian

#endif // MERIDIAN_MESH_FACE_GRAPH_H
