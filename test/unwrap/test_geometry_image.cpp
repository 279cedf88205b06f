#include "support/implicit_surfaces.h"
#include "support/pipeline.h"
#include "support/sample_surfaces.h"

#include <meridian/base/exceptions.h>
#include <meridian/base/vectors.h>
#include <meridian/cut/Cut.h>
#include <meridian/cut/Cut_options.h>
#include <meridian/map/distortion.h>
#include <meridian/map/map_into_polygon.h>
#include <meridian/map/map_with_low_stretch.h>
#include <meridian/map/planar_map.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/open_along.h>
#include <meridian/surface/seams.h>
#include <meridian/unwrap/geometry_image.h>
#include <meridian/unwrap/internal/square_corners.h>
#include <meridian/unwrap/measure_round_trip.h>
#include <meridian/unwrap/square_border.h>

#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

#include <numeric>
#include <random>
#include <set>

namespace data = boost::unit_test::data;
using namespace meridian;

namespace {

struct Sample
{
  const char* name;
  Triangle_surface surface;
  int genus, boundary_loops;
};

std::ostream& operator<<(std::ostream& out, const Sample& s) { return out << s.name; }

Triangle_surface flat_square(int n)
{
  return sample::sheet(n, n, [](double u, double v) { return Point{u, v, 0}; });
}

// Closed surfaces, one of genus 0, with handles, with boundary, with neither.
const std::vector<Sample>& samples()
{
  static const std::vector<Sample> all{
    {"sphere", sample::sphere(3), 0, 0},
    {"torus", sample::torus(24, 16), 1, 0},
    {"coarse torus", sample::torus(4, 3), 1, 0},
    {"bitorus", sample::bitorus(20), 2, 0},
    {"plate of genus 3", sample::noisy(sample::plate(3, 2), 0.1, 5), 3, 0},
    {"torus with two holes", sample::punctured(sample::torus(24, 16), {5, 200}), 1, 2},
    {"annulus", sample::punctured(sample::sphere(3), {0, 1}), 0, 2},
    {"disc", sample::punctured(sample::sphere(3), {0}), 0, 1},
    {"triangle", sample::connected({{{0, 0, 0}, {3, 0, 0}, {0, 4, 1}}, {{0, 1, 2}}, {}, {}}), 0, 1}};
  return all;
}

struct Image
{
  Cut cut;
  Square_border border;
  Triangle_surface disc;
  std::vector<Plane_point> at;
  Geometry_image image;
};

Image make_image(const Triangle_surface& s, int size, const Cut_options& options = Cut_options())
{
  Image r;
  r.cut = pipeline::cut(s, options);
  r.border = prepare_square_border(s, r.cut, size);
  r.disc = surface_of(r.cut.surface, r.cut.opened);
  r.at = map_with_low_stretch(r.disc, r.border.loop, r.border.points);
  r.image = sample_geometry(r.disc, r.at, r.border);
  return r;
}

int least_size_named(const Triangle_surface& s, const Cut& cut, int size)
{
  Cut copy = cut;
  try
  {
    prepare_square_border(s, copy, size);
  }
  catch (const Invalid_input_error& e)
  {
    const std::string what = e.what(), before = "the least size is ";
    return std::stoi(what.substr(what.find(before) + before.size()));
  }
  return 0;
}

// Edges used by two faces are used once in each direction, recounted from the triangles alone.
bool is_edge_manifold(const Triangle_surface& s)
{
  std::map<std::pair<Index, Index>, int> uses;
  for (const auto& t : s.triangles)
    for (int k = 0; k < 3; ++k)
    {
      if (t[k] == t[(k + 1) % 3]) { return false; }
      ++uses[{t[k], t[(k + 1) % 3]}];
    }
  return std::all_of(uses.begin(), uses.end(), [](const auto& u) { return u.second == 1; });
}

std::size_t pixel_of(const Geometry_image& image, int k)
{
  const auto p = internal::border_pixel(k % (4 * (image.size - 1)), image.size);
  return image.pixel(p[0], p[1]);
}

} // namespace

