// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MAP_MAP_METHOD_H
#define MERIDIAN_MAP_MAP_METHOD_H

#include <array>

namespace meridian {

/// \ingroup PkgMeridianParameterization
/// how a disc is mapped into the plane. Those from `MEAN_VALUE` on are CGAL's.
enum class Map_method
{
  SYMMETRIC_DIRICHLET, ///< one-to-one, with low distortion (Smith, Schaefer 2015; Jiang, Schaefer, Panozzo 2017)
  POSITIVE,            ///< averages with symmetric positive weights (Tutte 1963, Floater 1997): the safest
  STRETCH,             ///< the same, with weights changed until stretch is low (Yoshizawa, Belyaev, Seidel 2004)
  MEAN_VALUE,          ///< mean value coordinates (Floater 2003)
  TUTTE,               ///< averages with uniform weights (Tutte 1963)
  CONFORMAL,           ///< discrete conformal (Eck et al. 1995)
  AUTHALIC,            ///< discrete authalic (Desbrun, Meyer, Alliez 2002)
  LSCM,                ///< least squares conformal, two points fixed (Levy, Petitjean, Ray, Maillot 2002)
  ARAP                 ///< as rigid as possible (Liu, Zhang, Xu, Gotsman, Gortler 2008)
};

/// \ingroup PkgMeridianParameterization
/// where the border of the disc goes. `FREE` is for `SYMMETRIC_DIRICHLET`, `LSCM` and `ARAP`, which last two have no
/// other; it means `CIRCLE` to the others.
enum class Map_border
{
  FREE,
  CIRCLE,
  SQUARE
};

/// \ingroup PkgMeridianParameterization
/// all methods, the default first.
constexpr std::array<Map_method, 9> map_methods{
  Map_method::SYMMETRIC_DIRICHLET, Map_method::POSITIVE, Map_method::STRETCH, Map_method::MEAN_VALUE, Map_method::TUTTE,
  Map_method::CONFORMAL,           Map_method::AUTHALIC, Map_method::LSCM,    Map_method::ARAP};

/// \ingroup PkgMeridianParameterization
/// \returns the name of a method as it stands in reports
const char* name_of(Map_method method);

/// \ingroup PkgMeridianParameterization
/// \returns the name of a border as it stands in reports
inline const char* name_of(Map_border border)
{
  return border == Map_border::FREE ? "free" : border == Map_border::CIRCLE ? "circle" : "square";
}

} // namespace meridian

#endif // MERIDIAN_MAP_MAP_METHOD_H
