// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CURVES_TIGHTEN_CURVES_H
#define MERIDIAN_CURVES_TIGHTEN_CURVES_H

#include <meridian/base/Progress_observer.h>
#include <meridian/base/vectors.h>
#include <meridian/curves/Normal_curves.h>

namespace meridian {

/// \ingroup PkgMeridianGenerators
/// what `tighten_curves()` may do.
struct Tighten_options
{
  /// a round or pass that shortens by less than this part of the length is the last
  double least_gain = 1e-4;
  int rounds = 20;  ///< through all curves, at most
  int passes = 200; ///< moves of one curve in one round, at most
};

namespace internal {

// Shortens one curve. Returns its length.
double tighten_curve(Normal_curves& curves, Index c, const Tighten_options& options);

} // namespace internal

/*!
 * \ingroup PkgMeridianGenerators
 *
 * shortens curves within their homotopy classes.
 *
 * Each curve in turn is pulled tight in the strip of faces that it runs through (\cite lee1984) and moved over
 * vertices where it bends and the other side is shorter (\cite xin2007), until no pass over all curves gains more than
 * the least gain. A curve is never moved over another, and two partners go on to cross as often as before: that is read
 * from the orders on edges alone. So disjoint curves stay disjoint, and simple ones simple.
 *
 * \param curves the curves; their crossings are replaced and placed
 * \param options see there
 * \param progress told how much is done
 * \returns the sum of their lengths
 * \par Complexity
 * Linear in the crossings of a curve for each of its passes
 */
double tighten_curves(Normal_curves& curves, const Tighten_options& options = Tighten_options(),
                      const Progress& progress = {});

} // namespace meridian

#endif // MERIDIAN_CURVES_TIGHTEN_CURVES_H
