// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MESH_SOLVE_HARMONIC_FIELD_H
#define MERIDIAN_MESH_SOLVE_HARMONIC_FIELD_H

#include <meridian/base/Progress_observer.h>
#include <meridian/base/exceptions.h>
#include <meridian/field/Field.h>
#include <meridian/field/order_surface.h>
#include <meridian/mesh/make_triangle_surface.h>

namespace meridian {

/*!
 * \ingroup PkgMeridianFaceGraph
 *
 * writes the harmonic field with value 0 on `minima` and 1 on `maxima` (see `solve_harmonic_field()`).
 *
 * \tparam VertexFieldMap a model of `WritablePropertyMap` from vertices to `double`
 * \tparam VertexRange a range of vertex descriptors
 * \param tm a connected triangle mesh
 * \param minima, maxima where the field is prescribed; neither is empty, and they lie on different boundary loops
 * \param field receives the values
 * \param weights the discretization
 * \throws Invalid_input_error if an extremum is on both sides, Solver_error if the system cannot be solved
 * \par Complexity
 * One factorization.
 */
template <class TriangleMesh, class VertexRange, class VertexFieldMap>
void solve_harmonic_field(const TriangleMesh& tm, const VertexRange& minima, const VertexRange& maxima,
                          VertexFieldMap field, Weights weights = Weights::POSITIVE)
{
  const internal::Vertex_numbers<TriangleMesh> number(tm);
  Order_options options;
  options.field = Harmonic_field{weights};
  for (auto v : minima) { options.minima.push_back(number[v]); }
  for (auto v : maxima) { options.maxima.push_back(number[v]); }
  if (options.minima.empty() || options.maxima.empty())
  {
    throw Invalid_input_error("a field needs a minimum and a maximum");
  }
  const Ordered_surface m = order_surface(make_triangle_surface(tm), options, run_unwatched);
  for (auto v : vertices(tm)) { put(field, v, m.field(m.graph.node[number[v]])); }
}

} // namespace meridian

#endif // MERIDIAN_MESH_SOLVE_HARMONIC_FIELD_H
