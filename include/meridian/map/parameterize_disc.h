// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MAP_PARAMETERIZE_DISC_H
#define MERIDIAN_MAP_PARAMETERIZE_DISC_H

#include <meridian/map/Parameterization.h>
#include <meridian/surface/Triangle_surface.h>

namespace meridian {

/// \ingroup PkgMeridianParameterization
/// \returns whether a method can leave the border free
inline bool has_free_border(Map_method m)
{
  return m == Map_method::SYMMETRIC_DIRICHLET || m == Map_method::LSCM || m == Map_method::ARAP;
}

Parameterization parameterize_disc(const Triangle_surface& disc, const Map_options& options);

} // namespace meridian

#endif // MERIDIAN_MAP_PARAMETERIZE_DISC_H
