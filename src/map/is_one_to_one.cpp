// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/map/is_one_to_one.h>

#include <meridian/map/planar_map.h>

namespace meridian {

bool is_one_to_one(const Triangle_surface& disc, const std::vector<Plane_point>& at)
{
  std::vector<Index> polygon;
  const auto loops = boundary_loops(disc);
  for (Index h : loops.front()) { polygon.push_back(disc.source(h)); }
  return find_flipped_faces(disc.triangles, at).empty() && is_simple(polygon, at);
}

} // namespace meridian
