// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MESH_INTERNAL_MARKED_SURFACE_H
#define MERIDIAN_MESH_INTERNAL_MARKED_SURFACE_H

#include <meridian/base/vectors.h>
#include <meridian/mesh/internal/convert.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/Triangle_surface.h>

namespace meridian {

namespace internal {

// The surface of a mesh, not refined, whose seams are the edges that a map marks.
template <class TriangleMesh, class EdgeIsConstrainedMap>
Refined_surface marked_surface(const Triangle_surface& root, const TriangleMesh& tm, EdgeIsConstrainedMap is_marked)
{
  Refined_surface marked(root);
  const auto halfedges = halfedges_of(tm);
  for (Index h = 0; h < root.number_of_halfedges(); ++h)
  {
    marked.seam[h] = root.opposite[h] >= 0 && get(is_marked, edge(halfedges[h], tm));
  }
  return marked;
}

} // namespace internal

} // namespace meridian

#endif // MERIDIAN_MESH_INTERNAL_MARKED_SURFACE_H
