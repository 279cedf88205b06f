// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/field/edge_weights.h>

#include <meridian/base/vectors.h>

#include <algorithm>

namespace meridian {

std::vector<double> edge_weights(const Triangle_surface& s, Weights kind)
{
  const Index halfedges = s.number_of_halfedges();
  std::vector<double> length(halfedges), w(halfedges, 0);
  double mean = 0;
  for (Index h = 0; h < halfedges; ++h) { mean += length[h] = s.length(h); }
  mean /= std::max<Index>(halfedges, 1);
  if (!(mean > 0)) { mean = 1; }

  if (kind == Weights::COTANGENT)
  {
    // The matrix of one face is Gram's matrix of its sides over 4 area, semidefinite whatever area stands there.
    for (Index f = 0; f < s.number_of_faces(); ++f)
    {
      const Index h = 3 * f;
      const Point a = s.points[s.target(h)] - s.points[s.source(h)], b = s.points[s.apex(h)] - s.points[s.source(h)];
      const double longest = std::max({length[h], length[h + 1], length[h + 2], 1e-8 * mean});
      const double area = std::max(norm(cross(a, b)) / 2, 1e-8 * longest * longest);
      for (Index k = h; k < h + 3; ++k)
      {
        if (s.opposite[k] < 0) { continue; }
        const Point p = s.points[s.source(k)] - s.points[s.apex(k)], q = s.points[s.target(k)] - s.points[s.apex(k)];
        const double cotangent = dot(p, q) / (4 * area);
        w[k] += cotangent;
        w[s.opposite[k]] += cotangent;
      }
    }
    return w;
  }

  std::vector<double> half_tangent(halfedges); // of half the corner angle at the source
  for (Index h = 0; h < halfedges; ++h)
  {
    const Point a = s.points[s.target(h)] - s.points[s.source(h)], b = s.points[s.apex(h)] - s.points[s.source(h)];
    const double up = norm(cross(a, b)), down = norm(a) * norm(b) + dot(a, b);
    half_tangent[h] = up < 1e4 * down ? std::max(up / down, 1e-4) : 1e4;
  }
  const auto mean_value = [&](Index h) {
    return (half_tangent[h] + half_tangent[s.next(s.opposite[h])]) / std::max(length[h], 1e-6 * mean);
  };
  for (Index h = 0; h < halfedges; ++h)
    if (s.opposite[h] >= 0)
      w[h] = kind == Weights::MEAN_VALUE ? mean_value(h) : (mean_value(h) + mean_value(s.opposite[h])) / 2;
  return w;
}

} // namespace meridian
