// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FIELD_SOLVE_HARMONIC_FIELD_H
#define MERIDIAN_FIELD_SOLVE_HARMONIC_FIELD_H

#include <meridian/base/vectors.h>
#include <meridian/field/Scalar_field.h>
#include <meridian/field/Sparse_solver.h>
#include <meridian/surface/Closed_model.h>
#include <meridian/surface/Triangle_surface.h>

#include <vector>

namespace meridian {

/// \ingroup PkgMeridianOrder
/// a value prescribed at a node of the closed model.
struct Dirichlet_value
{
  Index node;   ///< the node
  double value; ///< the value there
};

/*!
 * \ingroup PkgMeridianOrder
 *
 * solves \f$ \Delta f = 0 \f$ with prescribed values (\cite ni2004).
 *
 * A boundary loop takes one value, without flux. Where the solution is flat to rounding and the flat region holds a
 * handle, the field is solved again inside the region, from the values around it brought to scale, and so on inward:
 * a handle at the end of a long tube sees a field as smooth as any other.
 *
 * \param s the surface
 * \param g its closed model
 * \param joined the same nodes with the edges of the system: `g`, or an intrinsic triangulation
 * \param weights those `joined.halfedge` refers to
 * \param prescribed the values; each node at most once
 * \param make_solver makes the solver; for mean-value weights one that is general
 *
 * \returns the field
 * \pre `prescribed` is not empty, the surface is connected, no edge joins a boundary loop to itself
 * \throws Solver_error if the system cannot be factorized or its solution is not finite
 *
 * \par Complexity
 * One assembly and one solution: \f$ O(n) \f$ for a surface mesh with `make_laplace_solver()`, \f$ O(n^{1.5}) \f$ with
 * a direct solver; flat regions add one of their own size each.
 */
Scalar_field solve_harmonic_field(const Triangle_surface& s, const Closed_model& g, const Closed_model& joined,
                                  const std::vector<double>& weights, const std::vector<Dirichlet_value>& prescribed,
                                  Make_solver make_solver = make_laplace_solver);

/// \ingroup PkgMeridianOrder
/// the same with the edges of the surface and weights as made by `edge_weights()`, one a halfedge.
/// \param s, g, weights, prescribed, make_solver as there
/// \returns the field
inline Scalar_field solve_harmonic_field(const Triangle_surface& s, const Closed_model& g,
                                         const std::vector<double>& weights,
                                         const std::vector<Dirichlet_value>& prescribed,
                                         Make_solver make_solver = make_laplace_solver)
{
  return solve_harmonic_field(s, g, g, weights, prescribed, make_solver);
}

} // namespace meridian

#endif // MERIDIAN_FIELD_SOLVE_HARMONIC_FIELD_H
