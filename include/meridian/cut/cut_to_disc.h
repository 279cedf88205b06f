// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_CUT_TO_DISC_H
#define MERIDIAN_CUT_CUT_TO_DISC_H

#include <meridian/cut/Cut.h>
#include <meridian/cut/Cut_options.h>
#include <meridian/surface/Triangle_surface.h>

namespace meridian {

/*!
 * \ingroup PkgMeridianCut
 *
 * cuts a connected surface into a disc along smooth curves (\cite patane2007, section 3).
 *
 * A harmonic field is ordered, simplified and unfolded; of its saddles' contours as many as there are handles are cut
 * as meridians (or generators, or the flow lines of all saddles); the boundaries that this leaves are joined by a tree
 * of links. Other methods find a cut graph of edges. The graph may then be made shorter. A disc stays as it is.
 *
 * \param root the surface
 * \param options see there
 *
 * \returns the cut, which is topologically right however bad the shape of the faces is
 * \throws Invalid_input_error as `check()` does, if minima and maxima coincide, or if only edges shall be cut and the
 *   mesh is too coarse;
 *   Solver_error if the field cannot be solved, Cancelled if the observer says so, Internal_error if an invariant broke
 * \par Complexity
 * One factorization, \f$ O(n^{1.5}) \f$, and \f$ O(n \log n) \f$ beside it.
 */
Cut cut_to_disc(const Triangle_surface& root, const Cut_options& options = Cut_options());

} // namespace meridian

#endif // MERIDIAN_CUT_CUT_TO_DISC_H
