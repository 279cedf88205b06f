// Charts packed by their outlines.
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

#include "support/sample_surfaces.h"

#include <meridian/base/exceptions.h>
#include <meridian/base/vectors.h>
#include <meridian/map/internal/Atlas.h>
#include <meridian/map/pack_charts.h>
#include <meridian/map/planar_map.h>
#include <meridian/surface/Triangle_surface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <set>
#include <vector>

namespace data = boost::unit_test::data;
using namespace meridian;

namespace {

using Triangles = std::vector<std::array<Index, 3>>;

// The place of each point of a sheet that is flat: how far along it and how high it lies.
std::vector<Plane_point> flat(const Triangle_surface& s)
{
  std::vector<Plane_point> at;
  for (const Point& p : s.points) { at.push_back({std::hypot(p[0], p[1]), p[2]}); }
  return at;
}

double distance_to_segment(const Plane_point& p, const Plane_point& a, const Plane_point& b)
{
  const Plane_point ab = b - a;
  const double t = std::clamp(dot(p - a, ab) / dot(ab, ab), 0., 1.);
  return norm(p - (a + t * ab));
}

// Of all pairs of charts, by all sides of all faces.
double least_distance(const std::vector<Chart>& charts)
{
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < charts.size(); ++i)
    for (std::size_t j = 0; j < charts.size(); ++j)
      for (const auto& t : *charts[i].triangles)
        for (std::size_t k = 0; k < 3 && i != j; ++k)
          for (const auto& other : *charts[j].triangles)
          {
            least = std::min(
              least, distance_to_segment(charts[j].at[other[k]], charts[i].at[t[k]], charts[i].at[t[(k + 1) % 3]]));
          }
  return least;
}

// Squares of a grid, as a chart.
struct Pixels
{
  Triangles triangles;
  std::vector<Plane_point> at;
  Pixels(int width, int height, const std::function<bool(int, int)>& is_filled, double scale = 1)
  {
    for (int y = 0; y <= height; ++y)
      for (int x = 0; x <= width; ++x) { at.push_back({scale * x, scale * y}); }
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
      {
        if (!is_filled(x, y)) { continue; }
        const Index v = y * (width + 1) + x, w = v + width + 1;
        triangles.push_back({v, v + 1, w + 1});
        triangles.push_back({v, w + 1, w});
      }
  }
  Chart chart() const { return {&triangles, at, area_of(triangles, at)}; }
};

std::set<std::array<int, 2>> cells_in(const internal::Chart_cells& cells, int x, int y)
{
  std::set<std::array<int, 2>> all;
  for (const auto& run : cells.runs)
    for (int k = run.begin; k < run.end; ++k) { all.insert({x + k, y + run.row}); }
  return all;
}

} // namespace

