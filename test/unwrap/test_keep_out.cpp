// Seams that keep out of faces.
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

#include "support/pipeline.h"
#include "support/sample_surfaces.h"

#include <meridian/base/exceptions.h>
#include <meridian/base/vectors.h>
#include <meridian/cut/Cut.h>
#include <meridian/cut/keep_out.h>
#include <meridian/result/recount.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/measures.h>
#include <meridian/unwrap/Unwrapping.h>

#include <array>
#include <cmath>
#include <functional>
#include <set>
#include <vector>

namespace data = boost::unit_test::data;
using namespace meridian;

namespace {

Point centre(const Triangle_surface& s, Index f)
{
  const auto& t = s.triangles[f];
  return (1. / 3) * (s.points[t[0]] + s.points[t[1]] + s.points[t[2]]);
}

std::vector<Index> faces_where(const Triangle_surface& s, const std::function<bool(const Point&)>& is_inside)
{
  std::vector<Index> faces;
  for (Index f = 0; f < s.number_of_faces(); ++f)
  {
    if (is_inside(centre(s, f))) { faces.push_back(f); }
  }
  return faces;
}

// Faces around a vertex.
std::vector<Index> ball(const Triangle_surface& s, Index v, double radius)
{
  const Point middle = s.points[v];
  return faces_where(s, [&](const Point& p) { return norm(p - middle) < radius; });
}

// V - E + F of some faces with their corners and sides.
int euler_characteristic(const Triangle_surface& s, const std::vector<Index>& faces)
{
  std::set<Index> vertices;
  std::set<std::array<Index, 2>> edges;
  for (Index f : faces)
    for (Index h = 3 * f; h < 3 * f + 3; ++h)
    {
      vertices.insert(s.source(h));
      edges.insert({std::min(s.source(h), s.target(h)), std::max(s.source(h), s.target(h))});
    }
  return static_cast<int>(vertices.size()) - static_cast<int>(edges.size()) + static_cast<int>(faces.size());
}

// The length of seams between parts of such faces, from the faces that were doubled.
double length_inside(const Unwrapping& u, const std::vector<Index>& faces)
{
  const std::set<Index> all(faces.begin(), faces.end());
  const Refined_surface& s = u.cut.surface;
  double sum = 0;
  for (const auto& [h, g] : u.cut.opened.seams)
  {
    if (all.count(s.face_of[h / 3]) && all.count(s.face_of[g / 3])) { sum += s.length(h); }
  }
  return sum;
}

Unwrapping unwrapped(const Triangle_surface& s, const std::vector<Index>& faces, bool on_edges = false, int charts = 1)
{
  Unwrap_options options;
  options.keep_out = faces;
  options.cut.on_edges = on_edges;
  options.charts = charts;
  return pipeline::unwrap(s, options);
}

void check(const Triangle_surface& s, const Unwrapping& u)
{
  const Verification recount = verify_charts(s, u.cut);
  BOOST_TEST(recount.failures.size() == 0u, pipeline::first_failure(recount));
  BOOST_TEST(u.map.flipped.empty());
  BOOST_TEST(static_cast<std::size_t>(sample::euler_characteristic(u.disc)) == u.charts);
}

Index nearest(const Triangle_surface& s, const Point& p)
{
  Index best = 0;
  for (Index v = 0; v < s.number_of_vertices(); ++v)
  {
    if (norm(s.points[v] - p) < norm(s.points[best] - p)) { best = v; }
  }
  return best;
}

} // namespace

// A cut need not go through a disc: whatever it crosses there can go around.
BOOST_DATA_TEST_CASE(no_seam_goes_over_a_disc, data::make({false, true}) * data::make({1, 3}), on_edges, charts)
{
  const Triangle_surface surfaces[] = {sample::sphere(4), sample::noisy(sample::torus(40, 20), 0.05, 1),
                                       sample::plate(2, 6),
                                       sample::punctured(sample::noisy(sample::torus(40, 20), 0.05, 2), {100, 433})};
  for (const Triangle_surface& s : surfaces)
  {
    int checked = 0;
    for (const Index v : {7, 150, 390})
    {
      const double radius = 0.3 * std::sqrt(area(s) / 3.14);
      const std::vector<Index> faces = ball(s, v, radius);
      if (euler_characteristic(s, faces) != 1) { continue; }
      BOOST_TEST_CONTEXT("surface " << &s - surfaces << ", vertex " << v << ", faces " << faces.size())
      {
        BOOST_TEST_REQUIRE(faces.size() > 10u);
        const Unwrapping u = unwrapped(s, faces, on_edges, charts);
        check(s, u);
        BOOST_TEST(length_inside(u, faces) == 0);
        BOOST_TEST(seam_length_inside(u.cut.surface, mark_faces(s, faces)) == 0);
      }
      ++checked;
    }
    BOOST_TEST(checked > 0);
  }
}

