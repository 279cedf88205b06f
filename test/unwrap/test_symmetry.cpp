// Surfaces that are their own mirror images.
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

#include "support/pipeline.h"
#include "support/sample_surfaces.h"

#include <meridian/base/exceptions.h>
#include <meridian/base/vectors.h>
#include <meridian/result/recount.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/find_mirror.h>
#include <meridian/surface/measures.h>
#include <meridian/unwrap/Unwrapping.h>
#include <meridian/unwrap/pack_unwrappings.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <set>
#include <vector>

namespace data = boost::unit_test::data;
using namespace meridian;

namespace {

// Half of a surface, on the side where x is positive, and its mirror image, joined where x is 0.
Triangle_surface doubled(const Triangle_surface& s)
{
  constexpr double near = 1e-9;
  const auto is_away = [&](Index f) {
    const auto& t = s.triangles[f];
    return s.points[t[0]][0] + s.points[t[1]][0] + s.points[t[2]][0] < 0;
  };
  const Triangle_surface half = sample::without(s, is_away);
  Triangle_surface both;
  both.points = half.points;
  std::vector<Index> image;
  for (Index v = 0; v < half.number_of_vertices(); ++v)
  {
    if (std::abs(half.points[v][0]) < near)
    {
      image.push_back(v);
      continue;
    }
    image.push_back(static_cast<Index>(both.points.size()));
    const Point p = half.points[v];
    both.points.push_back({-p[0], p[1], p[2]});
  }
  both.triangles = half.triangles;
  for (const auto& t : half.triangles) { both.triangles.push_back({image[t[2]], image[t[1]], image[t[0]]}); }
  return sample::connected(std::move(both));
}

Triangle_surface sample_of(int which)
{
  switch (which)
  {
  case 0: return doubled(sample::sphere(4));
  case 1: return doubled(sample::torus(40, 20));
  case 2: return doubled(sample::punctured(sample::torus(40, 20), {45})); // two holes
  case 3: return doubled(sample::dumbbell(6, 32));
  default: // edges along the plane of very different length
  {
    Triangle_surface s = sample::sphere(4);
    for (Point& p : s.points)
    {
      const double angle = std::atan2(p[2], p[1]), r = std::hypot(p[1], p[2]), turned = angle + 0.9 * std::sin(angle);
      p = {p[0], r * std::cos(turned), r * std::sin(turned)};
    }
    return doubled(s);
  }
  }
}

Index vertex_at(const Triangle_surface& s, const Point& p)
{
  Index best = 0;
  for (Index v = 0; v < s.number_of_vertices(); ++v)
  {
    if (norm(s.points[v] - p) < norm(s.points[best] - p)) { best = v; }
  }
  return best;
}

// The reflection in the plane of a mirror.
Point reflected(const Mirror& m, const Point& p) { return p - (2 * dot(p - m.origin, m.normal)) * m.normal; }

Unwrapping unwrapped(const Triangle_surface& s, int charts = 1)
{
  Unwrap_options options;
  options.charts = charts;
  options.is_symmetric = true;
  return pipeline::unwrap(s, options);
}

// Seams and maps of faces are those of their images. The images are looked for anew.
void check_symmetric(const Triangle_surface& s, const Unwrapping& u, const Mirror& m)
{
  const Verification recount = verify_charts(s, u.cut);
  BOOST_TEST(recount.failures.size() == 0u, pipeline::first_failure(recount));
  BOOST_TEST(u.map.flipped.empty());
  BOOST_TEST(u.cut.surface.number_of_faces() == s.number_of_faces());
  std::vector<Index> image;
  for (const Point& p : s.points) { image.push_back(vertex_at(s, reflected(m, p))); }
  std::set<std::array<Index, 2>> seams, images;
  for (const auto& [h, g] : u.cut.opened.seams)
  {
    const Index v = s.source(h), w = s.target(h);
    seams.insert({std::min(v, w), std::max(v, w)});
    images.insert({std::min(image[v], image[w]), std::max(image[v], image[w])});
  }
  BOOST_TEST((seams == images));
  const auto length_in_plane = [&](Index h) {
    const auto& t = u.disc.triangles[h / 3];
    return norm(u.map.at[t[h % 3]] - u.map.at[t[(h + 1) % 3]]);
  };
  int wrong = 0;
  for (Index h = 0; h < s.number_of_halfedges(); ++h)
  {
    const Index g = s.find_halfedge(image[s.target(h)], image[s.source(h)]);
    BOOST_TEST_REQUIRE(g >= 0);
    wrong += !(std::abs(length_in_plane(h) - length_in_plane(g)) < 1e-9 * (1 + length_in_plane(h)));
  }
  BOOST_TEST(wrong == 0);
}

} // namespace

