// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CURVES_PLACE_NORMAL_CURVES_H
#define MERIDIAN_CURVES_PLACE_NORMAL_CURVES_H

#include <meridian/base/vectors.h>
#include <meridian/curves/Normal_curves.h>
#include <meridian/surface/Surface_curve.h>

#include <vector>

namespace meridian {
namespace internal {

// Two crossings of partners whose chords cross: they stand next to each other on one edge, because a third curve
// between them would have to cross one of the two.
struct Meeting
{
  Index x = -1, y = -1;
};

Meeting find_meeting(const Normal_curves& curves, Index c);

// Gives every crossing its place. Partners meet in one point.
std::vector<Surface_curve> place_normal_curves(const Normal_curves& curves);

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_CURVES_PLACE_NORMAL_CURVES_H
