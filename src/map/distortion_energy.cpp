// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/map/internal/distortion_energy.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace meridian {

namespace internal {

namespace {

constexpr double weight_of_areas = 0.02; // in the conformal energy

} // namespace

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

double conformal_energy(const Map_gradient& j)
{
  const double determinant = j.determinant(), square = j.a * j.a + j.b * j.b + j.c * j.c + j.d * j.d;
  if (!(determinant > 0)) { return std::numeric_limits<double>::infinity(); }
  return square / determinant + weight_of_areas * (determinant + 1 / determinant);
}

namespace {

// The derivatives of an energy for the singular values, and the eigenvalues that follow from them for the two other
// directions in which a Jacobian can change: a flip, and a twist.
struct Derivatives_for_values
{
  std::array<double, 2> first;
  double second00, second01, second11;
  double flip, twist;
};

Derivatives_for_values derive_symmetric_dirichlet(double s0, double s1)
{
  const double i0 = 1 / s0, i1 = 1 / s1, p = i0 * i1;
  return {{2 * (s0 - i0 * i0 * i0), 2 * (s1 - i1 * i1 * i1)},
          2 + 6 * i0 * i0 * i0 * i0,
          0,
          2 + 6 * i1 * i1 * i1 * i1,
          2 + 2 * (s0 * s0 + s0 * s1 + s1 * s1) * p * p * p,
          2 - 2 * (s0 * s0 - s0 * s1 + s1 * s1) * p * p * p};
}

Derivatives_for_values derive_conformal(double s0, double s1)
{
  const double i0 = 1 / s0, i1 = 1 / s1, p = i0 * i1, square = (s0 * s0 + s1 * s1) * p * p, w = weight_of_areas;
  return {{i1 - s1 * i0 * i0 + w * (s1 - i0 * p), i0 - s0 * i1 * i1 + w * (s0 - i1 * p)},
          2 * i0 * i0 * (s1 * i0 + w * p),
          w * (1 + p * p) - i0 * i0 - i1 * i1,
          2 * i1 * i1 * (s0 * i1 + w * p),
          2 * p + square + w * (p * p - 1),
          2 * p - square + w * (1 - p * p)};
}

// The eigenvalues of a symmetric matrix of two rows, the larger first, and the eigenvector of that.
struct Eigen_pair
{
  double larger, smaller;
  Plane_point vector;
};

Eigen_pair diagonalize(double a, double b, double d)
{
  if (b == 0) { return {a, d, {1, 0}}; } // in whichever order: none is asked for
  const double middle = (a + d) / 2, half = (a - d) / 2, radius = std::hypot(half, b);
  const double turn = std::atan2(b, half) / 2;
  return {middle + radius, middle - radius, {std::cos(turn), std::sin(turn)}};
}

} // namespace

Energy_derivatives derive_energy(const Rest_triangle& t, const Map_gradient& j, Distortion_energy energy)
{
  // The decomposition from the parts of J that keep and that reverse orientation.
  const double e = (j.a + j.d) / 2, f = (j.a - j.d) / 2, g = (j.c + j.b) / 2, h = (j.c - j.b) / 2;
  const double q = std::hypot(e, h), r = std::hypot(f, g);
  const double s0 = q + r, s1 = j.determinant() / s0; // q - r, without cancellation
  const double sum = std::atan2(h, e), difference = std::atan2(g, f);
  const double left = (sum + difference) / 2, right = (difference - sum) / 2; // U and V turn by these
  const double cu = std::cos(left), su = std::sin(left), cv = std::cos(right), sv = std::sin(right);

  // Each mode is U M V^T applied to the gradients: turn these by V^T first.
  const Derivatives_for_values d =
    energy == Distortion_energy::CONFORMAL ? derive_conformal(s0, s1) : derive_symmetric_dirichlet(s0, s1);
  const Eigen_pair along = diagonalize(d.second00, d.second01, d.second11);
  const double c = along.vector[0], s = along.vector[1];
  const double slope0 = c * d.first[0] + s * d.first[1], slope1 = c * d.first[1] - s * d.first[0];
  Energy_derivatives result;
  result.modes[0].lambda = std::max(along.larger, 0.);
  result.modes[1].lambda = std::max(along.smaller, 0.);
  result.modes[2].lambda = std::max(d.flip, 0.) / 2;
  result.modes[3].lambda = std::max(d.twist, 0.) / 2;
  for (int k = 0; k < 3; ++k)
  {
    const Plane_point& w = t.gradients[k];
    const double x = cv * w[0] + sv * w[1], y = -sv * w[0] + cv * w[1];
    const auto set = [&](int mode, double m0, double m1) {
      result.modes[mode].q[2 * k] = cu * m0 - su * m1;
      result.modes[mode].q[2 * k + 1] = su * m0 + cu * m1;
    };
    set(0, c * x, s * y);
    set(1, -s * x, c * y);
    set(2, y, x);
    set(3, -y, x);
    for (int i = 2 * k; i < 2 * k + 2; ++i)
    {
      result.gradient[i] = slope0 * result.modes[0].q[i] + slope1 * result.modes[1].q[i];
    }
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
