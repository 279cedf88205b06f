// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_UNWRAP_GEOMETRY_IMAGE_H
#define MERIDIAN_UNWRAP_GEOMETRY_IMAGE_H

#include <meridian/base/vectors.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/unwrap/square_border.h>

#include <array>
#include <cstdint>
#include <vector>

namespace meridian {

/// \ingroup PkgMeridianParameterization
/// a surface as an image: a square grid of points, each coordinate a number of 16 bits (\cite gu2002).
///
/// Coordinate `c` of a sample `q` is `low[c] + step * q`. Rows go up: row 0 is the side of the unit square with y = 0.
struct Geometry_image
{
  int size = 0;                       ///< samples along a side
  std::vector<std::uint16_t> samples; ///< three a pixel, row by row
  Point low{0, 0, 0};                 ///< the lower corner of the bounding box
  /// of one unit, the same for the three axes: the longest side of the box over 65535
  double step = 0;

  /// \param column, row of a pixel
  /// \returns its place among the pixels
  std::size_t pixel(int column, int row) const { return static_cast<std::size_t>(row) * size + column; }
  /// \param pixel its place among the pixels
  /// \returns its position
  Point point(std::size_t pixel) const;
};

/// \ingroup PkgMeridianParameterization
/// a surface made of a geometry image.
struct Remeshed
{
  Triangle_surface surface; ///< two faces a square of four pixels
  /// of each pixel; pixels that are one point of the surface have one vertex; -1 where faces were left out
  std::vector<Index> vertex_of;
  /// pairs of faces that lie upon each other, where the free end of a seam is at a corner of the square
  Index faces_left_out = 0;
};

namespace internal {

// Column and row of a grid point of the border, counted counterclockwise from (0, 0).
std::array<int, 2> border_pixel(int k, int size);

// The points of the surface at the grid points of the border. Both sides of a seam receive the same, to the bit.
std::vector<Point> sample_border(const Triangle_surface& disc, const Square_border& border);

} // namespace internal

/*!
 * \ingroup PkgMeridianParameterization
 *
 * samples a surface that is mapped onto the unit square at `border.size` times `border.size` points.
 *
 * The sample of column i and row j is the point of the surface whose image is (i, j) / (size - 1). The face that holds
 * it is found with exact predicates; where several meet it is the first. Samples of the border are taken along its
 * edges, once for both sides of a seam, which so are equal to the bit. Faces that the map turned over are not looked
 * at.
 *
 * \param disc the surface
 * \param at the image of each vertex, with the border on that of the square
 * \param border what `prepare_square_border()` returned
 *
 * \returns the image
 * \throws Invalid_input_error if the image of the faces does not cover the square
 * \par Complexity
 * Linear in the faces and in the pixels of their bounding boxes.
 */
Geometry_image sample_geometry(const Triangle_surface& disc, const std::vector<Plane_point>& at,
                               const Square_border& border);

/*!
 * \ingroup PkgMeridianParameterization
 *
 * makes a surface of a geometry image: two triangles for every square of four pixels.
 *
 * With a border, the pixels of both sides of every seam become one vertex, by the steps of the paths and not by
 * coordinates; so a closed surface comes back closed, with its genus. The shorter diagonal of a square is taken, but at
 * the corners of the image that from the corner, and beside a seam none that would join two vertices a second time. If
 * the free end of a seam is at a corner, the two faces there are one upon the other; they are left out, and the surface
 * is closed behind them.
 *
 * \param image the image
 * \param border the border that it was sampled with, or null: then nothing is joined
 *
 * \returns the surface, whose vertices are numbered by their first pixel
 * \throws Invalid_input_error if the sizes of image and border differ, or are less than 2, or 5 with a border
 * \par Complexity
 * Linear.
 */
Remeshed remesh_from_image(const Geometry_image& image, const Square_border* border = nullptr);

} // namespace meridian

#endif // MERIDIAN_UNWRAP_GEOMETRY_IMAGE_H
