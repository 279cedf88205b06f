// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CURVES_TIGHTEN_LOOPS_H
#define MERIDIAN_CURVES_TIGHTEN_LOOPS_H

#include <meridian/base/Progress_observer.h>
#include <meridian/base/vectors.h>
#include <meridian/curves/tighten_curves.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/Triangle_surface.h>

#include <vector>

namespace meridian {

/// \ingroup PkgMeridianGenerators
/// loops that were tightened.
struct Tightened_loops
{
  Refined_surface surface;                  ///< the input, refined; the loops are its seams
  std::vector<std::vector<Index>> vertices; ///< of each loop, on it; in the order given
  double length_before = 0;                 ///< of all together, as they were given
  double length = 0;                        ///< of all together, tightened
};

/*!
 * \ingroup PkgMeridianGenerators
 *
 * shortens loops of edges within their homotopy classes: each is pushed off to its left and then pulled tight (see
 * `tighten_curves()`), so that it runs through faces.
 *
 * \param root the surface
 * \param loops the vertices of each loop, in order, not repeated at the end
 * \param options when to stop
 * \param progress told how much is done
 * \returns the loops, simple and disjoint
 * \pre no vertex is visited twice, by one loop or by two
 * \throws Invalid_input_error if that is not so, if two vertices in a row are not joined by an edge inside the surface,
 *   or if a loop bounds a disc: there is nothing to pull tight then
 * \par Complexity
 * that of `tighten_curves()`, and one pass over the surface for each loop
 */
Tightened_loops tighten_loops(const Triangle_surface& root, const std::vector<std::vector<Index>>& loops,
                              const Tighten_options& options = Tighten_options(), const Progress& progress = {});

} // namespace meridian

#endif // MERIDIAN_CURVES_TIGHTEN_LOOPS_H
