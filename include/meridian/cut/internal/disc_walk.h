// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_INTERNAL_DISC_WALK_H
#define MERIDIAN_CUT_INTERNAL_DISC_WALK_H

#include <meridian/base/vectors.h>
#include <meridian/curves/Normal_curves.h>

#include <vector>

namespace meridian {
namespace internal {

// The way around a disc that is a surface cut along a network: the curves' sides and pieces of the surface's boundary,
// with the disc on the left. `curve` is -1 for a piece of boundary; another side follows it.
struct Disc_side
{
  Index curve;
  bool is_forward;
  Index corner; /* the vertex after it */
};

// Writes the sides of all discs that the network cuts the surface into; each begins at `begin`. With one disc every
// curve is there twice.
std::vector<Disc_side> walk_around(const Normal_curves& curves, std::vector<std::size_t>& begin);

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_CUT_INTERNAL_DISC_WALK_H