// One edge that is given opens nothing of a ball; what does goes elsewhere than into what is kept out of.
BOOST_DATA_TEST_CASE(seams_that_are_given_do_not_lead_there, data::make({false, true}), on_edges)
{
  const Triangle_surface s = sample::noisy(sample::sphere(4), 0.002, 3);
  const Index tip = nearest(s, {0, 0, 1});
  Unwrap_options options;
  options.cut.on_edges = on_edges;
  options.seams = {s.outgoing[tip]};
  options.keep_out = faces_where(s, [](const Point& p) { return p[2] < -0.3; });
  BOOST_TEST_REQUIRE(euler_characteristic(s, options.keep_out) == 1);
  const Unwrapping u = pipeline::unwrap(s, options);
  check(s, u);
  BOOST_TEST(length_inside(u, options.keep_out) == 0);
}

BOOST_DATA_TEST_CASE(no_seam_goes_over_one_of_several_discs, data::make({false, true}), on_edges)
{
  const Triangle_surface s = sample::torus(60, 30);
  std::vector<Index> faces;
  for (int i = 0; i < 6; ++i)
  {
    const double angle = i * 3.14159 / 3;
    const Point middle{3 * std::cos(angle), 3 * std::sin(angle), 1};
    for (Index f : faces_where(s, [&](const Point& p) { return norm(p - middle) < 0.9; })) { faces.push_back(f); }
  }
  BOOST_TEST_REQUIRE(euler_characteristic(s, faces) == 6);
  const Unwrapping u = unwrapped(s, faces, on_edges);
  check(s, u);
  BOOST_TEST(length_inside(u, faces) == 0);
}

// Links that meet others, and look for another way.
BOOST_DATA_TEST_CASE(many_links_go_around, data::make({false, true}), on_edges)
{
  const Triangle_surface ball = sample::noisy(sample::sphere(4), 0.002, 3);
  std::vector<Index> holes, wall;
  for (int i = 0; i < 14; ++i)
  {
    const double angle = 0.4 * i, up = i % 2 == 0 ? 0.2 : -0.2;
    holes.push_back(nearest(ball, {std::cos(angle), std::sin(angle), up}));
  }
  const Triangle_surface s = sample::punctured(ball, holes);
  wall = faces_where(s, [](const Point& p) { return std::abs(p[2]) < 0.08 && (p[0] > -0.5 || p[1] > 0); });
  BOOST_TEST_REQUIRE(boundary_loops(s).size() == 14u);
  BOOST_TEST_REQUIRE(euler_characteristic(s, wall) == 1);
  const Unwrapping u = unwrapped(s, wall, on_edges);
  check(s, u);
  BOOST_TEST(length_inside(u, wall) == 0);
}

// Two holes near each other, and a wall between them.
BOOST_DATA_TEST_CASE(links_go_around, data::make({false, true}), on_edges)
{
  const Triangle_surface ball = sample::noisy(sample::sphere(5), 0.002, 3);
  const Triangle_surface s = sample::punctured(ball, {nearest(ball, {1, 0, 0.25}), nearest(ball, {1, 0, -0.25})});
  BOOST_TEST_REQUIRE(boundary_loops(s).size() == 2u);
  const std::vector<Index> wall =
    faces_where(s, [](const Point& p) { return std::abs(p[2]) < 0.1 && p[0] > 0 && std::abs(p[1]) < 0.6; });
  BOOST_TEST_REQUIRE(euler_characteristic(s, wall) == 1);
  Unwrap_options options;
  options.cut.on_edges = on_edges;
  options.max_stretch = 0; // the link alone
  const Unwrapping through = pipeline::unwrap(s, options);
  options.keep_out = wall;
  const Unwrapping around = pipeline::unwrap(s, options);
  check(s, around);
  BOOST_TEST(length_inside(through, wall) > 0.1);
  BOOST_TEST(length_inside(around, wall) == 0);
  BOOST_TEST(around.cut.length > 1.2);                    // there and back
  BOOST_TEST(around.cut.length < (on_edges ? 2.2 : 1.7)); // no farther
}

// A closed surface is opened between vertices far apart: its tips, if nothing keeps out of them.
BOOST_DATA_TEST_CASE(tips_are_kept_out_of, data::make({false, true}), on_edges)
{
  Triangle_surface s = sample::sphere(4);
  for (Point& p : s.points) { p[2] *= 5; }
  const std::vector<Index> tips = faces_where(s, [](const Point& p) { return std::abs(p[2]) > 3; });
  BOOST_TEST_REQUIRE(euler_characteristic(s, tips) == 2);
  Unwrap_options options;
  options.cut.on_edges = on_edges;
  options.max_stretch = 0;
  BOOST_TEST_REQUIRE(length_inside(pipeline::unwrap(s, options), tips) > 1);
  options.keep_out = tips;
  const Unwrapping u = pipeline::unwrap(s, options);
  check(s, u);
  BOOST_TEST(length_inside(u, tips) == 0);
}

