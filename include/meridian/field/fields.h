// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FIELD_FIELDS_H
#define MERIDIAN_FIELD_FIELDS_H

#include <meridian/field/edge_weights.h>
#include <meridian/field/eigenfunctions.h>
#include <meridian/field/intrinsic_delaunay.h>

namespace meridian {

namespace internal {

inline Eigenfunctions eigenfunctions_of(const Triangle_surface& s, const Closed_model& g, Weights weights, int k, Make_solver make_solver)
{
  if (weights == Weights::MEAN_VALUE)
    throw Invalid_input_error("eigenfunctions need symmetric weights; mean-value weights are not: take positive, "
                              "cotangent or intrinsic Delaunay weights");
  const std::vector<double> mass = node_areas(s, g);
  if (weights != Weights::INTRINSIC_DELAUNAY)
  {
    return find_eigenfunctions(g, edge_weights(s, weights), mass, k, make_solver);
  }
  const Weighted_graph joined = make_intrinsic_delaunay_graph(s);
  return find_eigenfunctions(joined.graph, joined.weights, mass, k, make_solver);
}

} // namespace internal

/*!
 * \ingroup PkgMeridianOrder
 *
 * \returns one value a vertex: eigenfunction `i` of the Laplacian times the square root of its eigenvalue (Patane 2007,
 *          section 2.1). It is the same all along a boundary loop. It serves as `Field_options::values`.
 * \param s the surface
 * \param i which one, from 1: the constant function is 0. The paper takes the genus + 1.
 * \param weights the discretization; not mean-value
 * \param make_solver makes the solver
 * \pre `s` is connected
 * \throws Invalid_input_error if there is no such eigenfunction or the weights are not symmetric, Solver_error if it is
 *   not found
 * \par Complexity
 * One factorization, and some tens of back-substitutions for each eigenfunction
 */
inline std::vector<double> eigenfunction_field(const Triangle_surface& s, int i, Weights weights = Weights::POSITIVE, Make_solver make_solver = make_symmetric_solver)
{
  const Closed_model g = make_closed_model(s);
  if (i < 1 || i >= g.number_of_nodes)
    throw Invalid_input_error("there is no eigenfunction " + std::to_string(i) + " of a surface of "
                              + std::to_string(g.number_of_nodes) + " nodes; count from 1");
  const auto values = scaled_eigenfunction(internal::eigenfunctions_of(s, g, weights, i, make_solver), i);
  std::vector<double> field;
  for (Index a : g.node) { field.push_back(values[a]); }
  return field;
}

/*!
 * \ingroup PkgMeridianOrder
 *
 * \returns two vertices for the minimum and the maximum of a field: of the extrema of the first eigenfunctions, those
 *          of highest curvature (Patane 2007, section 2.1)
 * \param s the surface
 * \param functions how many eigenfunctions are looked at
 * \param weights the discretization; not mean-value
 * \param make_solver makes the solver
 * \pre `s` is connected
 * \throws as `eigenfunction_field()`
 * \par Complexity
 * that of `eigenfunction_field()`
 */
inline std::pair<Index, Index> find_curved_vertices(const Triangle_surface& s, int functions = 4,
                                             Weights weights = Weights::POSITIVE, Make_solver make_solver = make_symmetric_solver)
{
  const Closed_model g = make_closed_model(s);
  const auto e = internal::eigenfunctions_of(s, g, weights, std::min(functions, static_cast<int>(g.number_of_nodes) - 1), make_solver);
  const auto [a, b] = find_curved_extrema(s, g, e);
  return {g.representative[a], g.representative[b]};
}

} // namespace meridian

#endif // MERIDIAN_FIELD_FIELDS_H
