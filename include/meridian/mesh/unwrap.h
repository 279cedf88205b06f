// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MESH_UNWRAP_H
#define MERIDIAN_MESH_UNWRAP_H

#include <meridian/base/Verification.h>
#include <meridian/base/exceptions.h>
#include <meridian/base/list_elements.h>
#include <meridian/base/vectors.h>
#include <meridian/map/Parameterization.h>
#include <meridian/mesh/internal/run_options.h>
#include <meridian/mesh/internal/write_texture.h>
#include <meridian/mesh/make_triangle_surface.h>
#include <meridian/proof/verify_cut.h>
#include <meridian/result/recount.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/unwrap/Unwrapping.h>
#include <meridian/unwrap/pack_unwrappings.h>
#include <meridian/unwrap/unwrap_surface.h>

#include <utility>
#include <vector>

namespace meridian {

/*!
 * \ingroup PkgMeridianFaceGraph
 *
 * gives a connected triangle mesh texture coordinates in the unit square, without flipped faces; seams are edges of the
 * mesh (see `unwrap_surface()`).
 *
 * \declared{meridian/unwrap.h}
 *
 * \tparam TriangleMesh a model of `ReadableTriangleMesh`
 * \tparam HalfedgeUVMap a model of `WritablePropertyMap` from halfedges to points of the plane that are constructible
 *         from two numbers
 * \tparam NamedParameters a sequence of named parameters
 * \param tm the mesh
 * \param uv receives, for each halfedge of a face, the coordinates of its target in that face
 * \param np optional: `unwrap_options` (an `Unwrap_options`; `cut.on_edges` is taken as set, and its vertices are
 *   numbered in the order of `vertices(tm)`), `edge_is_constrained_map` (a `ReadablePropertyMap` from edges to `bool`:
 *   seams that are given, in place of `Unwrap_options::seams`), `vertex_point_map`, `sparse_linear_solver`, `visitor`
 * \returns the cut and its map, packed, recounted
 * \throws Invalid_input_error if the mesh is not connected, or too coarse for a cut of edges; Solver_error if no map
 *   without flipped faces is found; Cancelled
 * \par Complexity
 * That of `unwrap_surface()`.
 */
template <class TriangleMesh, class HalfedgeUVMap, class NamedParameters = CGAL::parameters::Default_named_parameters>
Unwrapping unwrap(const TriangleMesh& tm, HalfedgeUVMap uv,
                  const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::check_parameters<CGAL::internal_np::vertex_point_t, CGAL::internal_np::edge_is_constrained_t,
                             CGAL::internal_np::sparse_linear_solver_t, CGAL::internal_np::visitor_t,
                             internal_np::unwrap_options_t>(np);
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const Triangle_surface root = internal::read_surface(tm, np);
  Unwrap_options options = choose_parameter(get_parameter(np, internal_np::unwrap_options), Unwrap_options());
  internal::if_given(get_parameter(np, CGAL::internal_np::edge_is_constrained), [&](auto is_seam) {
    const auto all = internal::halfedges_of(tm);
    options.seams.clear();
    for (std::size_t i = 0; i < all.size(); ++i)
    {
      if (get(is_seam, edge(all[i], tm)) && root.opposite[i] >= 0) { options.seams.push_back(static_cast<Index>(i)); }
    }
  });
  options.cut = internal::with_run(std::move(options.cut), np);
  options.map.make_solver = internal::solvers_of(np, {options.map.make_solver, {}}).symmetric;
  options.cut.on_edges = true;
  options.cut.refine_where_needed = false;
  options.image_size = 0;
  Unwrapping u = unwrap_surface(root, options);
  const Verification recount = u.charts > 1 ? verify_charts(root, u.cut) : verify_cut(root, u.cut);
  if (!recount) { throw Internal_error("unwrap: the recount found " + recount.failures.front()); }
  std::vector<Unwrapping> all{std::move(u)};
  pack_unwrappings(all, {1.});
  const Parameterization& map = all.front().map;
  if (!map.flipped.empty())
  {
    throw Solver_error(internal::list_elements("faces are turned over or have no area in the plane", map.flipped));
  }
  internal::write_texture(tm, all.front().disc.triangles, map.at, uv);
  return std::move(all.front());
}

} // namespace meridian

#endif // MERIDIAN_MESH_UNWRAP_H
