// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_SURFACE_FILL_BOUNDARY_H
#define MERIDIAN_SURFACE_FILL_BOUNDARY_H

#include <meridian/surface/Triangle_surface.h>

namespace meridian {

/// \ingroup PkgMeridianOrder
/// a surface with a fan over each boundary loop. Vertices and faces of the surface come first and keep their numbers;
/// then, for each loop, one vertex and one face an edge.
struct Filled_surface
{
  Triangle_surface surface;
  Index vertices = 0, faces = 0; ///< of the surface that was filled
};

/// \ingroup PkgMeridianOrder
/// \returns `root` with its boundary loops filled
/// \par Complexity
/// Linear.
inline Filled_surface fill_boundary(const Triangle_surface& root)
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

#endif // MERIDIAN_SURFACE_FILL_BOUNDARY_H
