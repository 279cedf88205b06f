// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FIELD_ORDER_WITH_FREE_BOUNDARY_H
#define MERIDIAN_FIELD_ORDER_WITH_FREE_BOUNDARY_H

#include <meridian/base/Progress_observer.h>
#include <meridian/field/Field.h>
#include <meridian/field/Ordered_surface.h>
#include <meridian/field/Sparse_solver.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/fill_boundary.h>

namespace meridian {

/*!
 * \ingroup PkgMeridianOrder
 *
 * orders a filled surface by a harmonic field whose boundary is free (without flux): level lines may end on the
 * boundary.
 *
 * The field is solved on the surface alone; the middle of each fan takes the mean of its loop, which makes no extremum.
 * So with one minimum and one maximum there are 2g saddles on the filled surface, and its contours, arcs continued
 * through the fans, are closed.
 *
 * \param root the surface
 * \param filled the same, filled
 * \param options the field, and which of its extrema are kept
 * \param solvers the solvers
 * \param run calls its second argument; the first is the stage
 * \returns the ordered surface
 * \throws Invalid_input_error as `check()` does or if minima and maxima coincide, Solver_error if the field cannot be
 *   solved
 * \par Complexity
 * that of `order_surface()`
 */
Ordered_surface order_with_free_boundary(const Triangle_surface& root, const Filled_surface& filled,
                                         const Field_options& options, const Solvers& solvers, const Run_stage& run);

} // namespace meridian

#endif // MERIDIAN_FIELD_ORDER_WITH_FREE_BOUNDARY_H
