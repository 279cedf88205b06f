// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_BASE_VECTORS_H
#define MERIDIAN_BASE_VECTORS_H

#include <array>
#include <cmath>
#include <cstdint>

namespace meridian {

/// \ingroup PkgMeridianSurface
/// index of a vertex, face or halfedge; `-1` means "none".
using Index = std::int32_t;

/// \ingroup PkgMeridianSurface
/// Cartesian coordinates.
struct Point : std::array<double, 3>
{};

inline Point operator-(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Point operator+(const Point& a, const Point& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Point operator*(double s, const Point& a) { return {s * a[0], s * a[1], s * a[2]}; }
inline double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Point cross(const Point& a, const Point& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double norm(const Point& a) { return std::sqrt(dot(a, a)); }
inline double distance(const Point& a, const Point& b) { return norm(a - b); }

/// \ingroup PkgMeridianParameterization
/// coordinates in the plane.
struct Plane_point : std::array<double, 2>
{};

inline Plane_point operator-(const Plane_point& a, const Plane_point& b) { return {a[0] - b[0], a[1] - b[1]}; }
inline Plane_point operator+(const Plane_point& a, const Plane_point& b) { return {a[0] + b[0], a[1] + b[1]}; }
inline Plane_point operator*(double s, const Plane_point& a) { return {s * a[0], s * a[1]}; }
inline double dot(const Plane_point& a, const Plane_point& b) { return a[0] * b[0] + a[1] * b[1]; }
inline double cross(const Plane_point& a, const Plane_point& b) { return a[0] * b[1] - a[1] * b[0]; }
inline double norm(const Plane_point& a) { return std::sqrt(dot(a, a)); }

} // namespace meridian

#endif // MERIDIAN_BASE_VECTORS_H
