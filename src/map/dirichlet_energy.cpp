// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/map/internal/dirichlet_energy.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace meridian {

namespace internal {

Rest_triangle make_rest_triangle(const std::array<Index, 3>& corners, double b, double x, double y)
{
  return {corners,
          {Plane_point{-1 / b, (x - b) / (b * y)}, Plane_point{1 / b, -x / (b * y)}, Plane_point{0, 1 / y}},
          b * y / 2};
}

Map_gradient gradient_of(const Rest_triangle& t, const std::vector<Plane_point>& at)
{
  Map_gradient j;
  for (int k = 0; k < 3; ++k)
  {
    const Plane_point &p = at[t.corners[k]], &g = t.gradients[k];
    j.a += p[0] * g[0];
    j.b += p[0] * g[1];
    j.c += p[1] * g[0];
    j.d += p[1] * g[1];
  }
  return j;
}

double symmetric_dirichlet_energy(const Map_gradient& j)
{
  const double determinant = j.determinant(), square = j.a * j.a + j.b * j.b + j.c * j.c + j.d * j.d;
  if (!(determinant > 0)) { return std::numeric_limits<double>::infinity(); }
  return square * (1 + 1 / (determinant * determinant));
}

Energy_derivatives derive_energy(const Rest_triangle& t, const Map_gradient& j)
{
  // The decomposition from the parts of J that keep and that reverse orientation.
  const double e = (j.a + j.d) / 2, f = (j.a - j.d) / 2, g = (j.c + j.b) / 2, h = (j.c - j.b) / 2;
  const double q = std::hypot(e, h), r = std::hypot(f, g);
  const double s0 = q + r, s1 = j.determinant() / s0; // q - r, without cancellation
  const double sum = std::atan2(h, e), difference = std::atan2(g, f);
  const double left = (sum + difference) / 2, right = (difference - sum) / 2; // U and V turn by these
  const double cu = std::cos(left), su = std::sin(left), cv = std::cos(right), sv = std::sin(right);

  // Each mode is U M V^T applied to the gradients: turn these by V^T first.
  Energy_derivatives result;
  const double i0 = 1 / s0, i1 = 1 / s1, p = i0 * i1;
  const double d0 = 2 * (s0 - i0 * i0 * i0), d1 = 2 * (s1 - i1 * i1 * i1);
  const double flip = 2 + 2 * (s0 * s0 + s0 * s1 + s1 * s1) * p * p * p;
  const double twist = std::max(2 - 2 * (s0 * s0 - s0 * s1 + s1 * s1) * p * p * p, 0.);
  result.modes[0].lambda = 2 + 6 * i0 * i0 * i0 * i0;
  result.modes[1].lambda = 2 + 6 * i1 * i1 * i1 * i1;
  result.modes[2].lambda = flip / 2;
  result.modes[3].lambda = twist / 2;
  for (int k = 0; k < 3; ++k)
  {
    const Plane_point& w = t.gradients[k];
    const double x = cv * w[0] + sv * w[1], y = -sv * w[0] + cv * w[1];
    const auto set = [&](int mode, double m0, double m1) {
      result.modes[mode].q[2 * k] = cu * m0 - su * m1;
      result.modes[mode].q[2 * k + 1] = su * m0 + cu * m1;
    };
    set(0, x, 0);
    set(1, 0, y);
    set(2, y, x);
    set(3, -y, x);
    result.gradient[2 * k] = d0 * result.modes[0].q[2 * k] + d1 * result.modes[1].q[2 * k];
    result.gradient[2 * k + 1] = d0 * result.modes[0].q[2 * k + 1] + d1 * result.modes[1].q[2 * k + 1];
  }
  return result;
}

double step_to_collapse(const Rest_triangle& t, const std::vector<Plane_point>& at,
                        const std::vector<Plane_point>& step)
{
  const auto& c = t.corners;
  const Plane_point p = at[c[1]] - at[c[0]], q = at[c[2]] - at[c[0]], u = step[c[1]] - step[c[0]],
                    v = step[c[2]] - step[c[0]];
  const double a = cross(u, v), b = cross(p, v) + cross(u, q), d = cross(p, q); // a s^2 + b s + d
  const double root = b * b - 4 * a * d;
  double first = 1;
  if (root < 0) { return first; }
  const double z = -(b + (b < 0 ? -1 : 1) * std::sqrt(root)) / 2;
  if (z != 0 && d / z > 0) { first = std::min(first, d / z); }
  if (a != 0 && z / a > 0) { first = std::min(first, z / a); }
  return first;
}

} // namespace internal

} // namespace meridian
