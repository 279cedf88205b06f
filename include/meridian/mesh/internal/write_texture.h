// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MESH_INTERNAL_WRITE_TEXTURE_H
#define MERIDIAN_MESH_INTERNAL_WRITE_TEXTURE_H

#include <meridian/base/vectors.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace meridian {

namespace internal {

// Writes, for each halfedge of a face, the coordinates of its target in that face. `triangles` are the faces of the
// mesh in its order, with the vertices that `at` places.
template <class TriangleMesh, class HalfedgeUVMap>
void write_texture(const TriangleMesh& tm, const std::vector<std::array<Index, 3>>& triangles,
                   const std::vector<Plane_point>& at, HalfedgeUVMap uv)
{
  std::size_t f = 0;
  for (auto face : faces(tm))
  {
    int k = 0;
    for (auto h : CGAL::halfedges_around_face(halfedge(face, tm), tm))
    {
      const Plane_point& p = at[triangles[f][k++]];
      put(uv, h, typename boost::property_traits<HalfedgeUVMap>::value_type(p[0], p[1]));
    }
    ++f;
  }
}

} // namespace internal

} // namespace meridian

#endif // MERIDIAN_MESH_INTERNAL_WRITE_TEXTURE_H
