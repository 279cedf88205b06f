// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_SURFACE_FIND_MIRROR_H
#define MERIDIAN_SURFACE_FIND_MIRROR_H

#include <meridian/base/vectors.h>
#include <meridian/surface/Triangle_surface.h>

#include <optional>
#include <vector>

namespace meridian {

/// \ingroup PkgMeridianSurface
/// a plane in which a triangulated surface is its own mirror image.
struct Mirror
{
  Point origin;                ///< a point of the plane
  Point normal;                ///< of length 1
  std::vector<Index> vertex;   ///< the image of each vertex
  std::vector<Index> halfedge; ///< the image of each halfedge, which runs the other way along the image of its face
  std::vector<Index> line;     ///< halfedges that are their own images turned around, one an edge: the plane's

  /// \param f a face \returns its image
  Index face(Index f) const { return halfedge[3 * f] / 3; }
};

/*!
 * \ingroup PkgMeridianSurface
 *
 * finds a plane in which a surface is its own mirror image, triangle by triangle.
 *
 * Planes through the mean of the vertices are tried: across the axes, the principal axes, and the lines between
 * vertices that are alike in their distance from the mean and their degree. Which vertex is the image of which is
 * guessed from where they are, to a ten-thousandth of the size; whether that is a symmetry is then decided by integers
 * alone: each vertex is the image of its image, and each triangle's image is a triangle, turned over. Of several planes
 * the one is taken that meets the surface along the shortest line.
 *
 * \param s the surface
 * \returns the plane, or nothing if there is none, or none that meets the surface along edges only, which part it
 * \pre `s` is connected
 * \par Complexity
 * \f$ O(n \log n) \f$
 */
std::optional<Mirror> find_mirror(const Triangle_surface& s);

} // namespace meridian

#endif // MERIDIAN_SURFACE_FIND_MIRROR_H
