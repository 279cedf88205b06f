// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_HANDLES_INTERNAL_PROJECT_FROM_FILLED_H
#define MERIDIAN_HANDLES_INTERNAL_PROJECT_FROM_FILLED_H

#include <meridian/curves/contours.h>
#include <meridian/curves/place_crossings.h>
#include <meridian/field/Ordered_surface.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/fill_boundary.h>

#include <vector>

namespace meridian {

namespace internal {

// Contours of a filled surface as crossings of the surface alone. Where one runs through a fan it is pushed out over
// the vertices that it separates from the fan's middle: around each of them, across all edges inside the surface. Those
// that passed farther from such a vertex come to lie nearer to it.
//
// `arcs`: how many pieces end on the boundary; `loops`: how many do not.
std::vector<std::vector<Piece_crossing>> project_from_filled(const Triangle_surface& root, const Filled_surface& filled,
                                                             const Ordered_surface& m,
                                                             const std::vector<const Contour*>& contours, int& arcs,
                                                             int& loops);

} // namespace internal

} // namespace meridian

#endif // MERIDIAN_HANDLES_INTERNAL_PROJECT_FROM_FILLED_H
