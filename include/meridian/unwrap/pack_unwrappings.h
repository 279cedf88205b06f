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
 * \param unwrapped the surfaces, whose maps are moved
 * \param units how long the unit of each is, in one unit for all
 * \param options see `pack_charts()`
 * \returns the part of the square that is filled
 * \pre as many units as surfaces, and one at least
 * \par Complexity
 * That of `pack_charts()`.
 */
double pack_unwrappings(std::vector<Unwrapping>& unwrapped, const std::vector<double>& units,
                        const Pack_options& options = Pack_options());

} // namespace meridian

#endif // MERIDIAN_UNWRAP_PACK_UNWRAPPINGS_H
