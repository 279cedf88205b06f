// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/map/is_one_to_one.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <meridian/map/planar_map.h>

#include <CGAL/Polygon_2_algorithms.h>

namespace meridian {

bool is_simple(const std::vector<Index>& loop, const std::vector<Plane_point>& at)
{
  std::vector<CGAL::Exact_predicates_inexact_constructions_kernel::Point_2> polygon;
  for (Index v : loop) { polygon.emplace_back(at[v][0], at[v][1]); }
  return CGAL::is_simple_2(polygon.begin(), polygon.end());
}

bool is_one_to_one(const Triangle_surface& disc, const std::vector<Plane_point>& at)
{
  std::vector<Index> polygon;
  const auto loops = boundary_loops(disc);
  for (Index h : loops.front()) { polygon.push_back(disc.source(h)); }
  return find_flipped_faces(disc.triangles, at).empty() && is_simple(polygon, at);
}

} // namespace meridian
