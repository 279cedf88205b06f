// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MESH_INTERNAL_FIELD_VALUES_H
#define MERIDIAN_MESH_INTERNAL_FIELD_VALUES_H

#include <meridian/base/vectors.h>
#include <meridian/field/edge_weights.h>
#include <meridian/mesh/internal/convert.h>
#include <meridian/mesh/parameters.h>
#include <meridian/surface/Triangle_surface.h>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace meridian {

namespace internal {

template <class TriangleMesh>
constexpr bool is_mesh = !std::is_base_of_v<Triangle_surface, std::remove_const_t<TriangleMesh>>;

// The numbers of some vertices of a mesh.
template <class TriangleMesh, class VertexRange>
std::vector<Index> numbers_of(const TriangleMesh& tm, const VertexRange& range)
{
  const Vertex_numbers<TriangleMesh> number(tm);
  std::vector<Index> numbers;
  for (auto v : range) { numbers.push_back(number[v]); }
  return numbers;
}

// Writes one value a vertex.
template <class TriangleMesh, class VertexFieldMap>
void write_field(const TriangleMesh& tm, const std::vector<double>& values, VertexFieldMap field)
{
  std::size_t i = 0;
  for (auto v : vertices(tm)) { put(field, v, values[i++]); }
}

template <class NamedParameters> Weights weights_of(const NamedParameters& np, Weights otherwise)
{
  return CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, internal_np::laplacian_weights),
                                            otherwise);
}

} // namespace internal

} // namespace meridian

#endif // MERIDIAN_MESH_INTERNAL_FIELD_VALUES_H
