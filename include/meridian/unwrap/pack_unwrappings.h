// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_UNWRAP_PACK_UNWRAPPINGS_H
#define MERIDIAN_UNWRAP_PACK_UNWRAPPINGS_H

#include <meridian/map/pack_charts.h>
#include <meridian/unwrap/Unwrapping.h>

#include <cstddef>
#include <vector>

namespace meridian {

/// \ingroup PkgMeridianParameterization
/// where a texture shall have a vertex.
struct Texture_pin
{
  std::size_t surface; ///< the number of the surface
  Index vertex;        ///< of its disc
  Plane_point at;      ///< in the unit square
};

/*!
 * \ingroup PkgMeridianParameterization
 *
 * packs the charts of unwrapped surfaces into one unit square, all at one scale of area, and measures the maps as they
 * then are.
 *
 * Charts with pins are put, and if they must be, drawn to where these are, by `pin_map()`, and stay there; the others
 * are packed beside them. Charts with one pin are as large beside their surface as those with several. Maps that are
 * not one-to-one are not pinned.
 *
 * If there is any padding, slits that are narrower are opened by `open_slits()`: in full, by half or by a quarter,
 * whatever makes the square of the L2 stretch of a chart, less 1, no more than a tenth larger. Those of charts that are
 * pinned or mirror images of each other, and of maps that are not one-to-one, stay as they are.
 *
 * \param unwrapped the surfaces, whose maps are moved
 * \param units how long the unit of each is, in one unit for all
 * \param options see `pack_charts()`
 * \param most_stretch the L2 stretch that each may have, where slits are not opened if it would be more; 0: any
 * \param pins vertices with a place in the texture, each once
 * \returns the part of the square that is filled
 * \throws Invalid_input_error as `pack_charts()`, or if a chart that is pinned does not lie in the unit square, or has
 *   no room in it; Solver_error as `pin_map()`
 * \pre as many units as surfaces, and one at least
 * \par Complexity
 * That of `pack_charts()` twice, of `open_slits()` three times and a few factorizations for each chart with slits, and
 * of `pin_map()`.
 */
double pack_unwrappings(std::vector<Unwrapping>& unwrapped, const std::vector<double>& units,
                        const Pack_options& options = Pack_options(), double most_stretch = 0,
                        const std::vector<Texture_pin>& pins = {});

} // namespace meridian

#endif // MERIDIAN_UNWRAP_PACK_UNWRAPPINGS_H
