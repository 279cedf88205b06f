// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_HANDLES_FIND_MERIDIANS_H
#define MERIDIAN_HANDLES_FIND_MERIDIANS_H

#include <meridian/curves/contours.h>
#include <meridian/field/Ordered_surface.h>
#include <meridian/handles/preference.h>
#include <meridian/handles/select_meridians.h>
#include <meridian/surface/Triangle_surface.h>

#include <vector>

namespace meridian {

/// \ingroup PkgMeridianMeridians
/// the loops of all saddles, and which of them are meridians.
struct Meridian_search
{
  std::vector<Contour> loops;             ///< of all saddles
  std::vector<Loop_candidate> candidates; ///< one a loop
  std::vector<Meridian_choice> choices;   ///< the most preferred first

  /// \returns the loops that were chosen, the most preferred first
  std::vector<const Contour*> chosen() const;
};

namespace internal {

// The mean of values at the root's vertices along a contour: linear along the edges of the root, by length.
double average_along(const Triangle_surface& root, const Ordered_surface& m, const Contour& loop,
                     const std::vector<double>& values);

} // namespace internal

/// \ingroup PkgMeridianMeridians
/// rates the loops of `search` and chooses as many meridians as the genus; moves those to the tightest level if that is
/// wanted. A preference may weigh the vertices of `root`, or of it without the middles of `filled_holes`, its last.
/// \param root the surface
/// \param m the same, ordered
/// \param genus how many meridians there are
/// \param preference rates loops; empty: `preference::gaussian_curvature()`
/// \param search its loops are read; the rest is filled
/// \param levels where loops are taken
/// \param filled_holes how many vertices of `root` fill a hole
/// \throws Internal_error if there are not as many, Invalid_input_error if a preference has not one weight a vertex
/// \par Complexity
/// that of `select_meridians()`
void find_meridians(const Triangle_surface& root, const Ordered_surface& m, int genus, const Preference& preference,
                    Meridian_search& search, Levels levels = Levels::SADDLE, Index filled_holes = 0);

} // namespace meridian

#endif // MERIDIAN_HANDLES_FIND_MERIDIANS_H
