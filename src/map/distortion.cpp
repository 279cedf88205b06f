// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/map/distortion.h>

#include <meridian/map/planar_map.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace meridian {

std::vector<Face_distortion> measure_faces(const std::vector<Point>& points,
                                           const std::vector<std::array<Index, 3>>& triangles,
                                           const std::vector<Plane_point>& at)
{
  double area = 0;
  for (const auto& t : triangles) { area += norm(cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]])) / 2; }
  const double plane = area_of(triangles, at), scale = area > 0 && plane > 0 ? plane / area : 1; // of squares
  std::vector<Face_distortion> faces;
  for (const auto& t : triangles)
  {
    const Point e = points[t[1]] - points[t[0]], g = points[t[2]] - points[t[0]];
    const Plane_point p = at[t[1]] - at[t[0]], q = at[t[2]] - at[t[0]];
    const double d = cross(p, q);
    if (!(d > 0))
    {
      const double infinite = std::numeric_limits<double>::infinity();
      faces.push_back({infinite, infinite, infinite, infinite});
      continue;
    }
    // The columns of the Jacobian of the map to the surface, and from them its singular values.
    const Point x = (1 / d) * (q[1] * e - p[1] * g), y = (1 / d) * (p[0] * g - q[0] * e);
    const double a = dot(x, x), b = dot(x, y), c = dot(y, y);
    const double root = std::hypot((a - c) / 2, b), large = (a + c) / 2 + root;
    const double product = norm(cross(e, g)) / d; // of both singular values
    Face_distortion f;
    f.stretch_l2 = std::sqrt(scale * (a + c) / 2);
    f.stretch_linf = std::sqrt(scale * large);
    f.conformal = product > 0 ? std::max(large / product, 1.) : std::numeric_limits<double>::infinity();
    f.areal = scale * product;
    faces.push_back(f);
  }
  return faces;
}

Distortion measure_distortion(const std::vector<Point>& points, const std::vector<std::array<Index, 3>>& triangles,
                              const std::vector<Plane_point>& at, const std::vector<Face_distortion>& faces)
{
  Distortion total{0, 0, 0, 0, 0, 0};
  const double plane = area_of(triangles, at);
  std::vector<double> areas;
  double area = 0;
  for (const auto& t : triangles)
  {
    areas.push_back(norm(cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]])) / 2);
    area += areas.back();
  }
  if (!(area > 0)) { return Distortion(); }
  for (std::size_t f = 0; f < triangles.size(); ++f)
  {
    const auto& t = triangles[f];
    total.stretch_linf = std::max(total.stretch_linf, faces[f].stretch_linf);
    const double share = areas[f] / area, image = cross(at[t[1]] - at[t[0]], at[t[2]] - at[t[0]]) / 2;
    total.area += std::abs(share - image / plane);
    if (!(share > 0)) { continue; }
    total.stretch_l2 += share * faces[f].stretch_l2 * faces[f].stretch_l2;
    total.conformal += share * faces[f].conformal;
    total.areal += share * std::max(faces[f].areal, 1 / faces[f].areal);
    for (int k = 0; k < 3; ++k)
    {
      const Index u = t[k], v = t[(k + 1) % 3], w = t[(k + 2) % 3];
      const Point e = points[v] - points[u], g = points[w] - points[u];
      const Plane_point p = at[v] - at[u], q = at[w] - at[u];
      total.angle +=
        share / 3 * std::abs(std::atan2(norm(cross(e, g)), dot(e, g)) - std::atan2(cross(p, q), dot(p, q)));
    }
  }
  total.stretch_l2 = std::sqrt(total.stretch_l2);
  return total;
}

} // namespace meridian
