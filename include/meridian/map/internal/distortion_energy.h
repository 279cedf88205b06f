// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MAP_INTERNAL_DISTORTION_ENERGY_H
#define MERIDIAN_MAP_INTERNAL_DISTORTION_ENERGY_H

#include <meridian/base/vectors.h>
#include <meridian/map/Distortion_energy.h>

#include <array>
#include <vector>

namespace meridian {
namespace internal {

// A triangle of the plane to which the energy of a map is relative.
struct Rest_triangle
{
  std::array<Index, 3> corners;
  std::array<Plane_point, 3> gradients; // of the functions that are 1 at one corner and 0 at the others
  double weight;                        // its area, as a rule
};

// The triangle with the corners (0, 0), (b, 0) and (x, y).
Rest_triangle make_rest_triangle(const std::array<Index, 3>& corners, double b, double x, double y);

// The gradient of a map on a triangle, and its signed singular value decomposition: U diag(s) V^T, s[0] >= |s[1]|.
struct Map_gradient
{
  double a = 0, b = 0, c = 0, d = 0; // (a b; c d)
  double determinant() const { return a * d - b * c; }
};

Map_gradient gradient_of(const Rest_triangle& t, const std::vector<Plane_point>& at);

// |J|^2 + |J^-1|^2 (Smith, Schaefer 2015): 4 for a rotation, infinite where J has no positive determinant.
double symmetric_dirichlet_energy(const Map_gradient& j);

// |J|^2 / det J (Hormann, Greiner 2000), 2 for what keeps angles, and a small part of det J + 1 / det J, without which
// the areas of faces would have no bounds: so 2.04 for a rotation, infinite where J has no positive determinant.
double conformal_energy(const Map_gradient& j);

inline double energy_of(Distortion_energy energy, const Map_gradient& j)
{
  return energy == Distortion_energy::CONFORMAL ? conformal_energy(j) : symmetric_dirichlet_energy(j);
}

// A summand of the Hessian, lambda q q^T.
struct Hessian_mode
{
  double lambda;
  std::array<double, 6> q;
};

// The derivatives of the energy for the coordinates x0 y0 x1 y1 x2 y2 of the corners, without the weight. The Hessian
// is the sum of the modes; one that bends downwards is left out (Smith, de Goes, Kim 2019).
struct Energy_derivatives
{
  std::array<double, 6> gradient;
  std::array<Hessian_mode, 4> modes;
};

Energy_derivatives derive_energy(const Rest_triangle& t, const Map_gradient& j,
                                 Distortion_energy energy = Distortion_energy::SYMMETRIC_DIRICHLET);

// How far the corners can go until the triangle loses its area; at most 1.
double step_to_collapse(const Rest_triangle& t, const std::vector<Plane_point>& at,
                        const std::vector<Plane_point>& step);

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_MAP_INTERNAL_DISTORTION_ENERGY_H
