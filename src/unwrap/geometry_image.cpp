// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/unwrap/geometry_image.h>

#include <meridian/base/exceptions.h>
#include <meridian/curves/Normal_curves.h>
#include <meridian/curves/contours.h>
#include <meridian/field/critical_points.h>
#include <meridian/map/planar_map.h>
#include <meridian/surface/Surface_curve.h>
#include <meridian/surface/measures.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

namespace meridian {

Point Geometry_image::point(std::size_t pixel) const
{
  Point p = low;
  for (int c = 0; c < 3; ++c) { p[c] += step * samples[3 * pixel + c]; }
  return p;
}

namespace internal {

std::array<int, 2> border_pixel(int k, int size)
{
  const int whole = size - 1, side = k / whole % 4, f = k % whole;
  switch (side)
  {
  case 0: return {f, 0};
  case 1: return {whole, f};
  case 2: return {whole - f, whole};
  default: return {0, whole - f};
  }
}

std::vector<Point> sample_border(const Triangle_surface& disc, const Square_border& border)
{
  std::vector<Point> found(border.steps(), Point{0, 0, 0});
  const int steps = border.steps();
  const std::size_t n = border.loop.size();
  for (std::size_t p = 0; p < border.paths.size(); ++p)
  {
    const Border_path& path = border.paths[p];
    if (path.mate >= 0 && path.mate < static_cast<Index>(p)) { continue; } // written by its mate
    Index i = 0;
    const auto halfedge = [&](Index k) { return (path.first + k) % n; };
    for (int k = 0; k <= path.steps; ++k)
    {
      while (i + 1 < path.size && border.along[halfedge(i + 1)] <= k) { ++i; }
      const Index h = border.loop[halfedge(i)];
      const double begin = border.along[halfedge(i)],
                   end = i + 1 < path.size ? border.along[halfedge(i + 1)] : path.steps;
      const Point at = k == end     ? disc.points[disc.target(h)]
                       : k == begin ? disc.points[disc.source(h)]
                                    : disc.point_on(h, (k - begin) / (end - begin));
      found[(path.start + k) % steps] = at;
      if (path.mate < 0) { continue; }
      const Border_path& mate = border.paths[path.mate];
      found[(mate.start + mate.steps - k) % steps] = at;
    }
  }
  return found;
}

} // namespace internal

Geometry_image sample_geometry(const Triangle_surface& disc, const std::vector<Plane_point>& at,
                               const Square_border& border)
{
  const int size = border.size;
  const double whole = size - 1;
  Geometry_image image;
  image.size = size;
  std::vector<Point> points(static_cast<std::size_t>(size) * size);
  std::vector<char> is_found(points.size(), 0);
  const auto on_border = internal::sample_border(disc, border);
  for (int k = 0; k < border.steps(); ++k)
  {
    const auto [column, row] = internal::border_pixel(k, size);
    points[image.pixel(column, row)] = on_border[k];
    is_found[image.pixel(column, row)] = 1;
  }
  for (Index f = 0; f < disc.number_of_faces(); ++f)
  {
    const auto& t = disc.triangles[f];
    const std::array<Plane_point, 3> corner{at[t[0]], at[t[1]], at[t[2]]};
    std::array<int, 2> first, last;
    for (int c = 0; c < 2; ++c)
    {
      const auto [low, high] = std::minmax({corner[0][c], corner[1][c], corner[2][c]});
      first[c] = std::max(1, static_cast<int>(std::ceil(low * whole - 1e-6)));
      last[c] = std::min(size - 2, static_cast<int>(std::floor(high * whole + 1e-6)));
    }
    if (first[0] > last[0] || first[1] > last[1] || orientation_of(corner[0], corner[1], corner[2]) <= 0) { continue; }
    for (int row = first[1]; row <= last[1]; ++row)
      for (int column = first[0]; column <= last[0]; ++column)
      {
        const std::size_t pixel = image.pixel(column, row);
        const Plane_point p{column / whole, row / whole};
        if (is_found[pixel] || orientation_of(corner[0], corner[1], p) < 0
            || orientation_of(corner[1], corner[2], p) < 0 || orientation_of(corner[2], corner[0], p) < 0)
        {
          continue;
        }
        is_found[pixel] = 1;
        Point b;
        for (int k = 0; k < 3; ++k) { b[k] = std::max(0., cross(corner[(k + 1) % 3] - p, corner[(k + 2) % 3] - p)); }
        const double sum = b[0] + b[1] + b[2];
        if (!(sum > 0)) { b = {1, 0, 0}; }
        else { b = (1 / sum) * b; }
        points[pixel] = b[0] * disc.points[t[0]] + b[1] * disc.points[t[1]] + b[2] * disc.points[t[2]];
      }
  }
  if (const auto missing = std::count(is_found.begin(), is_found.end(), 0); missing > 0)
    throw Invalid_input_error("the map does not cover the square: " + std::to_string(missing)
                              + " grid points lie in no face");

  image.low = disc.points.front();
  Point high = image.low;
  for (const Point& p : disc.points)
    for (int c = 0; c < 3; ++c)
    {
      image.low[c] = std::min(image.low[c], p[c]);
      high[c] = std::max(high[c], p[c]);
    }
  image.step = std::max({high[0] - image.low[0], high[1] - image.low[1], high[2] - image.low[2]}) / 65535;
  for (const Point& p : points)
    for (int c = 0; c < 3; ++c)
    {
      const double q = image.step > 0 ? std::floor((p[c] - image.low[c]) / image.step + 0.5) : 0;
      image.samples.push_back(static_cast<std::uint16_t>(std::min(std::max(q, 0.), 65535.)));
    }
  return image;
}

Remeshed remesh_from_image(const Geometry_image& image, const Square_border* border)
{
  const int size = image.size;
  if (size < 2 || (border != nullptr && (size < 5 || border->size != size))
      || image.samples.size() != 3 * static_cast<std::size_t>(size) * size)
    throw Invalid_input_error("an image of " + std::to_string(size) + " x " + std::to_string(size)
                              + " points cannot become a surface with this border");
  std::vector<Index> same(static_cast<std::size_t>(size) * size); // a tree for each set of pixels that are one point
  std::iota(same.begin(), same.end(), Index(0));
  const auto find = [&](Index p) {
    while (same[p] != p) { p = same[p] = same[same[p]]; }
    return p;
  };
  if (border != nullptr)
    for (const Border_path& path : border->paths)
    {
      if (path.mate < 0) { continue; }
      const Border_path& mate = border->paths[path.mate];
      for (int k = 0; k <= path.steps; ++k)
      {
        const auto a = internal::border_pixel((path.start + k) % border->steps(), size);
        const auto b = internal::border_pixel((mate.start + mate.steps - k) % border->steps(), size);
        const Index p = find(static_cast<Index>(image.pixel(a[0], a[1]))),
                    q = find(static_cast<Index>(image.pixel(b[0], b[1])));
        same[std::max(p, q)] = std::min(p, q);
      }
    }
  for (std::size_t p = 0; p < same.size(); ++p) { same[p] = find(static_cast<Index>(p)); }

  const int whole = size - 1;
  const auto is_on_border = [&](int x, int y) { return x == 0 || y == 0 || x == whole || y == whole; };
  // Whether a diagonal from a border pixel to an inner one may join two vertices that are joined beside it already.
  const auto is_doubled = [&](std::array<int, 2> a, std::array<int, 2> b) {
    if (is_on_border(b[0], b[1])) { std::swap(a, b); }
    if (!is_on_border(a[0], a[1]) || is_on_border(b[0], b[1])) { return false; }
    for (int y = b[1] - 1; y <= b[1] + 1; ++y)
      for (int x = b[0] - 1; x <= b[0] + 1; ++x)
        if ((x != a[0] || y != a[1]) && is_on_border(x, y) && same[image.pixel(x, y)] == same[image.pixel(a[0], a[1])])
        {
          return true;
        }
    return false;
  };
  Remeshed result;
  for (int row = 0; row < whole; ++row)
    for (int column = 0; column < whole; ++column)
    {
      const std::array<std::array<int, 2>, 4> at{
        {{column, row}, {column + 1, row}, {column + 1, row + 1}, {column, row + 1}}};
      std::array<Index, 4> v;
      for (int k = 0; k < 4; ++k) { v[k] = same[image.pixel(at[k][0], at[k][1])]; }
      const auto length = [&](int a) {
        return distance(image.point(image.pixel(at[a][0], at[a][1])),
                        image.point(image.pixel(at[a + 2][0], at[a + 2][1])));
      };
      const bool is_first_column = column == 0, is_first_row = row == 0, is_last_column = column + 1 == whole,
                 is_last_row = row + 1 == whole;
      bool is_rising = length(0) <= length(1);
      if (border != nullptr)
      {
        if (is_doubled(at[0], at[2])) { is_rising = false; }
        else if (is_doubled(at[1], at[3])) { is_rising = true; }
        if ((is_first_column && is_first_row) || (is_last_column && is_last_row)) { is_rising = true; }
        if ((is_first_column && is_last_row) || (is_last_column && is_first_row)) { is_rising = false; }
      }
      const std::array<std::array<Index, 3>, 2> faces =
        is_rising ? std::array<std::array<Index, 3>, 2>{{{v[0], v[1], v[2]}, {v[0], v[2], v[3]}}}
                  : std::array<std::array<Index, 3>, 2>{{{v[0], v[1], v[3]}, {v[1], v[2], v[3]}}};
      // a corner of the image, folded
      if (is_rising ? v[1] == v[3] : v[0] == v[2])
      {
        result.faces_left_out += 2;
        continue;
      }
      result.surface.triangles.insert(result.surface.triangles.end(), faces.begin(), faces.end());
    }

  std::vector<Index> vertex(same.size(), -1);
  for (const auto& t : result.surface.triangles)
  {
    for (Index p : t) { vertex[p] = 0; }
  }
  for (std::size_t p = 0; p < same.size(); ++p)
  {
    if (vertex[p] < 0) { continue; }
    vertex[p] = result.surface.number_of_vertices();
    result.surface.points.push_back(image.point(p));
  }
  for (auto& t : result.surface.triangles)
  {
    for (Index& p : t) { p = vertex[p]; }
  }
  for (Index p : same) { result.vertex_of.push_back(vertex[p]); }
  connect(result.surface);
  return result;
}

} // namespace meridian
