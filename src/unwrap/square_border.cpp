// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/unwrap/square_border.h>

#include <meridian/base/exceptions.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/Surface_curve.h>
#include <meridian/surface/insert_curves.h>
#include <meridian/surface/measures.h>
#include <meridian/surface/open_along.h>
#include <meridian/unwrap/internal/border_strands.h>
#include <meridian/unwrap/internal/square_corners.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace meridian {

namespace internal {

namespace {

// Lays the strands out on the square. The disc's halfedges are those of the surface.
Square_border lay_out(const Refined_surface& s, const Border_strands& border, int first_corner, int size)
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

} // namespace

} // namespace internal

Square_border prepare_square_border(const Triangle_surface& root, Cut& cut, int size)
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
  for (Named_curve& curve : cut.curves) { internal::insert_into_curve(divided, curve.vertices, curve.is_closed); }
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
