// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MAP_INTERNAL_RELAX_LOCALLY_H
#define MERIDIAN_MAP_INTERNAL_RELAX_LOCALLY_H

#include <meridian/base/vectors.h>
#include <meridian/map/internal/distortion_energy.h>

#include <vector>

namespace meridian {
namespace internal {

// Newton's direction for one vertex, the corner `corner(t)` of each of some triangles; false if there is none.
// `for_each(f)` calls `f(triangle, corner)`.
template <class For_each_triangle>
bool find_local_direction(const For_each_triangle& for_each, const std::vector<Plane_point>& at, Plane_point& move)
{
  double gx = 0, gy = 0, xx = 0, xy = 0, yy = 0;
  for_each([&](const Rest_triangle& t, int corner) {
    const Energy_derivatives d = derive_energy(t, gradient_of(t, at));
    gx += t.weight * d.gradient[2 * corner];
    gy += t.weight * d.gradient[2 * corner + 1];
    for (const Hessian_mode& mode : d.modes)
    {
      const double x = mode.q[2 * corner], y = mode.q[2 * corner + 1], w = t.weight * mode.lambda;
      xx += w * x * x;
      xy += w * x * y;
      yy += w * y * y;
    }
  });
  const double determinant = xx * yy - xy * xy;
  move = {(xy * gy - yy * gx) / determinant, (xy * gx - xx * gy) / determinant};
  return determinant > 0;
}

// Moves single vertices, in sweeps, as long as the mean energy of the triangles around one is high and falls: what
// Newton's method for all of them would need many steps for, since a few squeezed triangles make each step short. No
// triangle is turned over, which is decided exactly.
//
// `may_move`: of each vertex. Triangles are those whose energy counts, and others around them.
void relax_locally(const std::vector<Rest_triangle>& triangles, const std::vector<Rest_triangle>& others,
                   const std::vector<char>& may_move, std::vector<Plane_point>& at);

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_MAP_INTERNAL_RELAX_LOCALLY_H
