// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_UNWRAP_INTERNAL_UNTOUCHED_STARS_H
#define MERIDIAN_UNWRAP_INTERNAL_UNTOUCHED_STARS_H

#include <meridian/base/vectors.h>
#include <meridian/surface/Triangle_surface.h>

#include <vector>

namespace meridian {
namespace internal {

// Throws unless the faces at the untouched vertices are faces of a disc, with the same vertices in the same places.
void check_stars(const Triangle_surface& root, const Triangle_surface& disc, const std::vector<Index>& untouched);

// The weights of a disc, with those of the root at the untouched vertices.
std::vector<double> weights_on_disc(const Triangle_surface& root, const Triangle_surface& disc,
                                    const std::vector<Index>& untouched, const std::vector<double>& on_root,
                                    std::vector<double> on_disc);

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_UNWRAP_INTERNAL_UNTOUCHED_STARS_H
