// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FIELD_ORDER_SURFACE_H
#define MERIDIAN_FIELD_ORDER_SURFACE_H

#include <meridian/base/Progress_observer.h>
#include <meridian/base/vectors.h>
#include <meridian/field/Field.h>
#include <meridian/field/Ordered_surface.h>
#include <meridian/field/Scalar_field.h>
#include <meridian/field/Sparse_solver.h>
#include <meridian/surface/Closed_model.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/Triangle_surface.h>

#include <vector>

namespace meridian {

/// \ingroup PkgMeridianOrder
/// \returns what is worth telling about the field of `m`
/// \param root the surface that `m.surface` refines
/// \param m the ordered surface
Field_summary summarize_field(const Triangle_surface& root, const Ordered_surface& m);

/// \ingroup PkgMeridianOrder
/// what one may choose about the order of a surface.
struct Order_options : Field_options
{
  bool one_maximum = false; ///< whether only the highest maximum is kept: descending lines leave one piece for each
  Solvers solvers;          ///< the general one serves mean-value weights
};

/// \ingroup PkgMeridianOrder
/// orders a surface by its field and makes all saddles simple.
/// \param root the surface that `m.surface` refines
/// \param m surface, graph and field; the rest is found
/// \param minima, maxima the nodes that may be extrema, sorted; both empty: those of the field
/// \par Complexity
/// that of `simplify_order()` and `unfold_saddles()`
void order_by_field(const Triangle_surface& root, Ordered_surface& m, const std::vector<Index>& minima,
                    const std::vector<Index>& maxima);

namespace internal {

// A field that was given, on the nodes of the closed model. What the surface has beside the root lies on edges of it.
Scalar_field field_of_values(const Triangle_surface& root, const Refined_surface& s, const Closed_model& g,
                             const std::vector<double>& values);

} // namespace internal

/*!
 * \ingroup PkgMeridianOrder
 *
 * solves for a field, or takes the one that is given, orders the surface by it and makes all saddles simple.
 *
 * \param root the surface
 * \param options the field, and which of its extrema are kept
 * \param run calls its second argument; the first is the stage. For clocks and observers.
 *
 * \returns the ordered surface
 * \pre `root` is connected
 * \throws Invalid_input_error as `check()` does or if minima and maxima coincide, Solver_error if the field cannot be
 *   solved
 * \par Complexity
 * One solution for the field (see `solve_harmonic_field()`), and \f$ O(n \log n) \f$ beside it.
 */
Ordered_surface order_surface(const Triangle_surface& root, const Order_options& options, const Run_stage& run);

} // namespace meridian

#endif // MERIDIAN_FIELD_ORDER_SURFACE_H
