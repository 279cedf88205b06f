// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/map/planar_map.h>

#include <meridian/base/Bounding_box.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/convex_hull_2.h>
#include <CGAL/min_quadrilateral_2.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace meridian {

namespace {

using Point_2 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;

} // namespace

int orientation_of(const Plane_point& a, const Plane_point& b, const Plane_point& c)
{
  return CGAL::orientation(Point_2(a[0], a[1]), Point_2(b[0], b[1]), Point_2(c[0], c[1]));
}

std::vector<Index> find_flipped_faces(const std::vector<std::array<Index, 3>>& triangles,
                                      const std::vector<Plane_point>& at)
{
  std::vector<Index> flipped;
  for (std::size_t f = 0; f < triangles.size(); ++f)
  {
    const auto& t = triangles[f];
    if (orientation_of(at[t[0]], at[t[1]], at[t[2]]) <= 0) { flipped.push_back(static_cast<Index>(f)); }
  }
  return flipped;
}

double area_of(const std::vector<std::array<Index, 3>>& triangles, const std::vector<Plane_point>& at)
{
  double sum = 0;
  for (const auto& t : triangles) { sum += cross(at[t[1]] - at[t[0]], at[t[2]] - at[t[0]]) / 2; }
  return sum;
}

bool is_simple(const std::vector<Index>& loop, const std::vector<Plane_point>& at)
{
  std::vector<Point_2> polygon;
  for (Index v : loop) { polygon.emplace_back(at[v][0], at[v][1]); }
  return CGAL::is_simple_2(polygon.begin(), polygon.end());
}

bool is_roomy(const std::vector<Index>& loop, const std::vector<Plane_point>& at)
{
  constexpr int fine = 36;
  Bounding_box<Plane_point> box(at[loop.front()]);
  for (Index v : loop) { box.add(at[v]); }
  const double size = std::max(box.high[0] - box.low[0], box.high[1] - box.low[1]);
  if (!(size > 0)) { return false; }
  const double step = std::ldexp(1., std::ilogb(size) - fine);
  std::vector<Point_2> polygon;
  for (Index v : loop)
  {
    polygon.emplace_back(std::nearbyint((at[v][0] - box.low[0]) / step),
                         std::nearbyint((at[v][1] - box.low[1]) / step));
  }
  return CGAL::is_simple_2(polygon.begin(), polygon.end());
}

Plane_point longer_side_of_smallest_rectangle(const std::vector<Plane_point>& points)
{
  std::vector<Point_2> all, hull, corners;
  for (const Plane_point& p : points) { all.emplace_back(p[0], p[1]); }
  CGAL::convex_hull_2(all.begin(), all.end(), std::back_inserter(hull));
  if (hull.size() > 2) { CGAL::min_rectangle_2(hull.begin(), hull.end(), std::back_inserter(corners)); }
  else { corners = hull; } // all points lie on a line
  Plane_point longest{0, 0};
  for (std::size_t i = 0; i + 1 < corners.size() && i < 2; ++i)
  {
    const Plane_point side{corners[i + 1].x() - corners[i].x(), corners[i + 1].y() - corners[i].y()};
    if (norm(side) > norm(longest)) { longest = side; }
  }
  return norm(longest) > 0 ? (1 / norm(longest)) * longest : Plane_point{1, 0};
}

std::array<double, 2> sides_of_smallest_rectangle(const std::vector<Plane_point>& points)
{
  const Plane_point along = longer_side_of_smallest_rectangle(points);
  Bounding_box<Plane_point> box({dot(points.front(), along), cross(along, points.front())});
  for (const Plane_point& p : points) { box.add({dot(p, along), cross(along, p)}); }
  return {box.high[0] - box.low[0], box.high[1] - box.low[1]};
}

} // namespace meridian
