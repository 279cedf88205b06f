// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MESH_FIND_GENERATORS_H
#define MERIDIAN_MESH_FIND_GENERATORS_H

#include <meridian/base/exceptions.h>
#include <meridian/handles/find_generators.h>
#include <meridian/mesh/internal/with_maps.h>
#include <meridian/mesh/make_triangle_surface.h>
#include <meridian/result/recount.h>

#include <utility>
#include <vector>

namespace meridian {

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
 *   `vertices(tm)`), `field_map`, `vertex_weight_map` and `vertex_point_map` as for `cut_to_disc()`
 * \returns the generators, recounted
 * \throws Invalid_input_error if `refined` is not empty; Invalid_input_error, Solver_error, Cancelled as that function
 */
template <class TriangleMesh, class RefinedMesh, class VertexOutputIterator,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
Generators find_generators(const TriangleMesh& tm, RefinedMesh& refined, VertexOutputIterator curves,
                           const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::check_parameters<CGAL::internal_np::vertex_point_t, internal_np::generator_options_t, internal_np::field_map_t, internal_np::vertex_weight_map_t>(np);
  internal::check_is_empty(refined);
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const Triangle_surface root = internal::read_surface(tm, np);
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

#endif // MERIDIAN_MESH_FIND_GENERATORS_H
