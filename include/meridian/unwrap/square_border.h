// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_UNWRAP_SQUARE_BORDER_H
#define MERIDIAN_UNWRAP_SQUARE_BORDER_H

#include <meridian/cut/cut_to_disc.h>
#include <meridian/unwrap/internal/square_corners.h>

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

  int steps() const { return 4 * (size - 1); } ///< of the whole border
};

namespace internal {

// Lays the strands out on the square. The disc's halfedges are those of the surface.
inline Square_border lay_out(const Refined_surface& s, const Border_strands& border, int first_corner, int size)
{
  Square_border result;
  result.size = size;
  std::size_t at_corner = 0;
  for (const Border_side& side : border.sides)
  {
    const Strand& strand = border.strands[side.strand];
    const std::size_t n = strand.vertices.size() - 1;
    const int start = (side.start - first_corner + result.steps()) % result.steps();
    result.paths.push_back(
      {static_cast<Index>(result.loop.size()), static_cast<Index>(n), start, strand.steps, side.mate});
    for (std::size_t i = 0; i < n; ++i)
    {
      const std::size_t p = side.is_reversed ? n - i : i, q = side.is_reversed ? n - i - 1 : i + 1;
      const Index h = s.find_halfedge(strand.vertices[p], strand.vertices[q]);
      if (h < 0) { throw Internal_error("square_border: an edge of the border is missing"); }
      const double along = side.is_reversed ? strand.steps - strand.along[p] : strand.along[p];
      double place = start + along;
      if (place >= result.steps()) { place -= result.steps(); }
      if (place == 0) { at_corner = result.loop.size(); }
      result.loop.push_back(h);
      result.along.push_back(along);
      result.points.push_back(point_on_square(place, size));
    }
  }
  std::rotate(result.loop.begin(), result.loop.begin() + at_corner, result.loop.end());
  std::rotate(result.along.begin(), result.along.begin() + at_corner, result.along.end());
  std::rotate(result.points.begin(), result.points.begin() + at_corner, result.points.end());
  const Index shift = static_cast<Index>(at_corner), n = static_cast<Index>(result.loop.size());
  for (Border_path& path : result.paths) { path.first = (path.first - shift + n) % n; }
  return result;
}

} // namespace internal

/*!
 * \ingroup PkgMeridianParameterization
 *
 * lays the border of a disc out on the unit square so that its geometry image closes without cracks (Gu, Gortler, Hoppe
 * 2002).
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
inline Square_border prepare_square_border(const Triangle_surface& root, Cut& cut, int size)
{
  Triangle_surface disc = surface_of(cut.surface, cut.opened);
  internal::Border_strands border = internal::gather_border(cut.surface, cut.opened, disc);
  const int least = internal::least_size(border);
  if (size < least)
    throw Invalid_input_error("a geometry image of " + std::to_string(size) + " x " + std::to_string(size)
                              + " points is too small for a border of " + std::to_string(border.sides.size())
                              + " paths; the least size is " + std::to_string(least));
  internal::distribute_steps(cut.surface, border, 4 * (size - 1));
  const int first_corner = internal::choose_corners(disc, border, size);

  const auto divided = internal::divide_at_corners(root, cut.surface, border, first_corner, size);
  for (auto* curves : {&cut.meridians, &cut.longitudes})
  {
    for (auto& curve : *curves) { internal::insert_into_curve(divided, curve, true); }
  }
  for (auto* curves : {&cut.flow_lines, &cut.links, &cut.paths})
  {
    for (auto& curve : *curves) { internal::insert_into_curve(divided, curve, false); }
  }
  cut.opened = open_along(cut.surface);

  disc = surface_of(cut.surface, cut.opened);
  const Square_border first = internal::lay_out(cut.surface, border, first_corner, size);
  std::vector<unsigned> sides(disc.number_of_vertices(), 0);
  for (std::size_t i = 0; i < first.loop.size(); ++i)
  {
    sides[disc.source(first.loop[i])] = internal::sides_of(first.points[i]);
  }
  std::vector<Surface_curve> middles;
  for (Index h = 0; h < disc.number_of_halfedges(); ++h)
    if (disc.opposite[h] > h && (sides[disc.source(h)] & sides[disc.target(h)]))
    {
      middles.push_back({{Curve_point::on_edge(h, 0.5)}, false});
    }
  insert_curves(root, cut.surface, middles);
  cut.opened = open_along(cut.surface);
  cut.smallest_angle_after = smallest_angle(cut.surface);
  return internal::lay_out(cut.surface, border, first_corner, size); // faces have changed
}

} // namespace meridian

#endif // MERIDIAN_UNWRAP_SQUARE_BORDER_H
