// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FIELD_SOLVE_FIELD_H
#define MERIDIAN_FIELD_SOLVE_FIELD_H

#include <meridian/field/Field.h>
#include <meridian/field/Sparse_solver.h>
#include <meridian/surface/Triangle_surface.h>

namespace meridian {

/*!
 * \ingroup PkgMeridianOrder
 *
 * solves for a field that needs no minima and maxima.
 *
 * \param s the surface
 * \param field which field
 * \param solvers the solvers
 * \returns one value a vertex and what the field is called; no values for a harmonic field
 * \pre `s` is connected
 * \throws Invalid_input_error if there is no such eigenfunction, Solver_error if it is not found
 * \par Complexity
 * that of `eigenfunction_field()` or `geodesic_distance()`
 */
Given_field solve_field(const Triangle_surface& s, const Field& field, const Solvers& solvers = Solvers());

} // namespace meridian

#endif // MERIDIAN_FIELD_SOLVE_FIELD_H
