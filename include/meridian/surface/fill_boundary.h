// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_SURFACE_FILL_BOUNDARY_H
#define MERIDIAN_SURFACE_FILL_BOUNDARY_H

#include <meridian/base/vectors.h>
#include <meridian/surface/Triangle_surface.h>

namespace meridian {

/// \ingroup PkgMeridianOrder
/// a surface with a fan over each boundary loop. Vertices and faces of the surface come first and keep their numbers;
/// then, for each loop, one vertex and one face an edge.
struct Filled_surface
{
  Triangle_surface surface; ///< without boundary
  Index vertices = 0;       ///< of the surface that was filled
  Index faces = 0;          ///< of the surface that was filled
};

/// \ingroup PkgMeridianOrder
/// \returns `root` with its boundary loops filled
/// \param root the surface
/// \par Complexity
/// Linear.
Filled_surface fill_boundary(const Triangle_surface& root);

} // namespace meridian

#endif // MERIDIAN_SURFACE_FILL_BOUNDARY_H
