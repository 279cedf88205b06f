// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MESH_INTERNAL_LOOPS_H
#define MERIDIAN_MESH_INTERNAL_LOOPS_H

#include <meridian/base/exceptions.h>
#include <meridian/base/vectors.h>
#include <meridian/mesh/internal/convert.h>
#include <meridian/mesh/parameters.h>

#include <map>
#include <string>
#include <vector>

namespace meridian {

namespace internal {

// The maps that a refined mesh fills.
template <class... More, class NamedParameters> constexpr void check_refining_parameters(const NamedParameters& np)
{
  check_parameters<CGAL::internal_np::vertex_point_t, CGAL::internal_np::geom_traits_t,
                   CGAL::internal_np::edge_is_constrained_t, CGAL::internal_np::vertex_is_constrained_t,
                   CGAL::internal_np::visitor_t, internal_np::vertex_origin_map_t, internal_np::face_origin_map_t,
                   More...>(np);
}

// The numbers of halfedges of a mesh, loop by loop.
template <class TriangleMesh, class LoopRange>
std::vector<std::vector<Index>> walks_of(const TriangleMesh& tm, const LoopRange& loops)
{
  std::map<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor, Index> number;
  for (auto h : halfedges_of(tm)) { number.emplace(h, static_cast<Index>(number.size())); }
  std::vector<std::vector<Index>> walks;
  for (const auto& loop : loops)
  {
    auto& walk = walks.emplace_back();
    for (auto h : loop)
    {
      const auto found = number.find(h);
      if (found == number.end())
      {
        throw Invalid_input_error("loop " + std::to_string(walks.size() - 1)
                                  + " has a halfedge outside of the mesh, beyond its boundary");
      }
      walk.push_back(found->second);
    }
  }
  return walks;
}

} // namespace internal

} // namespace meridian

#endif // MERIDIAN_MESH_INTERNAL_LOOPS_H
