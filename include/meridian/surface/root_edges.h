// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_SURFACE_ROOT_EDGES_H
#define MERIDIAN_SURFACE_ROOT_EDGES_H

#include <meridian/base/vectors.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/Triangle_surface.h>

#include <array>

namespace meridian {

namespace internal {

// Where a halfedge of a refined surface lies on an edge of its root: the halfedge of the root, in the face that holds
// the one given, and the fractions of the two ends, counted from the lower of the edge's vertices.
struct Root_stretch
{
  Index halfedge;
  Index lower;
  std::array<double, 2> at;
};

// False if it lies inside a face of the root.
bool find_stretch(const Triangle_surface& root, const Refined_surface& s, Index h, Root_stretch& found);

} // namespace internal

/// \ingroup PkgMeridianOrder
/// \returns the root vertex nearest to a vertex of a refined surface
/// \param root the root
/// \param s a refinement of it
/// \param v a vertex of `s`
Index root_vertex(const Triangle_surface& root, const Refined_surface& s, Index v);

} // namespace meridian

#endif // MERIDIAN_SURFACE_ROOT_EDGES_H
