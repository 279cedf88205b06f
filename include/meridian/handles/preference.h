// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_HANDLES_PREFERENCE_H
#define MERIDIAN_HANDLES_PREFERENCE_H

#include <meridian/base/vectors.h>
#include <meridian/curves/contours.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/Surface_curve.h>
#include <meridian/surface/measures.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

namespace meridian {

/// \ingroup PkgMeridianMeridians
/// what a preference may look at when it rates a loop.
struct Loop_candidate
{
  Index saddle;        ///< vertex of the saddle on the root surface, or the root vertex nearest to it
  Point position;      ///< of the saddle
  Curvature curvature; ///< at that vertex; zero on the boundary
  double length;       ///< of the loop
  bool is_longer;      ///< whether the other loop of the saddle is shorter
  /// \returns the mean along the loop of values at the root's vertices. Empty once meridians are chosen: loops move
  ///          then.
  std::function<double(const std::vector<double>&)> average;
};

/// \ingroup PkgMeridianMeridians
/// rates a loop; the loops with the highest rates are cut first. Of two with equal rates the shorter is.
using Preference = std::function<double(const Loop_candidate&)>;

/// \ingroup PkgMeridianMeridians
/// ready-made preferences. Those that rate saddles put the longer loop of every saddle behind the shorter loops of all.
namespace preference {
namespace internal {
// rate >= 0
inline double rate_saddle(double rate, const Loop_candidate& c)
{
  return c.is_longer ? -1 / (1 + std::min(rate, 1e300)) : rate;
}
} // namespace internal
/// saddles of high curvature first, whatever its sign: seams there cost little distortion (the paper's choice)
/// \param c the loop
/// \returns its rate
inline double gaussian_curvature(const Loop_candidate& c)
{
  return internal::rate_saddle(std::abs(c.curvature.gaussian), c);
}
/// saddles of high mean curvature first, whatever its sign
/// \param c the loop
/// \returns its rate
inline double mean_curvature(const Loop_candidate& c) { return internal::rate_saddle(std::abs(c.curvature.mean), c); }
/// short loops first
/// \param c the loop
/// \returns its rate
inline double short_length(const Loop_candidate& c) { return -c.length; }
/// loops first that run where weights are low.
/// \param weight one number a vertex of the root, such as `visibility()` or what marks a region to keep away from
/// \returns the preference
inline Preference low_weight(std::vector<double> weight)
{
  return [weight = std::move(weight)](const Loop_candidate& c) { return -c.average(weight); };
}
/// loops first whose saddles lie far out in a direction.
/// \param d the direction, of any length but 0
/// \returns the preference
inline Preference position(const Point& d)
{
  return [d](const Loop_candidate& c) { return dot(c.position, d); };
}
} // namespace preference

/// \ingroup PkgMeridianMeridians
/// how meridians are chosen among the level lines of saddles.
struct Meridian_options
{
  Preference preference;          ///< which are cut first; empty: `preference::gaussian_curvature()`
  Levels levels = Levels::SADDLE; ///< where they are taken
  /// where they cross edges, which shows only if they are not tightened: see `Ordered_surface::placement`
  std::function<double(double low, double high, double level)> placement = {};
};

} // namespace meridian

#endif // MERIDIAN_HANDLES_PREFERENCE_H
