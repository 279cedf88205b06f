// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MESH_MAKE_TRIANGLE_SURFACE_H
#define MERIDIAN_MESH_MAKE_TRIANGLE_SURFACE_H

#include <meridian/mesh/internal/convert.h>
#include <meridian/mesh/parameters.h>
#include <meridian/surface/Triangle_surface.h>

#include <type_traits>

namespace meridian {

namespace internal {

// The mesh with its points from a named parameter, or its own.
template <class TriangleMesh, class NamedParameters>
Triangle_surface read_surface(const TriangleMesh& tm, const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  return convert(tm, choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                      CGAL::get_const_property_map(CGAL::vertex_point, tm)));
}

} // namespace internal

/*!
 * \ingroup PkgMeridianFaceGraph
 *
 * \returns a mesh as a `Triangle_surface`; vertices and faces are numbered in the order of `vertices(tm)` and
 *          `faces(tm)`
 *
 * \declared{meridian/mesh/make_triangle_surface.h}
 *
 * \tparam TriangleMesh a model of `ReadableTriangleMesh`
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
  internal::check_parameters<CGAL::internal_np::vertex_point_t>(np);
  return internal::read_surface(tm, np);
}

} // namespace meridian

#endif // MERIDIAN_MESH_MAKE_TRIANGLE_SURFACE_H
