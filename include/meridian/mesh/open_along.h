// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MESH_OPEN_ALONG_H
#define MERIDIAN_MESH_OPEN_ALONG_H

#include <meridian/base/vectors.h>
#include <meridian/mesh/internal/convert.h>
#include <meridian/mesh/internal/marked_surface.h>
#include <meridian/mesh/make_triangle_surface.h>
#include <meridian/mesh/parameters.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/open_along.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace meridian {

/*!
 * \ingroup PkgMeridianFaceGraph
 *
 * builds a mesh that is another one, taken apart along some of its edges: a vertex is doubled for each piece that its
 * faces fall into. What `CGAL::Seam_mesh` shows, as a mesh of its own.
 *
 * \declared{meridian/cut_to_disc.h}
 *
 * \tparam TriangleMesh a model of `ReadableTriangleMesh`
 * \tparam EdgeIsConstrainedMap a model of `ReadablePropertyMap` from edges to `bool`
 * \tparam OpenedMesh a model of `MutableFaceGraph` with an internal point map; it may be another type
 * \tparam NamedParameters a sequence of named parameters
 * \param tm the mesh; it need not be connected
 * \param is_cut `true` for the edges that it is opened along; those on the boundary do not count
 * \param opened receives the mesh: the vertices of `tm` in their order, then copies
 * \param np optional:
 *   - `vertex_point_map` (a `ReadablePropertyMap`; default: `get(CGAL::vertex_point, tm)`)
 *   - `vertex_to_vertex_output_iterator` receives a `std::pair` for each vertex of `opened`: the vertex of `tm` that it
 *     is, or is a copy of, and itself; `face_to_face_output_iterator` the same of faces
 * \throws Invalid_input_error if `opened` is not empty
 * \par Complexity
 * Linear.
 */
template <class TriangleMesh, class EdgeIsConstrainedMap, class OpenedMesh,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
void open_along(const TriangleMesh& tm, EdgeIsConstrainedMap is_cut, OpenedMesh& opened,
                const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::check_parameters<CGAL::internal_np::vertex_point_t, CGAL::internal_np::vertex_to_vertex_output_iterator_t,
                             CGAL::internal_np::face_to_face_output_iterator_t>(np);
  using CGAL::parameters::get_parameter;
  internal::check_is_empty(opened);
  const Refined_surface marked = internal::marked_surface(internal::read_surface(tm, np), tm, is_cut);
  const Opened_surface apart = open_along(marked);
  const auto vertex = internal::build(surface_of(marked, apart).points, apart.triangles, opened);
  internal::if_given(get_parameter(np, CGAL::internal_np::vertex_to_vertex_output_iterator), [&](auto out) {
    const auto own = internal::vertices_of(tm);
    for (std::size_t v = 0; v < vertex.size(); ++v)
    {
      *out++ =
        std::make_pair(own[v < own.size() ? v : static_cast<std::size_t>(apart.copy_of[v - own.size()])], vertex[v]);
    }
  });
  internal::if_given(get_parameter(np, CGAL::internal_np::face_to_face_output_iterator), [&](auto out) {
    auto copy = faces(opened).begin();
    for (auto f : faces(tm)) { *out++ = std::make_pair(f, *copy++); }
  });
}

} // namespace meridian

#endif // MERIDIAN_MESH_OPEN_ALONG_H
