// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MAP_INTERNAL_CGAL_MAPS_H
#define MERIDIAN_MAP_INTERNAL_CGAL_MAPS_H

#include <meridian/base/vectors.h>
#include <meridian/map/Parameterization.h>
#include <meridian/surface/Triangle_surface.h>

#include <string>
#include <vector>

namespace meridian {
namespace internal {

// A map by CGAL's Surface_mesh_parameterization. Returns why there is none, or nothing.
std::string map_with_cgal(const Triangle_surface& disc, Map_method method, bool in_square,
                          std::vector<Plane_point>& at);

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_MAP_INTERNAL_CGAL_MAPS_H
