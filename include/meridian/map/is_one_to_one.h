// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MAP_IS_ONE_TO_ONE_H
#define MERIDIAN_MAP_IS_ONE_TO_ONE_H

#include <meridian/base/vectors.h>
#include <meridian/surface/Triangle_surface.h>

#include <vector>

namespace meridian {

/// \ingroup PkgMeridianParameterization
/// \param disc the surface
/// \param at the image of each vertex
/// \returns whether this map is one-to-one: no face is turned over or without area, and the border does not meet
///          itself. Decided exactly.
bool is_one_to_one(const Triangle_surface& disc, const std::vector<Plane_point>& at);

} // namespace meridian

#endif // MERIDIAN_MAP_IS_ONE_TO_ONE_H
