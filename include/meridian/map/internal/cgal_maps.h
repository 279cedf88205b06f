// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MAP_INTERNAL_CGAL_MAPS_H
#define MERIDIAN_MAP_INTERNAL_CGAL_MAPS_H

#include <meridian/base/vectors.h>
#include <meridian/map/Parameterization.h>
#include <meridian/surface/Triangle_surface.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Barycentric_mapping_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Circular_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_authalic_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_conformal_map_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Square_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <string>
#include <vector>

namespace meridian {
namespace internal {

// The messages of CGAL 5.5 belong to other codes from the fourth on.
std::string explain_error(CGAL::Surface_mesh_parameterization::Error_code code);

// A map by CGAL's Surface_mesh_parameterization. Returns why there is none, or nothing.
std::string map_with_cgal(const Triangle_surface& disc, Map_method method, bool in_square,
                          std::vector<Plane_point>& at);

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_MAP_INTERNAL_CGAL_MAPS_H
