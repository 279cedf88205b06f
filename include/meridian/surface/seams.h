// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_SURFACE_SEAMS_H
#define MERIDIAN_SURFACE_SEAMS_H

#include <meridian/base/vectors.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/Triangle_surface.h>

#include <vector>

namespace meridian {

/// \ingroup PkgMeridianCut
/// flags some edges of a refined surface as seam, on both sides.
/// \param s the surface
/// \param edges a halfedge of each, none on the boundary
inline void flag_seam(Refined_surface& s, const std::vector<Index>& edges)
{
  for (Index h : edges) { s.seam[h] = s.seam[s.opposite[h]] = 1; }
}

/// \ingroup PkgMeridianCut
/// \returns the length of some edges together
/// \param s the surface
/// \param edges a halfedge of each
double length_of_edges(const Triangle_surface& s, const std::vector<Index>& edges);

/// \ingroup PkgMeridianSurface
/// \returns the length of the seams, each edge counted once
/// \param s the surface
double seam_length(const Refined_surface& s);

} // namespace meridian

#endif // MERIDIAN_SURFACE_SEAMS_H
