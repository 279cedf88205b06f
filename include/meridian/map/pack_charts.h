// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MAP_PACK_CHARTS_H
#define MERIDIAN_MAP_PACK_CHARTS_H

#include <meridian/base/vectors.h>

#include <array>
#include <vector>

namespace meridian {

/// \ingroup PkgMeridianParameterization
/// a map of a disc, to be packed with others.
struct Chart
{
  const std::vector<std::array<Index, 3>>* triangles; ///< its faces, which are the caller's
  std::vector<Plane_point> at;                        ///< the image of each vertex
  double area;                                        ///< of the disc, in one unit for all charts
  bool is_fixed = false;                              ///< whether it stays where it is, in the texture
};

/// \ingroup PkgMeridianParameterization
/// how charts are packed.
struct Pack_options
{
  /// texels to the right and upwards of the texture, whose sides are 1 whatever its shape
  std::array<int, 2> resolution{2048, 2048};
  double padding = 2; ///< texels between two charts, at least
  int tries = 64;     ///< ways to begin that are compared on a coarse grid, fewer of many charts
  double density = 0; ///< texels along a unit of length; 0: as many as fit
  /// with `density`: how many textures there may be. Number `t` is moved by `t % 10` to the right and `t / 10` up, as
  /// is the custom of UDIM
  int tiles = 1;
  /// whether charts that rounding would shrink to nothing may be larger than in proportion
  bool may_enlarge = true;
};

/*!
 * \ingroup PkgMeridianParameterization
 *
 * packs charts into the unit square by their outlines, all at one scale of area, and of one shape in texels.
 *
 * Charts are taken by size, the largest first. Each is tried in several directions, large ones in many, at all
 * places of a grid of cells where it touches no cell that another chart or its padding touches, and so also inside
 * of the bays of others; the place is taken with which the square grows least (\cite levy2002 lets charts down onto
 * a horizon instead, which leaves bays empty). Several directions of the first chart and orders of all are tried on a
 * coarse grid, and the best of them on a fine one. Then the square is scaled to the unit square; or, with a density,
 * or if charts are fixed, which say the density, each chart goes into the first square that has a place for it. A chart
 * is not turned, and may be enlarged, if rounding would otherwise turn a face over. Charts may overlap themselves, and
 * be mirrored.
 *
 * \param charts the charts; their points are moved
 * \param options see there
 * \returns the part of the square that is filled, or of all squares that are used
 * \throws Invalid_input_error if the padding leaves no room for so many charts, or so many squares no room at that
 *   density, or charts that are fixed overlap
 * \pre there is a chart; no padding is more than a quarter of the resolution; charts that are fixed have an area, and
 *   lie in the unit square
 * \par Complexity
 * For each chart and direction, the number of the chart's rows of cells times that of the square's, of which there are
 * up to about 1024.
 */
double pack_charts(std::vector<Chart>& charts, const Pack_options& options = Pack_options());

/// \ingroup PkgMeridianParameterization
/// \returns the area of the faces of a chart in the plane, whichever way they are turned
/// \param chart the chart
double covered_area(const Chart& chart);

/// \ingroup PkgMeridianParameterization
/// \returns a point of a texture where its shape is that of its texels, in a rectangle whose longer side is 1
/// \param p the point
/// \param resolution the texels of the texture to the right and upwards
Plane_point in_proportion(const Plane_point& p, const std::array<int, 2>& resolution);

/// \ingroup PkgMeridianParameterization
/// \returns the number of the last square that has a point, as `Pack_options::tiles` counts them, and one more
/// \param at the points
int count_tiles(const std::vector<Plane_point>& at);

} // namespace meridian

#endif // MERIDIAN_MAP_PACK_CHARTS_H
