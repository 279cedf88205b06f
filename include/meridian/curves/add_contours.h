// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CURVES_ADD_CONTOURS_H
#define MERIDIAN_CURVES_ADD_CONTOURS_H

#include <meridian/curves/Normal_curves.h>
#include <meridian/curves/place_crossings.h>

#include <vector>

namespace meridian {

namespace internal {

// Contours as every second curve of a system (or every `stride`-th), in the order that the levels give them.
void add_contours(const std::vector<std::vector<Piece_crossing>>& all, Normal_curves& curves, std::size_t stride = 2);

} // namespace internal

} // namespace meridian

#endif // MERIDIAN_CURVES_ADD_CONTOURS_H
