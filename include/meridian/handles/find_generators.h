// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_HANDLES_FIND_GENERATORS_H
#define MERIDIAN_HANDLES_FIND_GENERATORS_H

#include <meridian/base/Stage_runner.h>
#include <meridian/base/vectors.h>
#include <meridian/curves/passings.h>
#include <meridian/field/Ordered_surface.h>
#include <meridian/handles/Generators.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/fill_boundary.h>

#include <utility>
#include <vector>

namespace meridian {

namespace internal {

// Generators on a surface that is ordered. Returns for each pair its two saddles, as vertices of `m.surface`; the
// second may be -1. If `crossings` is given, only the edges that the curves cross are written to it. If
// `filled` is given, `m` orders that surface.
std::vector<std::pair<Index, Index>> find_generators(const Triangle_surface& root, const Ordered_surface& m,
                                                     const Generator_options& options, const Stage_runner& run,
                                                     Generators& g,
                                                     std::vector<std::vector<Edge_place>>* crossings = nullptr,
                                                     const Filled_surface* filled = nullptr);

} // namespace internal

/*!
 * \ingroup PkgMeridianGenerators
 *
 * finds a meridian and a longitude around every handle of a connected surface (\cite patane2007, section 4).
 *
 * Meridians are contours of a harmonic field, chosen as for a cut. A longitude is the shortest way from one side of its
 * meridian to the other that crosses no other curve, and back along it; the shortest are taken first. One always
 * exists: cutting along disjoint meridians and arcs that join their two sides leaves the surface connected. Then all
 * curves are tightened. If flow lines are wanted, they are looked for first.
 *
 * With a free boundary, level lines may be arcs; one that is part of a meridian is closed along the boundary loops it
 * ends on.
 *
 * \param root the surface
 * \param options see there
 *
 * \returns the generators
 * \pre `root` is connected
 * \post there are as many pairs as the genus; each curve is simple and closed; the two of a pair share one vertex and
 *   cross there, the longitude from right to left; curves of different pairs are disjoint
 * \throws Invalid_input_error if minima and maxima coincide, Solver_error if the field cannot be solved, Cancelled if
 *   the observer says so, Internal_error if an invariant broke
 * \par Complexity
 * One factorization, and for each handle a search as far as its longitude is long.
 */
Generators find_generators(const Triangle_surface& root, const Generator_options& options = Generator_options());

} // namespace meridian

#endif // MERIDIAN_HANDLES_FIND_GENERATORS_H
