// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/unwrap/geometry_image.h>

#include <meridian/base/Bounding_box.h>
#include <meridian/base/exceptions.h>
#include <meridian/base/vectors.h>
#include <meridian/map/planar_map.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/measures.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

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

namespace {

// Samples a surface on a square grid that its map lies over.
class Grid_sampler
{
public:
  Grid_sampler(const Triangle_surface& disc, const std::vector<Plane_point>& at, Geometry_image& image)
    : m_disc(disc), m_at(at), m_image(image), m_whole(image.size - 1),
      m_points(static_cast<std::size_t>(image.size) * image.size), m_is_found(m_points.size(), 0)
  {}

  void take_border(const Square_border& border)
  {
    const auto on_border = sample_border(m_disc, border);
    for (int k = 0; k < border.steps(); ++k)
    {
      const auto [column, row] = border_pixel(k, m_image.size);
      m_points[m_image.pixel(column, row)] = on_border[k];
      m_is_found[m_image.pixel(column, row)] = 1;
    }
  }

  // Takes the grid points inside the square that lie in a face.
  void take_face(Index f)
  {
    const auto& t = m_disc.triangles[f];
    const std::array<Plane_point, 3> corner{m_at[t[0]], m_at[t[1]], m_at[t[2]]};
    std::array<int, 2> first, last;
    for (int c = 0; c < 2; ++c)
    {
      const auto [low, high] = std::minmax({corner[0][c], corner[1][c], corner[2][c]});
      first[c] = std::max(1, static_cast<int>(std::ceil(low * m_whole - 1e-6)));
      last[c] = std::min(m_image.size - 2, static_cast<int>(std::floor(high * m_whole + 1e-6)));
    }
    if (first[0] > last[0] || first[1] > last[1] || orientation_of(corner[0], corner[1], corner[2]) <= 0) { return; }
    for (int row = first[1]; row <= last[1]; ++row)
      for (int column = first[0]; column <= last[0]; ++column)
      {
        const std::size_t pixel = m_image.pixel(column, row);
        const Plane_point p{column / m_whole, row / m_whole};
        if (m_is_found[pixel] || orientation_of(corner[0], corner[1], p) < 0
            || orientation_of(corner[1], corner[2], p) < 0 || orientation_of(corner[2], corner[0], p) < 0)
        {
          continue;
        }
        m_is_found[pixel] = 1;
        m_points[pixel] = lift(t, corner, p);
      }
  }

  // The positions of all grid points.
  const std::vector<Point>& points() const
  {
    if (const auto missing = std::count(m_is_found.begin(), m_is_found.end(), 0); missing > 0)
      throw Invalid_input_error("the map does not cover the square: " + std::to_string(missing)
                                + " grid points lie in no face");
    return m_points;
  }

private:
  // The point of a face over a point of its image.
  Point lift(const std::array<Index, 3>& t, const std::array<Plane_point, 3>& corner, const Plane_point& p) const
  {
    Point b;
    for (int k = 0; k < 3; ++k) { b[k] = std::max(0., cross(corner[(k + 1) % 3] - p, corner[(k + 2) % 3] - p)); }
    const double sum = b[0] + b[1] + b[2];
    if (!(sum > 0)) { b = {1, 0, 0}; }
    else { b = (1 / sum) * b; }
    return b[0] * m_disc.points[t[0]] + b[1] * m_disc.points[t[1]] + b[2] * m_disc.points[t[2]];
  }

  const Triangle_surface& m_disc;
  const std::vector<Plane_point>& m_at;
  const Geometry_image& m_image;
  double m_whole;
  std::vector<Point> m_points;
  std::vector<char> m_is_found;
};

// Writes positions as numbers of 16 bits in the box of a surface.
void quantize(const std::vector<Point>& points, const Triangle_surface& disc, Geometry_image& image)
{
  Bounding_box<Point> box(disc.points.front());
  for (const Point& p : disc.points) { box.add(p); }
  image.low = box.low;
  const Point extent = box.high - box.low;
  image.step = std::max({extent[0], extent[1], extent[2]}) / 65535;
  for (const Point& p : points)
    for (int c = 0; c < 3; ++c)
    {
      const double q = image.step > 0 ? std::floor((p[c] - image.low[c]) / image.step + 0.5) : 0;
      image.samples.push_back(static_cast<std::uint16_t>(std::min(std::max(q, 0.), 65535.)));
    }
}

// For each pixel the lowest that is the same point of the surface.
std::vector<Index> glue_pixels(const Geometry_image& image, const Square_border* border)
{
  std::vector<Index> same(static_cast<std::size_t>(image.size) * image.size); // a tree for each set
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
        const auto a = border_pixel((path.start + k) % border->steps(), image.size);
        const auto b = border_pixel((mate.start + mate.steps - k) % border->steps(), image.size);
        const Index p = find(static_cast<Index>(image.pixel(a[0], a[1]))),
                    q = find(static_cast<Index>(image.pixel(b[0], b[1])));
        same[std::max(p, q)] = std::min(p, q);
      }
    }
  for (std::size_t p = 0; p < same.size(); ++p) { same[p] = find(static_cast<Index>(p)); }
  return same;
}

