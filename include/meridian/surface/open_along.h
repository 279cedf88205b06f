// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_SURFACE_OPEN_ALONG_H
#define MERIDIAN_SURFACE_OPEN_ALONG_H

#include <meridian/base/vectors.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/Triangle_surface.h>

#include <array>
#include <vector>

namespace meridian {

/// \ingroup PkgMeridianSurface
/// a surface taken apart along its seams.
struct Opened_surface
{
  std::vector<std::array<Index, 3>> triangles; ///< the faces of the refined surface, in its order
  /// for each vertex past those of the refined surface, the one it doubles
  std::vector<Index> copy_of;
  std::vector<std::array<Index, 2>> seams; ///< pairs of halfedges that were one edge, the lower first
};

/*!
 * \ingroup PkgMeridianSurface
 *
 * doubles the vertices of `s` so that the faces on both sides of every seam come apart.
 *
 * The sector of a vertex that holds its first face keeps the vertex; the others get copies, numbered by vertex and then
 * counterclockwise.
 *
 * \param s the surface
 * \returns the opened surface
 * \par Complexity
 * Linear.
 */
Opened_surface open_along(const Refined_surface& s);

/// \ingroup PkgMeridianSurface
/// \returns an opened surface as a surface of its own, with the faces and halfedges of the refined one
/// \param s the refined surface
/// \param opened what `open_along()` made of it
Triangle_surface surface_of(const Refined_surface& s, const Opened_surface& opened);

} // namespace meridian

#endif // MERIDIAN_SURFACE_OPEN_ALONG_H
