// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MESH_TIGHTEN_H
#define MERIDIAN_MESH_TIGHTEN_H

#include <meridian/base/Stage_runner.h>
#include <meridian/base/vectors.h>
#include <meridian/curves/tighten_loops.h>
#include <meridian/mesh/internal/loops.h>
#include <meridian/mesh/internal/refine_mesh.h>
#include <meridian/mesh/internal/run_options.h>
#include <meridian/mesh/make_triangle_surface.h>
#include <meridian/mesh/parameters.h>

#include <vector>

namespace meridian {

/*!
 * \ingroup PkgMeridianFaceGraph
 *
 * refines a triangle mesh so that loops of its edges, made as short as they can be in their homotopy classes, are edges
 * of it (see `tighten_loops()`).
 *
 * \declared{meridian/generators.h}
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

#endif // MERIDIAN_MESH_TIGHTEN_H