BOOST_DATA_TEST_CASE(a_mirror_is_found_whatever_the_numbers, data::xrange(5), which)
{
  const Triangle_surface first = sample_of(which);
  for (const Triangle_surface& s : {first, sample::renumbered(sample::rotated(first, 0.3, 1.1), 5)})
  {
    const auto m = find_mirror(s);
    BOOST_TEST_REQUIRE(m.has_value());
    BOOST_TEST(norm(m->normal) == 1, boost::test_tools::tolerance(1e-12));
    for (Index v = 0; v < s.number_of_vertices(); ++v)
    {
      BOOST_TEST(norm(reflected(*m, s.points[v]) - s.points[m->vertex[v]]) < 1e-6);
    }
    for (Index h = 0; h < s.number_of_halfedges(); ++h)
    {
      BOOST_TEST(s.source(m->halfedge[h]) == m->vertex[s.target(h)]);
      BOOST_TEST(s.target(m->halfedge[h]) == m->vertex[s.source(h)]);
    }
    std::set<Index> on_line;
    for (Index h : m->line) { on_line.insert({s.source(h), s.target(h)}); }
    for (Index v = 0; v < s.number_of_vertices(); ++v) { BOOST_TEST((m->vertex[v] == v) == (on_line.count(v) == 1)); }
  }
}

// By triangles, not by shape; and where edges are in the plane.
BOOST_AUTO_TEST_CASE(what_is_no_mirror_image_has_none)
{
  BOOST_TEST(!find_mirror(sample::noisy(sample_of(1), 0.05, 2)));
  BOOST_TEST(!find_mirror(sample::torus(40, 20))); // its diagonals all lean the same way
  Triangle_surface tetrahedron;                    // whose planes go through the middle of an edge
  tetrahedron.points = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  tetrahedron.triangles = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
  BOOST_TEST(!find_mirror(sample::connected(tetrahedron)));
  const Triangle_surface s = sample::noisy(sample_of(1), 0.05, 2);
  const Unwrapping u = unwrapped(s);
  BOOST_TEST(!u.is_symmetric);
  BOOST_TEST((u.map.at == pipeline::unwrap(s, Unwrap_options()).map.at));
}

BOOST_DATA_TEST_CASE(seams_and_charts_are_mirror_images, data::xrange(5) * data::make({1, 0, 4}), which, charts)
{
  const Triangle_surface s = sample_of(which);
  const auto m = find_mirror(s);
  BOOST_TEST_REQUIRE(m.has_value());
  const Unwrapping u = unwrapped(s, charts);
  BOOST_TEST(u.is_symmetric);
  check_symmetric(s, u, *m);
  if (charts == 1) { BOOST_TEST(u.charts == 1u); } // halves that stay together
  if (charts == 4) { BOOST_TEST(u.charts == 4u); }
  if (charts == 0) { BOOST_TEST(u.map.distortion.stretch_l2 <= default_max_stretch_of_charts); }
}

// A flat sheet with holes: sides of its slits lie on each other, and stay there, lest one half's open otherwise.
BOOST_AUTO_TEST_CASE(charts_are_mirror_images_when_they_are_packed)
{
  const auto sheet = sample::sheet(24, 24, [](double x, double y) { return Point{2 * x - 1, 2 * y - 1, 0}; });
  const Triangle_surface s = doubled(sample::punctured(sheet, {25 * 12 + 20, 25 * 5 + 17, 25 * 19 + 15}));
  const auto m = find_mirror(s);
  BOOST_TEST_REQUIRE(m.has_value());
  Unwrap_options options;
  options.is_symmetric = true;
  options.max_stretch = 0;
  std::vector<Unwrapping> packed{pipeline::unwrap(s, options)};
  BOOST_TEST_REQUIRE(packed[0].is_symmetric);
  Pack_options wide;
  wide.padding = 16;
  pack_unwrappings(packed, {1.}, wide);
  check_symmetric(s, packed[0], *m);
  packed[0].is_symmetric = false; // then they are opened
  const auto closed = packed[0].map.at;
  pack_unwrappings(packed, {1.}, wide);
  BOOST_TEST((packed[0].map.at != closed));
}

// The half sphere on either side is flat enough for 1.1, both together are not for less.
BOOST_AUTO_TEST_CASE(halves_come_apart_if_the_stretch_asks_for_it)
{
  const Triangle_surface s = sample_of(0);
  Unwrap_options options;
  options.is_symmetric = true;
  const Unwrapping together = pipeline::unwrap(s, options);
  options.max_stretch = together.map.distortion.stretch_l2 - 1e-3;
  const Unwrapping apart = pipeline::unwrap(s, options);
  BOOST_TEST(apart.map.distortion.stretch_l2 <= *options.max_stretch);
  BOOST_TEST(apart.is_symmetric);
  check_symmetric(s, apart, *find_mirror(s));
}

BOOST_AUTO_TEST_CASE(choices_that_do_not_go_with_mirror_images_are_refused)
{
  const Triangle_surface s = sample_of(1);
  const auto refused = [&](const std::function<void(Unwrap_options&)>& change) {
    Unwrap_options options;
    options.is_symmetric = true;
    change(options);
    BOOST_CHECK_THROW(pipeline::unwrap(s, options), Invalid_input_error);
  };
  refused([](Unwrap_options& o) { o.seams = {5}; });
  refused([](Unwrap_options& o) { o.keep_out = {5}; });
  refused([](Unwrap_options& o) { o.family = 2; });
  refused([](Unwrap_options& o) { o.stretch_weight = 0.5; });
  refused([](Unwrap_options& o) { o.image_size = 33; });
  refused([](Unwrap_options& o) { o.cut.tightening = Tightening::GRAPH; });
}
