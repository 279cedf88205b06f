// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_UNWRAP_SQUARE_BORDER_H
#define MERIDIAN_UNWRAP_SQUARE_BORDER_H

#include <meridian/base/vectors.h>
#include <meridian/cut/Cut.h>
#include <meridian/surface/Triangle_surface.h>

#include <vector>

namespace meridian {

/// \ingroup PkgMeridianParameterization
/// a part of the border of a disc between two vertices where seams meet, end, or reach the boundary.
struct Border_path
{
  /// its first halfedge, as a place in the loop; the others follow, from the end of the loop on at its beginning
  Index first = 0;
  Index size = 0; ///< how many halfedges it has
  int start = 0;  ///< the grid point where it begins, counted along the border from the corner (0, 0)
  int steps = 0;  ///< how many steps of the grid it takes
  /// the path on the other side of the same seam, which runs backwards; -1 on the boundary of the surface
  Index mate = -1;
};

/// \ingroup PkgMeridianParameterization
/// the border of a disc on the unit square, fitted to an image of `size` times `size` points.
///
/// Grid point `start + k` of a path and `start + steps - k` of its mate are the same point of the surface, for `k` from
/// 0 to `steps`. So a surface that is made of the image closes without a crack.
struct Square_border
{
  int size = 0; ///< grid points along a side of the square
  /// the border of the opened disc as halfedges, counterclockwise, from the corner (0, 0)
  std::vector<Index> loop;
  std::vector<Plane_point> points; ///< the image of each halfedge's source; on a side, one coordinate is exactly 0 or 1
  std::vector<double> along;       ///< where each halfedge begins on its path, in steps
  std::vector<Border_path> paths;  ///< counterclockwise

  /// \returns how many steps the whole border has
  int steps() const { return 4 * (size - 1); }
};

/*!
 * \ingroup PkgMeridianParameterization
 *
 * lays the border of a disc out on the unit square so that its geometry image closes without cracks (\cite gu2002).
 *
 * The border is taken apart into paths between the vertices where seams meet, end, or reach the boundary. Each path
 * takes a whole number of steps of the grid by its length, both sides of a seam the same number; seams that would
 * become loops or double edges of the image take three and two at least. Along a path, vertices are placed by length.
 * The corners of the square come to lie on those grid points where the disc is narrowest, so not at the free end of a
 * seam if that can be avoided; a vertex close to such a point is moved there along the border, by at most a quarter of
 * an edge and half a step, and where there is none the edge is divided. Then every inner edge that joins two points of
 * one side is divided in its middle, so that maps with positive weights have no face without area.
 *
 * \param root the surface that was cut
 * \param cut the disc. Its surface is refined and opened again, and its curves pass the new vertices.
 * \param size grid points along a side of the square
 *
 * \returns the border, for the halfedges of `surface_of(cut.surface, cut.opened)`
 * \throws Invalid_input_error if what was cut is not one disc, or if `size` is too small for the paths; the message
 *   names the least size
 * \par Complexity
 * \f$ O(n + (k + N) \log k) \f$ for `k` vertices on the border and `N` grid points along a side
 */
Square_border prepare_square_border(const Triangle_surface& root, Cut& cut, int size);

} // namespace meridian

#endif // MERIDIAN_UNWRAP_SQUARE_BORDER_H
