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
  POSITIVE,            ///< averages with symmetric positive weights (\cite tutte1963, \cite floater1997): the safest
  STRETCH,             ///< the same, with weights changed until stretch is low (\cite yoshizawa2004)
  MEAN_VALUE,          ///< mean value coordinates (\cite floater2003)
  TUTTE,               ///< averages with uniform weights (\cite tutte1963)
  CONFORMAL,           ///< discrete conformal (\cite eck1995)
  AUTHALIC,            ///< discrete authalic (\cite desbrun2002)
  LSCM,                ///< least squares conformal, two points fixed (\cite levy2002)
  ARAP                 ///< as rigid as possible (\cite liu2008)
};

/// \ingroup PkgMeridianParameterization
/// where the border of the disc goes. `FREE` means `CIRCLE` to methods that cannot leave it free.
enum class Map_border
{
  FREE,
  CIRCLE,
  SQUARE
};

/// the names of `Map_method`.
template <> struct Names<Map_method>
{
  static constexpr std::array<Named_value<Map_method>, 9> table{{
    {Map_method::SYMMETRIC_DIRICHLET, "symmetric-dirichlet", "low distortion, one-to-one"},
    {Map_method::POSITIVE, "positive", "averages with positive weights"},
    {Map_method::STRETCH, "stretch", "the same, with low stretch"},
    {Map_method::MEAN_VALUE, "mean-value", "mean value coordinates"},
    {Map_method::TUTTE, "tutte", "averages with uniform weights"},
    {Map_method::CONFORMAL, "conformal", "discrete conformal"},
    {Map_method::AUTHALIC, "authalic", "discrete authalic"},
    {Map_method::LSCM, "lscm", "least squares conformal, with a free border"},
    {Map_method::ARAP, "arap", "as rigid as possible, with a free border"},
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
/// \param border where the border shall go
/// \returns whether the method can leave it free, or put it there
constexpr bool takes(Map_method method, Map_border border)
{
  const bool is_always_free = method == Map_method::LSCM || method == Map_method::ARAP;
  return border == Map_border::FREE ? is_always_free || method == Map_method::SYMMETRIC_DIRICHLET : !is_always_free;
}

/// \ingroup PkgMeridianParameterization
/// \param method the method
/// \returns whether it can put the border on a convex polygon that is given
constexpr bool takes_polygon(Map_method method)
{
  return method == Map_method::SYMMETRIC_DIRICHLET || method == Map_method::POSITIVE || method == Map_method::STRETCH;
}

} // namespace meridian

#endif // MERIDIAN_MAP_MAP_METHOD_H
