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

/// \addtogroup PkgMeridianSurface
/// @{

/// \param a, b points \returns the vector from `b` to `a`
inline Point operator-(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
/// \param a, b vectors \returns their sum
inline Point operator+(const Point& a, const Point& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
/// \param s a factor \param a a vector \returns `s` times `a`
inline Point operator*(double s, const Point& a) { return {s * a[0], s * a[1], s * a[2]}; }
/// \param a, b vectors \returns their scalar product
inline double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
/// \param a, b vectors \returns their vector product
inline Point cross(const Point& a, const Point& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
/// \param a a vector \returns its length
inline double norm(const Point& a) { return std::sqrt(dot(a, a)); }
/// \param a, b points \returns how far they are apart
inline double distance(const Point& a, const Point& b) { return norm(a - b); }

/// @}

/// \ingroup PkgMeridianParameterization
/// coordinates in the plane.
struct Plane_point : std::array<double, 2>
{};

/// \addtogroup PkgMeridianParameterization
/// @{

/// \param a, b points \returns the vector from `b` to `a`
inline Plane_point operator-(const Plane_point& a, const Plane_point& b) { return {a[0] - b[0], a[1] - b[1]}; }
/// \param a, b vectors \returns their sum
inline Plane_point operator+(const Plane_point& a, const Plane_point& b) { return {a[0] + b[0], a[1] + b[1]}; }
/// \param s a factor \param a a vector \returns `s` times `a`
inline Plane_point operator*(double s, const Plane_point& a) { return {s * a[0], s * a[1]}; }
/// \param a, b vectors \returns their scalar product
inline double dot(const Plane_point& a, const Plane_point& b) { return a[0] * b[0] + a[1] * b[1]; }
/// \param a, b vectors \returns the area of their parallelogram, positive if `b` is to the left of `a`
inline double cross(const Plane_point& a, const Plane_point& b) { return a[0] * b[1] - a[1] * b[0]; }
/// \param a a vector \returns its length
inline double norm(const Plane_point& a) { return std::sqrt(dot(a, a)); }

/// @}

} // namespace meridian

#endif // MERIDIAN_BASE_VECTORS_H
