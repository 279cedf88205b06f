// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MAP_MAP_METHOD_H
#define MERIDIAN_MAP_MAP_METHOD_H

#include <array>

#include <meridian/base/names.h>

namespace meridian {

/// \ingroup PkgMeridianParameterization
/// how a disc is mapped into the plane. Those from `MEAN_VALUE` on are CGAL's.
enum class Map_method
{
  SYMMETRIC_DIRICHLET, ///< one-to-one, with low distortion (\cite smith2015; \cite jiang2017)
  CONFORMAL,           ///< the same, then with low distortion of angles (\cite hormann2000)
  POSITIVE,            ///< averages with symmetric positive weights (\cite tutte1963, \cite floater1997): the safest
  STRETCH,             ///< the same, with weights changed until stretch is low (\cite yoshizawa2004)
  MEAN_VALUE,          ///< mean value coordinates (\cite floater2003)
  TUTTE,               ///< averages with uniform weights (\cite tutte1963)
  AUTHALIC             ///< discrete authalic (\cite desbrun2002)
};

/// \ingroup PkgMeridianParameterization
/// where the border of the disc goes. `FREE` means `CIRCLE` to methods that do not improve maps.
enum class Map_border
{
  FREE,
  CIRCLE,
  SQUARE
};

/// the names of `Map_method`.
template <> struct Names<Map_method>
{
  static constexpr std::array<Named_value<Map_method>, 7> table{{
    {Map_method::SYMMETRIC_DIRICHLET, "symmetric-dirichlet", "low distortion, one-to-one"},
    {Map_method::CONFORMAL, "conformal", "low distortion of angles, one-to-one"},
    {Map_method::POSITIVE, "positive", "averages with positive weights"},
    {Map_method::STRETCH, "stretch", "the same, with low stretch"},
    {Map_method::MEAN_VALUE, "mean-value", "mean value coordinates"},
    {Map_method::TUTTE, "tutte", "averages with uniform weights"},
    {Map_method::AUTHALIC, "authalic", "discrete authalic"},
  }};
};

/// the names of `Map_border`.
template <> struct Names<Map_border>
{
  static constexpr std::array<Named_value<Map_border>, 3> table{{
    {Map_border::FREE, "free", "it moves as the map wants"},
    {Map_border::CIRCLE, "circle", "on a circle"},
    {Map_border::SQUARE, "square", "on a square"},
  }};
};

/// \ingroup PkgMeridianParameterization
/// \param method the method
/// \returns whether it moves a one-to-one map to a better one, and so keeps it one-to-one
constexpr bool improves_maps(Map_method method)
{
  return method == Map_method::SYMMETRIC_DIRICHLET || method == Map_method::CONFORMAL;
}

/// \ingroup PkgMeridianParameterization
/// \param method the method
/// \returns whether it can put the border on a convex polygon that is given
constexpr bool takes_polygon(Map_method method)
{
  return improves_maps(method) || method == Map_method::POSITIVE || method == Map_method::STRETCH;
}

} // namespace meridian

#endif // MERIDIAN_MAP_MAP_METHOD_H