// The arc that divides a strip evenly is in the middle.
BOOST_DATA_TEST_CASE(arcs_keep_out_too, data::make({false, true}), on_edges)
{
  const Triangle_surface s = sample::sheet(40, 10, [](double x, double y) { return Point{40 * x, 10 * y, 0}; });
  const std::vector<Index> middle = faces_where(s, [](const Point& p) { return std::abs(p[0] - 20) < 6; });
  Unwrap_options options;
  options.cut.on_edges = on_edges;
  options.charts = 2;
  BOOST_TEST_REQUIRE(length_inside(pipeline::unwrap(s, options), middle) > 5);
  const Unwrapping u = unwrapped(s, middle, on_edges, 2);
  check(s, u);
  BOOST_TEST(u.charts == 2u);
  BOOST_TEST(length_inside(u, middle) == 0);
  BOOST_TEST(unwrapped(s, faces_where(s, [](const Point&) { return true; }), on_edges, 2).charts == 1u);
}

// Where a cut has to go through, it goes through once: a meridian beside the band, and a link across it.
BOOST_DATA_TEST_CASE(a_band_around_a_handle_is_crossed_once, data::make({false, true}), on_edges)
{
  const Triangle_surface s = sample::torus(60, 30);
  const std::vector<Index> band = faces_where(s, [](const Point& p) { return p[0] > 0 && std::abs(p[1]) < 0.8; });
  BOOST_TEST_REQUIRE(euler_characteristic(s, band) == 0);
  const Unwrapping u = unwrapped(s, band, on_edges);
  check(s, u);
  const double inside = length_inside(u, band);
  BOOST_TEST(inside > 1); // its width is 1.6
  BOOST_TEST(inside < 2.5);
  BOOST_TEST(seam_length_inside(u.cut.surface, mark_faces(s, band)) == inside, boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(what_encloses_all_is_opened)
{
  const Triangle_surface s = sample::torus(24, 12);
  const std::vector<char> all(s.number_of_faces(), 1), none(s.number_of_faces(), 0);
  BOOST_TEST((open_kept_out(s, all) == none)); // the surface has no other faces
  BOOST_TEST((open_kept_out(s, none) == none));
  const std::vector<char> disc = mark_faces(s, ball(s, 30, 1));
  BOOST_TEST((open_kept_out(s, disc) == disc));

  const std::vector<Index> band = faces_where(s, [](const Point& p) { return p[0] > 0 && std::abs(p[1]) < 1.2; });
  std::vector<Index> left;
  const std::vector<char> opened = open_kept_out(s, mark_faces(s, band));
  for (Index f = 0; f < s.number_of_faces(); ++f)
  {
    if (opened[f]) { left.push_back(f); }
  }
  BOOST_TEST(left.size() < band.size());
  BOOST_TEST(2 * left.size() > band.size());
  BOOST_TEST(euler_characteristic(s, left) == 1);

  std::vector<Index> faces;
  for (Index f = 0; f < s.number_of_faces(); ++f) { faces.push_back(f); }
  const Unwrapping u = unwrapped(s, faces);
  check(s, u);
  BOOST_TEST(length_inside(u, faces) == u.cut.length, boost::test_tools::tolerance(1e-9));
}

// What a map would gain most from.
BOOST_AUTO_TEST_CASE(extensions_keep_out_too)
{
  const Triangle_surface s = sample::thorny_torus();
  Unwrap_options options;
  const Unwrapping free = pipeline::unwrap(s, options);
  BOOST_TEST_REQUIRE(free.extended > 0u);
  Index tip = 0;
  for (Index v = 0; v < s.number_of_vertices(); ++v)
  {
    if (norm(s.points[v]) > norm(s.points[tip])) { tip = v; }
  }
  const std::vector<Index> thorn = ball(s, tip, 19);
  BOOST_TEST_REQUIRE(length_inside(free, thorn) > 1);
  const Unwrapping u = unwrapped(s, thorn);
  check(s, u);
  BOOST_TEST(length_inside(u, thorn) == 0);
  BOOST_TEST(u.map.distortion.stretch_l2 > free.map.distortion.stretch_l2);
}

BOOST_AUTO_TEST_CASE(choices_that_do_not_go_with_faces_to_keep_out_of_are_refused)
{
  const Triangle_surface s = sample::torus(24, 12);
  BOOST_CHECK_THROW(unwrapped(s, {-1}), Invalid_input_error);
  BOOST_CHECK_THROW(unwrapped(s, {s.number_of_faces()}), Invalid_input_error);
  const auto refused = [&](const std::function<void(Unwrap_options&)>& change) {
    Unwrap_options options;
    options.keep_out = {5};
    BOOST_CHECK_NO_THROW(pipeline::unwrap(s, options));
    change(options);
    BOOST_CHECK_THROW(pipeline::unwrap(s, options), Invalid_input_error);
  };
  refused([](Unwrap_options& o) { o.cut.method = By_tree_cotree(); });
  refused([](Unwrap_options& o) { o.cut.tightening = Tightening::GRAPH; });
  refused([](Unwrap_options& o) { o.family = 3; });
  refused([](Unwrap_options& o) { o.stretch_weight = 0.5; });
  refused([](Unwrap_options& o) { o.image_size = 33; });
  refused([](Unwrap_options& o) { o.seams = {-1}; });
  const Triangle_surface open = sample::punctured(s, {30});
  Unwrap_options border;
  border.keep_out = {5};
  border.seams = {boundary_loops(open).front().front()};
  BOOST_CHECK_THROW(pipeline::unwrap(open, border), Invalid_input_error);
}