BOOST_DATA_TEST_CASE(steps_of_the_border_add_up_and_mates_agree, data::make(samples()) * data::make({33, 50}), s, size)
{
  const Image r = make_image(s.surface, size);
  const Square_border& b = r.border;
  const auto n = b.loop.size();
  int steps = 0;
  std::size_t edges = 0;
  for (std::size_t p = 0; p < b.paths.size(); ++p)
  {
    const Border_path& path = b.paths[p];
    steps += path.steps;
    edges += path.size;
    BOOST_TEST(path.steps >= 1);
    BOOST_TEST(b.paths[(p + 1) % b.paths.size()].start == (path.start + path.steps) % b.steps());
    for (Index i = 0; i < path.size; ++i)
    {
      const Index h = b.loop[(path.first + i) % n];
      BOOST_TEST(r.disc.opposite[h] == -1);
      if (path.mate < 0)
      {
        BOOST_TEST(r.cut.surface.opposite[h] == -1);
        continue;
      }
      const Border_path& mate = b.paths[path.mate];
      BOOST_TEST(r.cut.surface.opposite[h] == b.loop[(mate.first + mate.size - 1 - i) % n]);
      BOOST_TEST(mate.steps == path.steps);
      if (i > 0)
      {
        BOOST_TEST(b.along[(path.first + i) % n] + b.along[(mate.first + mate.size - i) % n] == path.steps,
                   boost::test_tools::tolerance(1e-12));
      }
    }
  }
  BOOST_TEST(steps == 4 * (size - 1));
  BOOST_TEST(edges == n);
}

BOOST_DATA_TEST_CASE(the_image_of_the_border_is_the_square_with_its_corners,
                     data::make(samples()) * data::make({33, 50}), s, size)
{
  const Image r = make_image(s.surface, size);
  BOOST_TEST(find_flipped_faces(r.disc.triangles, r.at).size() == 0u);
  BOOST_TEST(r.border.points.front()[0] == 0.);
  BOOST_TEST(r.border.points.front()[1] == 0.);
  int corners = 0;
  double place_before = -1;
  for (std::size_t i = 0; i < r.border.loop.size(); ++i)
  {
    const Plane_point p = r.at[r.disc.source(r.border.loop[i])];
    const bool on_x = p[0] == 0 || p[0] == 1, on_y = p[1] == 0 || p[1] == 1;
    BOOST_TEST((on_x || on_y));
    corners += on_x && on_y;
    const double place = p[1] == 0 ? p[0] : p[0] == 1 ? 1 + p[1] : p[1] == 1 ? 3 - p[0] : 4 - p[1];
    BOOST_TEST(place > place_before);
    place_before = place;
  }
  BOOST_TEST(corners == 4);
  BOOST_TEST(area_of(r.disc.triangles, r.at) == 1, boost::test_tools::tolerance(1e-9));
}

