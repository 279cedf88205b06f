// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/surface/fill_boundary.h>

namespace meridian {

Filled_surface fill_boundary(const Triangle_surface& root)
{
  Filled_surface filled{root, root.number_of_vertices(), root.number_of_faces()};
  Triangle_surface& s = filled.surface;
  for (const auto& loop : boundary_loops(root))
  {
    const Index centre = s.number_of_vertices(), first = s.number_of_faces(), n = static_cast<Index>(loop.size());
    Point sum{0, 0, 0};
    for (Index i = 0; i < n; ++i)
    {
      const Index h = loop[i], f = first + i;
      sum = sum + root.points[root.source(h)];
      s.triangles.push_back({root.target(h), root.source(h), centre});
      s.opposite[h] = 3 * f;
      s.opposite.insert(s.opposite.end(), {h, 3 * (first + (i + n - 1) % n) + 2, 3 * (first + (i + 1) % n) + 1});
    }
    s.points.push_back((1. / n) * sum);
  }
  find_outgoing(s);
  return filled;
}

} // namespace meridian
