// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MESH_HANDLE_OR_TUNNEL_H
#define MERIDIAN_MESH_HANDLE_OR_TUNNEL_H

#include <meridian/handles/classify_generators.h>
#include <meridian/mesh/internal/loops.h>
#include <meridian/mesh/make_triangle_surface.h>
#include <meridian/mesh/parameters.h>

namespace meridian {

/*!
 * \ingroup PkgMeridianFaceGraph
 *
 * says for each of some loops on which side of the surface it bounds (handle and tunnel loops: \cite dey2007).
 *
 * \declared{meridian/generators.h}
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

} // namespace meridian

#endif // MERIDIAN_MESH_HANDLE_OR_TUNNEL_H