// The surface that was divided is the same: still a disc, of the same area, with curves that run along seams.
BOOST_DATA_TEST_CASE(dividing_edges_keeps_the_cut, data::make(samples()), s)
{
  const auto before = pipeline::cut(s.surface);
  const Image r = make_image(s.surface, 41);
  const auto& t = r.cut.surface;
  BOOST_TEST(sample::euler_characteristic(t) == sample::euler_characteristic(s.surface));
  BOOST_TEST(sample::euler_characteristic(r.disc) == 1);
  BOOST_TEST(boundary_loops(r.disc).size() == 1u);
  BOOST_TEST(seam_length(t) == before.length, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(t.origins.size() == static_cast<std::size_t>(t.number_of_vertices() - s.surface.number_of_vertices()));
  const auto check = [&](const std::vector<Index>& curve, bool is_closed) {
    for (std::size_t i = 0; i + (is_closed ? 0 : 1) < curve.size(); ++i)
    {
      const Index h = t.find_halfedge(curve[i], curve[(i + 1) % curve.size()]);
      BOOST_TEST((h >= 0 && t.seam[h]));
    }
  };
  BOOST_TEST(r.cut.curves.size() == before.curves.size());
  for (const Named_curve& curve : r.cut.curves) { check(curve.vertices, curve.is_closed); }
}

BOOST_AUTO_TEST_CASE(curves_pass_new_vertices_in_order)
{
  const internal::Divided_edges divided{{{2, 5}, {7, 8}}};
  std::vector<Index> there{1, 2, 5}, back{5, 2, 1}, around{5, 1, 2};
  internal::insert_into_curve(divided, there, false);
  internal::insert_into_curve(divided, back, false);
  internal::insert_into_curve(divided, around, true);
  BOOST_TEST((there == std::vector<Index>{1, 2, 7, 8, 5}));
  BOOST_TEST((back == std::vector<Index>{5, 8, 7, 2, 1}));
  BOOST_TEST((around == std::vector<Index>{5, 1, 2, 7, 8}));
}

BOOST_DATA_TEST_CASE(both_sides_of_a_seam_have_the_same_samples, data::make(samples()), s)
{
  int pairs = 0;
  const Image r = make_image(s.surface, 33);
  const auto border = internal::sample_border(r.disc, r.border);
  for (const Border_path& path : r.border.paths)
  {
    if (path.mate < 0) { continue; }
    const Border_path& mate = r.border.paths[path.mate];
    for (int k = 0; k <= path.steps; ++k)
    {
      const int a = (path.start + k) % r.border.steps(), b = (mate.start + mate.steps - k) % r.border.steps();
      ++pairs;
      BOOST_TEST((border[a] == border[b]));
      for (int c = 0; c < 3; ++c)
      {
        BOOST_TEST(r.image.samples[3 * pixel_of(r.image, a) + c] == r.image.samples[3 * pixel_of(r.image, b) + c]);
      }
    }
  }
  BOOST_TEST((pairs > 0) == (s.genus > 0 || s.boundary_loops != 1));
}

// Where the border's samples lie is recounted from the map, which knows nothing of paths: on the edge whose image holds
// the grid point.
BOOST_DATA_TEST_CASE(samples_of_the_border_lie_where_the_map_says, data::make(samples()), s)
{
  const Image r = make_image(s.surface, 33);
  const auto border = internal::sample_border(r.disc, r.border);
  const auto place = [](const Plane_point& p) {
    return p[1] == 0 ? p[0] : p[0] == 1 ? 1 + p[1] : p[1] == 1 ? 3 - p[0] : 4 - p[1];
  };
  const double longest = distance({0, 0, 0}, {7, 3, 1});
  const auto n = r.border.loop.size();
  for (int k = 0; k < r.border.steps(); ++k)
    for (std::size_t i = 0; i < n; ++i)
    {
      const double from = place(r.border.points[i]), to = i + 1 < n ? place(r.border.points[i + 1]) : 4, at = k / 32.;
      if (from > at || to <= at) { continue; }
      BOOST_TEST(distance(border[k], r.disc.point_on(r.border.loop[i], (at - from) / (to - from))) < 1e-9 * longest);
    }
}

BOOST_DATA_TEST_CASE(what_is_made_of_the_image_has_the_topology_of_the_surface,
                     data::make(samples()) * data::make({0, 33, 64, 129}), s, wanted)
{
  const int size = wanted > 0 ? wanted : least_size_named(s.surface, pipeline::cut(s.surface), 1);
  const Image r = make_image(s.surface, size);
  const Remeshed m = remesh_from_image(r.image, &r.border);
  BOOST_TEST(is_edge_manifold(m.surface));
  BOOST_TEST(sample::euler_characteristic(m.surface) == 2 - 2 * s.genus - s.boundary_loops);
  BOOST_TEST(boundary_loops(m.surface).size() == static_cast<std::size_t>(s.boundary_loops));
  BOOST_TEST(m.surface.number_of_faces() + m.faces_left_out == 2 * (size - 1) * (size - 1));
  for (std::size_t p = 0; p < m.vertex_of.size(); ++p)
  {
    if (m.vertex_of[p] >= 0) { BOOST_REQUIRE((m.surface.points[m.vertex_of[p]] == r.image.point(p))); }
  }

  const Remeshed open = remesh_from_image(r.image);
  BOOST_TEST(sample::euler_characteristic(open.surface) == 1);
  BOOST_TEST(open.surface.number_of_vertices() == size * size);
}

// Any orientable gluing of the square's sides closes, wherever its corners lie. The characteristic is counted from the
// word alone.
BOOST_DATA_TEST_CASE(every_gluing_of_the_border_makes_a_closed_surface, data::xrange(200), seed)
{
  std::mt19937 random(seed);
  const int letters = 1 + seed % 7;
  std::vector<int> word, steps(letters, 3), place(letters, -1);
  for (int i = 0; i < letters; ++i) { word.insert(word.end(), 2, i); }
  std::shuffle(word.begin(), word.end(), random);
  for (int extra = 3 * letters % 2 + 2 * static_cast<int>(random() % 6) + (letters < 3 ? 6 : 0); extra > 0; --extra)
  {
    ++steps[random() % letters];
  }
  const int size = 1 + std::accumulate(steps.begin(), steps.end(), 0) / 2;
  Square_border border;
  border.size = size;
  int start = static_cast<int>(random() % border.steps());
  // of path i: 2 i, where it begins, and 2 i + 1; the same number for the same vertex
  std::vector<int> end(2 * word.size());
  std::iota(end.begin(), end.end(), 0);
  const auto unite = [&](int a, int b) {
    a = end[a];
    b = end[b];
    for (int& e : end)
    {
      if (e == b) { e = a; }
    }
  };
  for (std::size_t i = 0; i < word.size(); ++i)
  {
    Border_path path;
    path.start = start;
    path.steps = steps[word[i]];
    path.mate = place[word[i]];
    unite(2 * i + 1, 2 * ((i + 1) % word.size()));
    if (path.mate >= 0)
    {
      border.paths[path.mate].mate = i;
      unite(2 * i, 2 * path.mate + 1);
      unite(2 * i + 1, 2 * path.mate);
    }
    place[word[i]] = i;
    border.paths.push_back(path);
    start = (start + path.steps) % border.steps();
  }
  Geometry_image image;
  image.size = size;
  image.step = 1;
  for (int i = 0; i < 3 * size * size; ++i) { image.samples.push_back(random() % 65536); }
  const Remeshed m = remesh_from_image(image, &border);
  BOOST_TEST(is_edge_manifold(m.surface));
  BOOST_TEST(boundary_loops(m.surface).empty());
  BOOST_TEST(sample::euler_characteristic(m.surface)
             == static_cast<int>(std::set<int>(end.begin(), end.end()).size()) - letters + 1);
  int folded = 0;
  for (const Border_path& path : border.paths)
  {
    const int mate = border.paths[path.mate].start;
    folded += mate == (path.start + path.steps) % border.steps() && mate % (size - 1) == 0; // a free end at a corner
  }
  BOOST_TEST(m.faces_left_out == 2 * folded);
}

// Every method's cut, among them those with many sectors at one vertex and with free ends.
BOOST_DATA_TEST_CASE(every_cut_closes_again, data::xrange(number_of<Cut_method>) * data::xrange(2), method, holes)
{
  Triangle_surface s = sample::bitorus(20);
  if (holes > 0) { s = sample::punctured(s, {100}); }
  Cut_options options;
  options.method = all<Cut_method>()[method];
  const Image r = make_image(s, 65, options);
  const Remeshed m = remesh_from_image(r.image, &r.border);
  BOOST_TEST(find_flipped_faces(r.disc.triangles, r.at).size() == 0u);
  BOOST_TEST(is_edge_manifold(m.surface));
  BOOST_TEST(sample::euler_characteristic(m.surface) == -2 - holes);
  BOOST_TEST(boundary_loops(m.surface).size() == static_cast<std::size_t>(holes));
}

BOOST_DATA_TEST_CASE(a_size_that_is_too_small_is_refused_and_the_least_one_works, data::make(samples()), s)
{
  const auto cut = pipeline::cut(s.surface);
  const int least = least_size_named(s.surface, cut, 2);
  BOOST_TEST(least >= 5);
  BOOST_TEST(least_size_named(s.surface, cut, least - 1) == least);
  Cut copy = cut;
  const auto border = prepare_square_border(s.surface, copy, least);
  BOOST_TEST(border.size == least);
  copy = cut;
  copy.opened.copy_of.clear(); // what is not a disc is refused
  copy.opened.triangles = copy.surface.triangles;
  if (s.genus > 0 || s.boundary_loops != 1)
  {
    BOOST_CHECK_THROW(prepare_square_border(s.surface, copy, 33), Invalid_input_error);
  }
}

// Known answer: the grid of a flat square is its image.
BOOST_AUTO_TEST_CASE(a_flat_square_comes_back_exactly)
{
  const auto s = flat_square(16);
  const Image r = make_image(s, 33);
  // its corners are vertices, and no edge joins two points of one side
  BOOST_TEST(r.disc.number_of_vertices() - s.number_of_vertices() == 0);
  std::set<std::array<int, 2>> seen;
  for (int row = 0; row < 33; ++row)
    for (int column = 0; column < 33; ++column)
    {
      const Point p = r.image.point(r.image.pixel(column, row));
      BOOST_TEST(p[2] == 0.);
      if (column % 32 == 0 && row % 32 == 0)
      {
        seen.insert({static_cast<int>(p[0] + 0.5), static_cast<int>(p[1] + 0.5)});
      }
      for (int c = 0; c < 2; ++c)
        if (column % 32 == 0 || row % 32 == 0)
        {
          const double cells = p[c] * 32;
          BOOST_TEST(std::abs(cells - std::floor(cells + 0.5)) < 32 * 0.501 / 65535); // half a unit of 16 bits
        }
    }
  BOOST_TEST(seen.size() == 4u); // corners at corners
  const Remeshed m = remesh_from_image(r.image, &r.border);
  const Round_trip trip = measure_round_trip(s, m.surface);
  BOOST_TEST(trip.hausdorff < 1. / 65535);
  BOOST_TEST(trip.diagonal == std::sqrt(2.), boost::test_tools::tolerance(1e-12));
}

BOOST_DATA_TEST_CASE(more_samples_come_closer, data::make({1, 3}), which)
{
  const Triangle_surface s = which == 1 ? sample::torus(60, 40) : sample::bitorus(30);
  double last = 0;
  for (int size : {33, 65, 129})
  {
    const Image r = make_image(s, size);
    const Round_trip trip = measure_round_trip(s, remesh_from_image(r.image, &r.border).surface);
    BOOST_TEST_MESSAGE(which << " " << size << " psnr " << trip.psnr << " hausdorff "
                             << trip.hausdorff / trip.diagonal);
    BOOST_TEST(trip.psnr > last + 6); // halving the grid divides the error by four: 12 dB
    last = trip.psnr;
  }
  BOOST_TEST(last > 60);
}

// Known answer: two parallel squares, one of them smaller.
BOOST_AUTO_TEST_CASE(distances_are_those_of_parallel_squares)
{
  const auto s = flat_square(4);
  auto t = s;
  for (Point& p : t.points) { p = {0.5 * p[0], p[1], 0.25}; }
  const Round_trip trip = measure_round_trip(s, t);
  BOOST_TEST(trip.back.largest == 0.25, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(trip.back.rms == 0.25, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(trip.there.largest == std::sqrt(0.25 + 0.0625), boost::test_tools::tolerance(1e-12));
  // the mean of x^2 over [0, 0.5], halved
  BOOST_TEST(trip.there.rms == std::sqrt(0.0625 + 1. / 24), boost::test_tools::tolerance(1e-4));
  BOOST_TEST(trip.psnr == 20 * std::log10(std::sqrt(2.) / trip.there.rms), boost::test_tools::tolerance(1e-9));
  BOOST_TEST(measure_round_trip(s, s).hausdorff < 1e-12);
}

// Reweighting lowers the stretch and turns nothing over, on the circle too.
BOOST_AUTO_TEST_CASE(stretch_is_lowered)
{
  auto s = sample::punctured(sample::sphere(4), {4});
  for (Point& p : s.points) { p[2] *= 3; } // a long one, open at its end
  const auto loops = boundary_loops(s);
  const auto border = place_on_circle(places_along(s, loops.front()));
  double last = 1e300;
  for (int steps : {0, 1, 10})
  {
    const auto at = map_with_low_stretch(s, loops.front(), border, steps);
    BOOST_TEST(find_flipped_faces(s.triangles, at).size() == 0u);
    const double stretch =
      measure_distortion(s.points, s.triangles, at, measure_faces(s.points, s.triangles, at)).stretch_l2;
    BOOST_TEST_MESSAGE("steps " << steps << " stretch " << stretch);
    BOOST_TEST(stretch < 0.9 * last);
    last = stretch;
  }
}

BOOST_AUTO_TEST_CASE(the_same_input_gives_the_same_image)
{
  const auto s = sample::bitorus(20);
  const Image a = make_image(s, 65), b = make_image(s, 65);
  BOOST_TEST((a.image.samples == b.image.samples));
  BOOST_TEST((a.disc.points == b.disc.points));
  BOOST_TEST((remesh_from_image(a.image, &a.border).surface.triangles
              == remesh_from_image(b.image, &b.border).surface.triangles));
}

BOOST_AUTO_TEST_CASE(maps_and_images_that_do_not_fit_are_refused)
{
  const auto s = flat_square(4);
  Image r = make_image(s, 17);
  auto at = r.at;
  for (Plane_point& p : at) { p = {p[0] / 2, p[1]}; }
  BOOST_CHECK_THROW(sample_geometry(r.disc, at, r.border), Invalid_input_error);
  Square_border other = r.border;
  other.size = 18;
  BOOST_CHECK_THROW(remesh_from_image(r.image, &other), Invalid_input_error);
  BOOST_CHECK_THROW(measure_round_trip(s, Triangle_surface()), Invalid_input_error);
}
