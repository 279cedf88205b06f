// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_UNWRAP_PACK_UNWRAPPINGS_H
#define MERIDIAN_UNWRAP_PACK_UNWRAPPINGS_H

#include <meridian/map/pack_charts.h>
#include <meridian/unwrap/Unwrapping.h>

#include <vector>

namespace meridian {

/*!
 * \ingroup PkgMeridianParameterization
 *
 * packs the charts of unwrapped surfaces into one unit square, all at one scale of area, and measures the maps as they
 * then are.
 *
 * Before, slits that are narrower than the padding are opened by `open_slits()`, if there is any padding.
 *
 * \param unwrapped the surfaces, whose maps are moved
 * \param units how long the unit of each is, in one unit for all
 * \param options see `pack_charts()`
 * \param most_stretch the L2 stretch that each may have, where slits are not opened if it would be more; 0: any
 * \returns the part of the square that is filled
 * \pre as many units as surfaces, and one at least
 * \par Complexity
 * That of `pack_charts()`.
 */
double pack_unwrappings(std::vector<Unwrapping>& unwrapped, const std::vector<double>& units,
                        const Pack_options& options = Pack_options(), double most_stretch = 0);

} // namespace meridian

#endif // MERIDIAN_UNWRAP_PACK_UNWRAPPINGS_H
