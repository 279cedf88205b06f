// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MESH_VERIFY_H
#define MERIDIAN_MESH_VERIFY_H

#include <meridian/base/Verification.h>
#include <meridian/mesh/internal/marked_surface.h>
#include <meridian/mesh/make_triangle_surface.h>
#include <meridian/mesh/parameters.h>
#include <meridian/result/recount.h>
#include <meridian/surface/open_along.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace meridian {

/*!
 * \ingroup PkgMeridianFaceGraph
 *
 * recounts a cut of a mesh from the mesh as it was and as it is: that it is the same surface, divided, and that cutting
 * along the marked edges leaves one disc (see `verify_cut()`, which is given plain arrays made of the two).
 *
 * \declared{meridian/verify.h}
 *
 * \tparam InputMesh, TriangleMesh models of `ReadableTriangleMesh`
 * \tparam EdgeIsConstrainedMap a model of `ReadablePropertyMap` from edges to `bool`
 * \tparam NamedParameters a sequence of named parameters
 * \param input the mesh as it was
 * \param tm the mesh with its cut. Its vertices begin with those of `input`, in their order.
 * \param is_cut the edges of `tm` that are cut
 * \param np optional: `vertex_origin_map` and `face_origin_map` (`ReadablePropertyMap`s to `Origin` and `Index`), as
 *   `cut_to_disc()` writes them; needed if `tm` has more vertices or faces than `input`, and only then.
 * \returns the counts and the failures
 * \throws Invalid_input_error if one is no triangle mesh
 * \par Complexity
 * \f$ O(n \log n) \f$
 */
template <class InputMesh, class TriangleMesh, class EdgeIsConstrainedMap,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
Verification verify(const InputMesh& input, const TriangleMesh& tm, EdgeIsConstrainedMap is_cut,
                    const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::check_parameters<internal_np::vertex_origin_map_t, internal_np::face_origin_map_t>(np);
  using CGAL::parameters::get_parameter;
  const Triangle_surface root = make_triangle_surface(input);
  const Refined_surface s = internal::marked_surface(make_triangle_surface(tm), tm, is_cut);
  const std::size_t n = s.points.size(), own = std::min(root.points.size(), n);
  std::vector<Origin> origins(n);
  for (std::size_t v = 0; v < own; ++v) { origins[v] = Origin::on_vertex(static_cast<Index>(v)); }
  internal::if_given(get_parameter(np, internal_np::vertex_origin_map), [&](auto map) {
    std::size_t v = 0;
    for (auto w : vertices(tm)) { origins[v++] = get(map, w); }
  });
  std::vector<Index> face_of = s.face_of;
  internal::if_given(get_parameter(np, internal_np::face_origin_map), [&](auto map) {
    std::size_t f = 0;
    for (auto g : faces(tm)) { face_of[f++] = get(map, g); }
  });
  return verify_cut(internal::soup_of(root), internal::result_of(s, origins, face_of));
}

} // namespace meridian

#endif // MERIDIAN_MESH_VERIFY_H
