// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_BASE_POLYGON_SOUP_H
#define MERIDIAN_BASE_POLYGON_SOUP_H

#include <meridian/base/vectors.h>

#include <cstdint>
#include <vector>

namespace meridian {

/// \ingroup PkgMeridianSurface
/// what a mesh file holds: points, and polygons as lists of point indices, in the file's order.
struct Polygon_soup
{
  std::vector<Point> points;         ///< in the file's order
  std::vector<std::int32_t> corners; ///< the polygons' point indices, one after the other
  std::vector<std::size_t> begin{0}; ///< polygon `i` has the corners `begin[i]` to `begin[i+1]-1`

  /// \returns how many polygons there are
  std::size_t number_of_polygons() const { return begin.size() - 1; }
  /// \param i a polygon \returns the number of its corners
  std::size_t size(std::size_t i) const { return begin[i + 1] - begin[i]; }
  /// \param i a polygon \param k which of its corners, from 0 \returns the index of the point there
  std::int32_t corner(std::size_t i, std::size_t k) const { return corners[begin[i] + k]; }
  /// appends a polygon. \param first the first of its point indices \param n how many there are
  void add_polygon(const std::int32_t* first, std::size_t n);
};

/// \ingroup PkgMeridianSurface
/// calls `f(triangle, polygon, a, b, c)` for each triangle of a soup. Polygons are cut by a fan from their corner of
/// lowest index, triangles are taken as they stand; the triangles are counted through, dropped ones too.
/// \param soup the soup
/// \param f the function; `a`, `b` and `c` are point indices
template <class Function> void for_each_triangle(const Polygon_soup& soup, Function f)
{
  std::int32_t triangle = 0;
  for (std::size_t i = 0; i < soup.number_of_polygons(); ++i)
  {
    const std::size_t n = soup.size(i);
    std::size_t lowest = 0;
    for (std::size_t k = 1; k < n && n > 3; ++k)
    {
      if (soup.corner(i, k) < soup.corner(i, lowest)) { lowest = k; }
    }
    for (std::size_t k = 1; k + 1 < n; ++k)
      f(triangle++, static_cast<std::int32_t>(i), soup.corner(i, lowest), soup.corner(i, (lowest + k) % n),
        soup.corner(i, (lowest + k + 1) % n));
  }
}

} // namespace meridian

#endif // MERIDIAN_BASE_POLYGON_SOUP_H