BOOST_AUTO_TEST_CASE(charts_are_packed_side_by_side_at_one_scale)
{
  std::vector<Triangle_surface> discs;
  for (int i = 1; i <= 12; ++i)
  {
    discs.push_back(sample::sheet(i, 3, [&](double x, double y) {
      return Point{i * x * std::cos(i), i * x * std::sin(i) + 0.3 * y, y};
    }));
  }
  std::vector<Chart> charts;
  std::vector<double> areas;
  for (const Triangle_surface& d : discs)
  {
    double area = 0;
    for (const auto& t : d.triangles)
    {
      area += norm(cross(d.points[t[1]] - d.points[t[0]], d.points[t[2]] - d.points[t[0]])) / 2;
    }
    areas.push_back(area);
    charts.push_back({&d.triangles, flat(d), area});
  }
  const double filled = pack_charts(charts);
  double covered = 0;
  std::vector<std::array<double, 4>> boxes;
  for (std::size_t i = 0; i < charts.size(); ++i)
  {
    BOOST_TEST(find_flipped_faces(discs[i].triangles, charts[i].at).size() == 0u);
    const double image = area_of(discs[i].triangles, charts[i].at);
    covered += image;
    BOOST_TEST(image / areas[i] == area_of(discs[0].triangles, charts[0].at) / areas[0],
               boost::test_tools::tolerance(1e-9));
    for (const Plane_point& p : charts[i].at)
      for (int k = 0; k < 2; ++k)
      {
        BOOST_TEST(p[k] >= 0);
        BOOST_TEST(p[k] <= 1);
      }
  }
  BOOST_TEST(filled == covered, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(covered > 0.6); // rectangles all, so there is no excuse
  BOOST_TEST(least_distance(charts) >= 2. / 2048);
}

BOOST_AUTO_TEST_CASE(more_padding_keeps_charts_farther_apart)
{
  std::vector<Pixels> pixels;
  for (int i = 0; i < 9; ++i)
  {
    pixels.emplace_back(6 + i, 5, [&](int x, int y) { return (x + y * i) % 4 > 0 || y == 0; });
  }
  std::vector<double> filled;
  for (const double padding : {0., 4., 16., 32.})
  {
    std::vector<Chart> charts;
    for (const Pixels& p : pixels) { charts.push_back(p.chart()); }
    filled.push_back(pack_charts(charts, {{512, 512}, padding}));
    BOOST_TEST(least_distance(charts) >= padding / 512);
    BOOST_TEST(least_distance(charts) > 0);
  }
  BOOST_TEST(filled[1] < filled[0] + 0.01); // about: what fits depends on the shapes
  BOOST_TEST(filled[2] < filled[1]);
  BOOST_TEST(filled[3] < filled[2]);
}

BOOST_AUTO_TEST_CASE(padding_without_room_for_charts_is_refused)
{
  const Pixels square(1, 1, [](int, int) { return true; });
  std::vector<Chart> charts(40, square.chart());
  BOOST_CHECK_THROW(pack_charts(charts, {{64, 64}, 16}), Invalid_input_error);
  pack_charts(charts, {{64, 64}, 5});
  BOOST_TEST(least_distance(charts) >= 5. / 64);
}

// Whatever the shape of a texture: where its texels are squares, charts are what they were.
BOOST_DATA_TEST_CASE(a_texture_need_not_be_a_square, data::make({512, 128, 300}) ^ data::make({128, 512, 200}), width,
                     height)
{
  const std::array<int, 2> resolution{width, height};
  std::vector<Pixels> pixels;
  for (int i = 0; i < 9; ++i)
  {
    pixels.emplace_back(6 + i, 5, [&](int x, int y) { return (x + y * i) % 4 > 0 || y == 0; });
  }
  std::vector<Chart> charts, in_texels;
  for (const Pixels& p : pixels) { charts.push_back(p.chart()); }
  const double filled = pack_charts(charts, {resolution, 4.});
  double covered = 0;
  const auto length = [](const Chart& c, Index v, Index w) { return norm(c.at[v] - c.at[w]); };
  double side = 0; // of a pixel, in texels
  for (std::size_t i = 0; i < charts.size(); ++i)
  {
    in_texels.push_back(charts[i]);
    covered += area_of(pixels[i].triangles, charts[i].at);
    for (Plane_point& p : in_texels.back().at)
    {
      for (std::size_t k = 0; k < 2; ++k)
      {
        BOOST_TEST(p[k] >= 0);
        BOOST_TEST(p[k] <= 1);
        p[k] *= resolution[k];
      }
    }
    for (const auto& t : pixels[i].triangles)
    {
      if (side == 0) { side = length(in_texels.back(), t[0], t[1]); }
      const bool is_lower = t[1] == t[0] + 1; // which begins with a side to the right, the other with a diagonal
      BOOST_TEST(length(in_texels.back(), t[0], t[1]) == (is_lower ? 1 : std::sqrt(2.)) * side,
                 boost::test_tools::tolerance(1e-9));
      BOOST_TEST(length(in_texels.back(), t[1], t[2]) == side, boost::test_tools::tolerance(1e-9));
    }
  }
  BOOST_TEST(filled == covered, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(filled > 0.35);
  BOOST_TEST(least_distance(in_texels) >= 4);

  const Pixels strip(4, 1, [](int, int) { return true; });
  std::vector<Chart> one{strip.chart()};
  const double of_strip = pack_charts(one, {resolution});
  BOOST_TEST(of_strip == (width == 300 ? 0.375 : 1), boost::test_tools::tolerance(1e-9));
}

// Squares of 1 and 2 units, at ten texels a unit: those of 2 need a texture of 24 texels each with their padding.
BOOST_AUTO_TEST_CASE(charts_at_a_density_fill_as_many_tiles_as_they_need)
{
  const Pixels one(1, 1, [](int, int) { return true; }), two(2, 2, [](int, int) { return true; });
  std::vector<Chart> charts(5, one.chart());
  charts.insert(charts.end(), 12, two.chart());
  std::mt19937 random(3);
  std::shuffle(charts.begin(), charts.end(), random);
  for (Chart& c : charts)
    for (Plane_point& p : c.at) { p = 0.37 * Plane_point{-p[1], p[0]}; } // whatever their size was
  for (Plane_point& p : charts[2].at) { p[0] = -p[0]; }                  // and one is mirrored
  Pack_options options;
  options.resolution = {24, 24};
  options.padding = 2;
  options.density = 10;
  options.tiles = 13;
  auto others = charts;
  BOOST_CHECK_THROW(pack_charts(others, options), Invalid_input_error);
  options.tiles = 14; // one for each square of 2, and four squares of 1 in another
  const double filled = pack_charts(charts, options);
  std::set<std::array<int, 2>> tiles;
  double covered = 0;
  for (const Chart& c : charts)
  {
    std::array<double, 4> box{1e9, 1e9, -1e9, -1e9};
    for (const Plane_point& p : c.at)
    {
      box = {std::min(box[0], p[0]), std::min(box[1], p[1]), std::max(box[2], p[0]), std::max(box[3], p[1])};
    }
    const std::array<int, 2> tile{static_cast<int>(box[0]), static_cast<int>(box[1])};
    tiles.insert(tile);
    BOOST_TEST(box[2] <= tile[0] + 1);
    BOOST_TEST(box[3] <= tile[1] + 1);
    const double side = c.area > 2 ? 20. / 24 : 10. / 24;
    BOOST_TEST(std::abs(area_of(*c.triangles, c.at)) == side * side, boost::test_tools::tolerance(1e-9));
    covered += side * side;
  }
  BOOST_TEST((area_of(*charts[2].triangles, charts[2].at) < 0));
  for (Chart& c : charts) // tiles are textures apart
  {
    const Plane_point tile{std::floor(c.at.front()[0]), std::floor(c.at.front()[1])};
    for (Plane_point& p : c.at) { p = p + tile; }
  }
  BOOST_TEST(least_distance(charts) >= 2. / 24);
  BOOST_TEST(tiles.size() == 14u);
  BOOST_TEST((tiles.count({3, 1}) == 1u));
  BOOST_TEST(filled == covered / 14, boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(a_chart_fits_into_the_bay_of_another)
{
  const Pixels bay(10, 10, [](int x, int y) { return x < 2 || x > 7 || y < 2; }),
    plug(5, 7, [](int, int) { return true; });
  std::vector<Chart> charts{plug.chart(), bay.chart()};
  const double filled = pack_charts(charts);
  BOOST_TEST(filled > 0.85 * (bay.chart().area + plug.chart().area) / 100);
  for (int k = 0; k < 2; ++k)
  {
    const auto extent = [&](const Chart& c) {
      const auto [low, high] = std::minmax_element(
        c.at.begin(), c.at.end(), [&](const Plane_point& p, const Plane_point& q) { return p[k] < q[k]; });
      return std::array<double, 2>{(*low)[k], (*high)[k]};
    };
    BOOST_TEST(extent(charts[0])[0] >= extent(charts[1])[0]);
    BOOST_TEST(extent(charts[0])[1] <= extent(charts[1])[1]);
  }
}

// The size of images says nothing; what charts have on the surface does.
BOOST_AUTO_TEST_CASE(the_size_of_images_does_not_matter)
{
  const Pixels small(4, 9, [](int x, int y) { return x > 0 || y < 3; }),
    large(
      4, 9, [](int x, int y) { return x > 0 || y < 3; }, 1024);
  const Pixels other(7, 3, [](int, int) { return true; });
  std::vector<Chart> a{small.chart(), other.chart()}, b{large.chart(), other.chart()};
  b[0].area = a[0].area;
  pack_charts(a);
  pack_charts(b);
  BOOST_TEST((a[0].at == b[0].at));
  BOOST_TEST((a[1].at == b[1].at));
}

BOOST_AUTO_TEST_CASE(one_chart_lies_in_the_smallest_square)
{
  for (const double angle : {0., 0.4, 1.1})
  {
    Pixels strip(40, 2, [](int, int) { return true; });
    for (Plane_point& p : strip.at)
    {
      p = {p[0] * std::cos(angle) - p[1] * std::sin(angle), p[0] * std::sin(angle) + p[1] * std::cos(angle)};
    }
    std::vector<Chart> charts{strip.chart()};
    // a strip lies along the diagonal: length + width are the diagonal of its square
    BOOST_TEST(pack_charts(charts) == 80 / (42. * 42 / 2), boost::test_tools::tolerance(5e-3)); // by degrees
  }
}

// The place that is found is the best of all, by trying each cell.
BOOST_AUTO_TEST_CASE(an_atlas_finds_the_best_place_there_is)
{
  std::mt19937 random(7);
  for (int trial = 0; trial < 6; ++trial)
  {
    constexpr int size = 70; // more than the bits of a word
    const int gap = trial % 3;
    internal::Atlas atlas(size, {gap, gap});
    std::vector<char> is_taken(size * size, 0);
    int extent = 0;
    for (int i = 0; i < 12; ++i)
    {
      const int width = 1 + static_cast<int>(random() % 30), height = 1 + static_cast<int>(random() % 30);
      const unsigned holes = 2 + random() % 5;
      const Pixels shape(
        width, height, [&](int x, int y) { return x == 0 || y == 0 || (x * 7 + y * 3) % holes > 0; }, 0.99);
      const internal::Chart_cells cells = internal::cells_of(shape.triangles, shape.at);
      std::optional<std::array<int, 3>> best; // extent, then how far from the corner
      for (int y = 0; y + cells.height <= size; ++y)
        for (int x = 0; x + cells.width <= size; ++x)
        {
          const bool is_free = std::all_of(cells.runs.begin(), cells.runs.end(), [&](const auto& run) {
            const auto row = is_taken.begin() + (y + run.row) * size + x;
            return std::find(row + run.begin, row + run.end, 1) == row + run.end;
          });
          if (!is_free) { continue; }
          const std::array<int, 3> place{std::max({extent, x + cells.width, y + cells.height}), x + y, y};
          if (!best || place < *best) { best = place; }
        }
      const auto found = atlas.find_place(cells, std::nullopt, {});
      BOOST_TEST_REQUIRE(found.has_value() == best.has_value());
      if (!found) { continue; }
      BOOST_TEST(found->extent == (*best)[0]);
      BOOST_TEST(found->x + found->y == (*best)[1]);
      atlas.take(cells, *found);
      extent = found->extent;
      for (const auto& [x, y] : cells_in(cells, found->x, found->y))
        for (int dy = -gap; dy <= gap; ++dy)
          for (int dx = -gap; dx <= gap; ++dx)
          {
            if (std::min(x + dx, y + dy) >= 0 && std::max(x + dx, y + dy) < size)
            {
              is_taken[(y + dy) * size + x + dx] = 1;
            }
          }
    }
  }
}

// The border of a chart says the same as all its triangles: with holes, overlapping itself, mirrored, with a triangle
// without area that sticks out.
BOOST_AUTO_TEST_CASE(cells_within_a_border_are_those_of_its_triangles)
{
  const auto ring = [](int x, int y) { return x < 2 || y < 2 || x > 6 || y > 4; };
  const auto comb = [](int x, int y) { return y < 1 || x % 2 == 0; };
  for (const auto& is_filled : {std::function<bool(int, int)>(ring), std::function<bool(int, int)>(comb)})
    for (int i = 0; i < 40; ++i)
    {
      Pixels shape(9, 7, is_filled);
      const double angle = 0.31 * i, size = 0.3 + 0.21 * i;
      for (Plane_point& p : shape.at)
      {
        const double bent = i % 4 == 3 ? 0.6 * p[0] : 0; // rolled up, over itself
        p = {size * (std::cos(angle + bent) * (p[0] + 3) - std::sin(angle + bent) * p[1]),
             size * (std::sin(angle + bent) * (p[0] + 3) + std::cos(angle + bent) * p[1])};
        if (i % 2 == 1) { std::swap(p[0], p[1]); }
      }
      Plane_point low = shape.at.front();
      for (const Plane_point& p : shape.at) { low = {std::min(low[0], p[0]), std::min(low[1], p[1])}; }
      for (Plane_point& p : shape.at) { p = p - low; }
      if (i % 5 == 0)
      {
        const auto n = static_cast<Index>(shape.at.size());
        shape.at.push_back({30.5, 2.25});
        shape.at.push_back({31.5, 2.25});
        shape.at.push_back({33.5, 2.25});
        shape.triangles.push_back({n, n + 1, n + 2});
      }
      const auto border = internal::border_of(shape.triangles, shape.at);
      BOOST_TEST_CONTEXT(i)
      {
        if (border.empty()) // rolled up too tightly: some are turned over
        {
          BOOST_TEST(i % 4 == 3);
          continue;
        }
        BOOST_TEST((cells_in(internal::cells_within(border, shape.at), 0, 0)
                    == cells_in(internal::cells_of(shape.triangles, shape.at), 0, 0)));
      }
    }
  const std::vector<Plane_point> kite{{0, 0}, {1, 0}, {1, 1}, {0.5, 0.2}};
  BOOST_TEST(internal::border_of({{0, 1, 2}, {0, 2, 3}}, kite).empty() == true); // one is turned over
  BOOST_TEST(internal::border_of({{0, 1, 2}}, kite).size() == 3u);
}

// Every cell that a triangle has a point in, and of a thin one no other than those beside it.
BOOST_AUTO_TEST_CASE(cells_hold_all_that_a_triangle_touches)
{
  std::mt19937 random(3);
  const auto number = [&] { return 20 * static_cast<double>(random()) / 4294967296.; };
  for (int trial = 0; trial < 50; ++trial)
  {
    const std::vector<Plane_point> at{{number(), number()}, {number(), number()}, {number(), number()}};
    const auto cells = cells_in(internal::cells_of({{0, 1, 2}}, at), 0, 0);
    std::set<std::array<int, 2>> touched;
    for (int i = 0; i <= 200; ++i)
      for (int j = 0; i + j <= 200; ++j)
      {
        const Plane_point p = (i / 200.) * at[0] + (j / 200.) * at[1] + ((200 - i - j) / 200.) * at[2];
        touched.insert({static_cast<int>(std::floor(p[0])), static_cast<int>(std::floor(p[1]))});
      }
    for (const auto& c : touched) { BOOST_TEST(cells.count(c) == 1u); }
    BOOST_TEST(cells.size() <= touched.size() + 20);
  }
}