// Divides the squares between pixels into two triangles each.
class Square_splitter
{
public:
  Square_splitter(const Geometry_image& image, const std::vector<Index>& same, bool has_border)
    : m_image(image), m_same(same), m_has_border(has_border), m_whole(image.size - 1)
  {}

  // Adds the triangles of a square, of pixels, unless it is a corner of the image that is folded.
  void add_square(int column, int row, Remeshed& result) const
  {
    const std::array<Pixel, 4> at{{{column, row}, {column + 1, row}, {column + 1, row + 1}, {column, row + 1}}};
    std::array<Index, 4> v;
    for (int k = 0; k < 4; ++k) { v[k] = m_same[m_image.pixel(at[k][0], at[k][1])]; }
    const bool is_rising = is_split_from_first(at);
    const std::array<std::array<Index, 3>, 2> faces =
      is_rising ? std::array<std::array<Index, 3>, 2>{{{v[0], v[1], v[2]}, {v[0], v[2], v[3]}}}
                : std::array<std::array<Index, 3>, 2>{{{v[0], v[1], v[3]}, {v[1], v[2], v[3]}}};
    if (is_rising ? v[1] == v[3] : v[0] == v[2])
    {
      result.faces_left_out += 2;
      return;
    }
    result.surface.triangles.insert(result.surface.triangles.end(), faces.begin(), faces.end());
  }

private:
  using Pixel = std::array<int, 2>;

  bool is_on_border(int x, int y) const { return x == 0 || y == 0 || x == m_whole || y == m_whole; }

  // Whether a diagonal from a border pixel to an inner one may join two vertices that are joined beside it already.
  bool is_doubled(Pixel a, Pixel b) const
  {
    if (is_on_border(b[0], b[1])) { std::swap(a, b); }
    if (!is_on_border(a[0], a[1]) || is_on_border(b[0], b[1])) { return false; }
    for (int y = b[1] - 1; y <= b[1] + 1; ++y)
      for (int x = b[0] - 1; x <= b[0] + 1; ++x)
        if ((x != a[0] || y != a[1]) && is_on_border(x, y)
            && m_same[m_image.pixel(x, y)] == m_same[m_image.pixel(a[0], a[1])])
        {
          return true;
        }
    return false;
  }

  // Whether the diagonal of a square runs from its first pixel to the third: it is the shorter one, unless the border
  // forbids that.
  bool is_split_from_first(const std::array<Pixel, 4>& at) const
  {
    const auto length = [&](int a) {
      return distance(m_image.point(m_image.pixel(at[a][0], at[a][1])),
                      m_image.point(m_image.pixel(at[a + 2][0], at[a + 2][1])));
    };
    const bool is_first_column = at[0][0] == 0, is_first_row = at[0][1] == 0, is_last_column = at[2][0] == m_whole,
               is_last_row = at[2][1] == m_whole;
    bool is_rising = length(0) <= length(1);
    if (m_has_border)
    {
      if (is_doubled(at[0], at[2])) { is_rising = false; }
      else if (is_doubled(at[1], at[3])) { is_rising = true; }
      if ((is_first_column && is_first_row) || (is_last_column && is_last_row)) { is_rising = true; }
      if ((is_first_column && is_last_row) || (is_last_column && is_first_row)) { is_rising = false; }
    }
    return is_rising;
  }

  const Geometry_image& m_image;
  const std::vector<Index>& m_same;
  bool m_has_border;
  int m_whole;
};

// Numbers the pixels that triangles use, which become vertices.
void number_vertices(const Geometry_image& image, const std::vector<Index>& same, Remeshed& result)
{
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
}

} // namespace

} // namespace internal

Geometry_image sample_geometry(const Triangle_surface& disc, const std::vector<Plane_point>& at,
                               const Square_border& border)
{
  Geometry_image image;
  image.size = border.size;
  internal::Grid_sampler sampler(disc, at, image);
  sampler.take_border(border);
  for (Index f = 0; f < disc.number_of_faces(); ++f) { sampler.take_face(f); }
  internal::quantize(sampler.points(), disc, image);
  return image;
}

Remeshed remesh_from_image(const Geometry_image& image, const Square_border* border)
{
  const int size = image.size;
  if (size < 2 || (border != nullptr && (size < 5 || border->size != size))
      || image.samples.size() != 3 * static_cast<std::size_t>(size) * size)
    throw Invalid_input_error("an image of " + std::to_string(size) + " x " + std::to_string(size)
                              + " points cannot become a surface with this border");
  const std::vector<Index> same = internal::glue_pixels(image, border);
  const internal::Square_splitter splitter(image, same, border != nullptr);
  Remeshed result;
  for (int row = 0; row + 1 < size; ++row)
    for (int column = 0; column + 1 < size; ++column) { splitter.add_square(column, row, result); }
  internal::number_vertices(image, same, result);
  connect(result.surface);
  return result;
}

} // namespace meridian
