// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/surface/visibility.h>

#include <meridian/base/exceptions.h>
#include <meridian/surface/Triangle_tree.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace meridian {

namespace {

// A direction as long as coordinates are large, if it is not about so: what is added to a point must change it.
Point brought_to_size(const Point& direction, const std::vector<Point>& points)
{
  constexpr double far = 1e6;
  double largest = 0;
  for (const Point& p : points)
    for (double x : p) { largest = std::max(largest, std::abs(x)); }
  const double length = norm(direction);
  const bool is_about_so = largest < far * length && length < far * largest;
  return is_about_so || !(largest > 0) ? direction : largest / length * direction;
}

} // namespace

std::vector<double> visibility(const Triangle_surface& s, const Point& direction)
{
  if (!(norm(direction) > 0) || !std::isfinite(norm(direction)))
  {
    throw Invalid_input_error("a direction to look from must be finite and not 0");
  }
  const Triangle_tree tree(s);
  const Point ray = brought_to_size(direction, s.points);
  std::vector<double> seen(s.number_of_vertices(), 0);
  for (Index v = 0; v < s.number_of_vertices(); ++v)
  {
    bool faces_it = false;
    s.for_each_outgoing(v, [&](Index h) {
      const auto& t = s.triangles[s.face(h)];
      faces_it =
        faces_it || dot(cross(s.points[t[1]] - s.points[t[0]], s.points[t[2]] - s.points[t[0]]), direction) > 0;
    });
    if (faces_it) { seen[v] = tree.is_hidden(v, ray) ? 0 : 1; }
  }
  return seen;
}

} // namespace meridian
