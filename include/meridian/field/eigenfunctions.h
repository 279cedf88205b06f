// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FIELD_EIGENFUNCTIONS_H
#define MERIDIAN_FIELD_EIGENFUNCTIONS_H

#include <meridian/base/vectors.h>
#include <meridian/field/Sparse_solver.h>
#include <meridian/field/edge_weights.h>
#include <meridian/surface/Closed_model.h>
#include <meridian/surface/Triangle_surface.h>

#include <utility>
#include <vector>

namespace meridian {

/// \ingroup PkgMeridianOrder
/// the smoothest functions on a closed model.
struct Eigenfunctions
{
  std::vector<double> values;                 ///< ascending; the first is 0
  std::vector<std::vector<double>> functions; ///< one value a node; the first is constant
};

/*!
 * \ingroup PkgMeridianOrder
 *
 * finds the lowest eigenfunctions of the Laplacian, \f$ L x = \lambda M x \f$ (\cite vallet2008).
 *
 * One factorization of \f$ L + \sigma M \f$ serves all: the implicitly restarted Lanczos method (\cite lehoucq1996) as
 * in Spectra finds the highest eigenvalues of its inverse, on the complement of the constant function, which is known.
 * It starts from one vector and might miss a function where eigenvalues coincide, as those of symmetric surfaces do; so
 * it starts again on the complement of what was found until nothing lower is left. Masses and weights are brought to
 * unit size before, so that units do not matter.
 *
 * \param g the closed model, or another graph with weights on its edges
 * \param weights the weights `g.halfedge` refers to
 * \param mass one a node, as made by `node_areas()`
 * \param k how many functions to find beside the constant one
 * \param make_solver makes the solver
 *
 * \returns `k + 1` eigenvalues and functions: \f$ \sum_i m_i x_i y_i \f$ is 1 for a function with itself and 0 for two
 *          different ones. Of each function the entry of largest magnitude (of all that come within a millionth of it,
 *          the first) is positive. Where eigenvalues coincide, the functions are some basis of their space.
 * \pre the weights are symmetric and their matrix is semidefinite, as of cotangent and positive ones (not every solver
 *   finds out); the masses are positive; the graph is connected
 * \throws Invalid_input_error if `k` is not between 1 and the number of nodes less one
 * \throws Solver_error if the matrix cannot be factorized or the iteration does not converge
 *
 * \par Complexity
 * One factorization, \f$ O(n^{1.5}) \f$ for a surface mesh, and some 5 `k` to 10 `k` back-substitutions, \f$ O(n \log
 * n) \f$ each.
 */
Eigenfunctions find_eigenfunctions(const Closed_model& g, const std::vector<double>& weights,
                                   const std::vector<double>& mass, int k,
                                   Make_solver make_solver = make_symmetric_solver);

/// \ingroup PkgMeridianOrder
/// \param e eigenfunctions \param i which of them
/// \returns \f$ \sqrt{\lambda_i} x_i \f$ on the nodes: functions of a high frequency count for more
std::vector<double> scaled_eigenfunction(const Eigenfunctions& e, int i);

namespace internal {

// The lowest eigenfunctions on the nodes of a closed model of a surface.
Eigenfunctions eigenfunctions_of(const Triangle_surface& s, const Closed_model& g, Weights weights, int k,
                                 Make_solver make_solver);

} // namespace internal

/*!
 * \ingroup PkgMeridianOrder
 *
 * \returns the lowest eigenvalues of the Laplacian but 0, and their functions, one value a vertex
 * \param s the surface
 * \param k how many
 * \param weights the discretization; not mean-value
 * \param make_solver makes the solver
 * \pre `s` is connected
 * \throws Invalid_input_error if there are not so many or the weights are not symmetric, Solver_error if they are not
 *   found
 * \par Complexity
 * that of `find_eigenfunctions()`
 */
Eigenfunctions eigenfunctions_at_vertices(const Triangle_surface& s, int k, Weights weights = Weights::POSITIVE,
                                          Make_solver make_solver = make_symmetric_solver);

/*!
 * \ingroup PkgMeridianOrder
 *
 * \returns one value a vertex: eigenfunction `i` of the Laplacian times the square root of its eigenvalue
 *          (\cite patane2007, section 2.1). It is the same all along a boundary loop. `Eigenfunction_field` is it as a
 *          choice.
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
std::vector<double> eigenfunction_field(const Triangle_surface& s, int i, Weights weights = Weights::POSITIVE,
                                        Make_solver make_solver = make_symmetric_solver);

} // namespace meridian

#endif // MERIDIAN_FIELD_EIGENFUNCTIONS_H
