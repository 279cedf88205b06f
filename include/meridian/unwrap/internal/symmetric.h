// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_UNWRAP_INTERNAL_SYMMETRIC_H
#define MERIDIAN_UNWRAP_INTERNAL_SYMMETRIC_H

#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/find_mirror.h>
#include <meridian/unwrap/Unwrapping.h>

#include <vector>

namespace meridian {
namespace internal {

// Unwraps a surface that is its own mirror image: one half, along edges, and the other like it. Where one chart is
// asked for, the halves stay together along a part of the plane's line, if the stretch that is asked for allows.
Unwrapping unwrap_symmetric(const Triangle_surface& root, const Unwrap_options& options, const Mirror& mirror);

// Throws Invalid_input_error if choices do not go with mirror images.
void check_symmetric(const Unwrap_options& options);

// Makes the maps of charts mirror images of each other, or, if they are their own images, of themselves. Returns
// whether that could be: seams are those of their images, no more faces are turned over than were, and no border meets
// itself.
bool make_maps_symmetric(const Mirror& mirror, Unwrapping& u);

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_UNWRAP_INTERNAL_SYMMETRIC_H
