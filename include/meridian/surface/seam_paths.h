// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_SURFACE_SEAM_PATHS_H
#define MERIDIAN_SURFACE_SEAM_PATHS_H

#include <meridian/base/vectors.h>
#include <meridian/surface/Refined_surface.h>

#include <vector>

namespace meridian {

/// \ingroup PkgMeridianSurface
/// \returns the seam of a surface as paths of vertices, between vertices where other than two seam edges meet or that
///          lie on the boundary. A circle without such a vertex begins and ends at its lowest one.
/// \param s the surface
/// \par Complexity
/// Linear.
std::vector<std::vector<Index>> seam_paths(const Refined_surface& s);

} // namespace meridian

#endif // MERIDIAN_SURFACE_SEAM_PATHS_H
