// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MESH_BUILD_REFINED_MESH_H
#define MERIDIAN_MESH_BUILD_REFINED_MESH_H

#include <meridian/cut/Cut.h>
#include <meridian/mesh/internal/convert.h>

namespace meridian {

/*!
 * \ingroup PkgMeridianFaceGraph
 *
 * builds the refined surface of a cut, with the edges of the cut graph flagged.
 *
 * \tparam Mesh a model of `MutableFaceGraph` with an internal point map
 * \tparam EdgeIsConstrainedMap a model of `ReadWritePropertyMap` from edges to `bool`
 * \param cut a cut
 * \param refined receives the surface
 * \param is_cut_map receives `true` for the edges of the cut graph, `false` for all others
 * \throws Invalid_input_error if `refined` is not empty
 */
template <class Mesh, class EdgeIsConstrainedMap>
void build_refined_mesh(const Cut& cut, Mesh& refined, EdgeIsConstrainedMap is_cut_map)
{
  internal::check_is_empty(refined);
  const auto vertex = internal::build(cut.surface.points, cut.surface.triangles, refined);
  for (auto e : edges(refined)) { put(is_cut_map, e, false); }
  for (Index h = 0; h < cut.surface.number_of_halfedges(); ++h)
    if (cut.surface.seam[h])
    {
      const auto found = halfedge(vertex[cut.surface.source(h)], vertex[cut.surface.target(h)], refined);
      put(is_cut_map, edge(found.first, refined), true);
    }
}

} // namespace meridian

#endif // MERIDIAN_MESH_BUILD_REFINED_MESH_H
