// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MAP_DISTORTION_ENERGY_H
#define MERIDIAN_MAP_DISTORTION_ENERGY_H

namespace meridian {

/// \ingroup PkgMeridianParameterization
/// what is lowered when a map is improved, with the singular values G >= g of its Jacobian. Both grow without bound
/// before a face loses its area.
enum class Distortion_energy
{
  SYMMETRIC_DIRICHLET, ///< G^2 + g^2 + 1/G^2 + 1/g^2: lengths are kept (\cite smith2015)
  /// G/g + g/G, and a little of Gg + 1/(Gg): angles are kept, and areas where that is free (\cite hormann2000)
  CONFORMAL
};

} // namespace meridian

#endif // MERIDIAN_MAP_DISTORTION_ENERGY_H
