// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MAP_INTERNAL_MAP_BY_LEVELS_H
#define MERIDIAN_MAP_INTERNAL_MAP_BY_LEVELS_H

#include <meridian/base/Progress_observer.h>
#include <meridian/base/vectors.h>
#include <meridian/map/minimize_distortion.h>
#include <meridian/surface/Triangle_surface.h>

#include <vector>

namespace meridian {
namespace internal {

// Lowers the distortion of a one-to-one map by Newton's steps until they gain little. What cannot be solved is left.
// `is_near`: see `Distortion_minimizer`.
void lower_distortion(const Triangle_surface& s, std::vector<Plane_point>& at, const Distortion_options& options,
                      bool is_near, const Progress& progress);

// A one-to-one map of low distortion with a free border: of a disc with few of the vertices first, then with more and
// more of them. What is put back is put into its place without turning a face over, and the border stays simple; then
// the distortion of the level is lowered. Empty if a place is too small for double precision, or if the disc has no
// coarser level.
std::vector<Plane_point> map_by_levels(const Triangle_surface& disc, const Distortion_options& options,
                                       const Progress& progress);

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_MAP_INTERNAL_MAP_BY_LEVELS_H
