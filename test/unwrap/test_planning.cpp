// Where cuts are extended, and what that gains.
#include "support/pipeline.h"
#include "support/sample_surfaces.h"

#include <meridian/base/vectors.h>
#include <meridian/cut/Cut.h>
#include <meridian/proof/verify_cut.h>
#include <meridian/result/recount.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/measures.h>
#include <meridian/surface/open_along.h>
#include <meridian/unwrap/Unwrapping.h>
#include <meridian/unwrap/extend_cut.h>
#include <meridian/unwrap/plan_extensions.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

namespace data = boost::unit_test::data;
using namespace meridian;

namespace {

const double pi = std::acos(-1.);

// The part of the unit sphere up to an angle from the pole, in rings. Vertex 0 is the pole.
Triangle_surface cap(double angle, int rings, int around)
{
  std::vector<Point> points{{0, 0, 1}};
  std::vector<std::array<Index, 3>> faces;
  const auto at = [&](int ring, int k) { return 1 + (ring - 1) * around + (k % around); };
  for (int ring = 1; ring <= rings; ++ring)
    for (int k = 0; k < around; ++k)
    {
      const double polar = angle * ring / rings, turn = 2 * pi * k / around;
      points.push_back({std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn), std::cos(polar)});
      if (ring == 1) { faces.push_back({0, at(1, k), at(1, k + 1)}); }
      else
      {
        faces.push_back({at(ring - 1, k), at(ring, k), at(ring, k + 1)});
        faces.push_back({at(ring - 1, k), at(ring, k + 1), at(ring - 1, k + 1)});
      }
    }
  Triangle_surface s;
  s.points = points;
  s.triangles = faces;
  return sample::connected(std::move(s));
}

// A flat disc with a cone of some height at each of some places.
Triangle_surface with_cones(const std::vector<Plane_point>& places, const std::vector<double>& heights)
{
  auto s = cap(1, 40, 120);
  for (Point& p : s.points)
  {
    const double polar = std::acos(std::min(1., p[2])), r = std::hypot(p[0], p[1]);
    p = r > 0 ? Point{polar * p[0] / r, polar * p[1] / r, 0} : Point{0, 0, 0};
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      const double away = std::hypot(p[0] - places[i][0], p[1] - places[i][1]);
      if (away < 0.2) { p[2] += heights[i] * (1 - away / 0.2); }
    }
  }
  return s;
}

Index nearest(const Triangle_surface& s, const Plane_point& place)
{
  Index best = 0;
  const auto away = [&](Index v) { return std::hypot(s.points[v][0] - place[0], s.points[v][1] - place[1]); };
  for (Index v = 0; v < s.number_of_vertices(); ++v)
  {
    if (away(v) < away(best)) { best = v; }
  }
  return best;
}

Extension_plan plan(const Triangle_surface& disc, double stretch, std::size_t most = 1000)
{
  return plan_extensions(
    disc, [=](double) { return stretch; }, most);
}

} // namespace

// Known answer: on a cap of the sphere, stereographic projection gives u = log(s / s0), where s is the square of the
// cosine of half the angle from the pole, and s0 that at the border; area is uniform in s.
BOOST_DATA_TEST_CASE(the_expected_stretch_of_a_cap_is_known, data::make({0.5, 1., 2., 2.8}), angle)
{
  const double s0 = std::pow(std::cos(angle / 2), 2);
  const int steps = 10000;
  double mean = 0, sum = 0;
  for (int pass = 0; pass < 2; ++pass)
    for (int i = 0; i < steps; ++i)
    {
      const double u = std::log((s0 + (1 - s0) * (i + 0.5) / steps) / s0);
      (pass == 0 ? mean : sum) += (pass == 0 ? u : std::hypot(1, u - mean)) / steps;
    }
  const Extension_plan p = plan(cap(angle, 60, 120), 1e9);
  BOOST_TEST(p.before == std::sqrt(sum), boost::test_tools::tolerance(0.01));
  BOOST_TEST(p.after == p.before);
  BOOST_TEST(p.vertices.empty());
}

BOOST_AUTO_TEST_CASE(nothing_is_planned_for_what_is_flat)
{
  const Extension_plan p = plan(with_cones({}, {}), 1 + 1e-9);
  BOOST_TEST(p.before < 1 + 1e-9);
  BOOST_TEST(p.vertices.empty());
}

// The highest cone comes first; what is planned lowers what is expected, and ends where it was told to.
BOOST_AUTO_TEST_CASE(cuts_are_planned_to_the_highest_cones_first)
{
  const std::vector<Plane_point> places{{0.5, 0}, {-0.25, 0.43}, {-0.25, -0.43}};
  const auto s = with_cones(places, {0.3, 0.6, 0.9});
  std::vector<Index> tips;
  for (const Plane_point& place : places) { tips.push_back(nearest(s, place)); }
  const Extension_plan whole = plan(s, 1, 3);
  BOOST_TEST(whole.vertices == (std::vector<Index>{tips[2], tips[1], tips[0]}), boost::test_tools::per_element());
  double last = whole.before;
  for (std::size_t most = 1; most <= 3; ++most)
  {
    const Extension_plan p = plan(s, 1, most);
    BOOST_TEST(p.vertices.size() == most);
    BOOST_TEST(p.after < last);
    const Extension_plan same = plan(s, p.after); // told to end there
    BOOST_TEST(same.vertices.size() == most);
    last = p.after;
  }
  double told = 0;
  plan_extensions(
    s,
    [&](double before) {
      told = before;
      return 2.;
    },
    9);
  BOOST_TEST(told == whole.before);
  // nothing of it depends on the unit, the numbers of vertices, or a mirror
  for (const Triangle_surface& other : {sample::scaled(s, 1024), sample::mirrored(s)})
  {
    const Extension_plan p = plan(other, 1, 3);
    BOOST_TEST(p.before == whole.before, boost::test_tools::tolerance(1e-9));
    BOOST_TEST(p.vertices == whole.vertices, boost::test_tools::per_element());
  }
  const auto renumbered = sample::renumbered(s, 3);
  const Extension_plan p = plan(renumbered, 1, 3);
  BOOST_TEST(p.after == whole.after, boost::test_tools::tolerance(1e-6));
  for (std::size_t i = 0; i < 3; ++i)
  {
    BOOST_TEST(distance(renumbered.points[p.vertices[i]], s.points[whole.vertices[i]]) < 1e-12);
  }
}

// Of many cones that are much alike, only as many are reached as are needed. They are not quite alike, so that it is
// not rounding that chooses.
BOOST_AUTO_TEST_CASE(no_more_is_planned_than_is_needed)
{
  std::vector<Plane_point> places;
  std::vector<double> angles;
  for (int k = 0; k < 12; ++k)
  {
    places.push_back({0.7 * std::cos(pi * k / 6), 0.7 * std::sin(pi * k / 6)});
    angles.push_back(0.4 + 0.005 * (5 * k % 12));
  }
  const auto s = with_cones(places, angles);
  BOOST_TEST(plan(s, 1, 12).vertices.size() == 12u);
  for (std::size_t most : {1u, 3u, 6u})
  {
    const Extension_plan some = plan(s, 1, most), enough = plan(s, some.after);
    BOOST_TEST(enough.vertices == some.vertices, boost::test_tools::per_element());
    BOOST_TEST(enough.after == some.after, boost::test_tools::tolerance(1e-9));
  }
  BOOST_TEST(plan(s, plan(s, 1, 10).after).vertices.size() <= 11u); // an eighth more at most
}

// A cut is extended to many vertices by one tree: they lie on its seams then, and the disc is one still.
BOOST_DATA_TEST_CASE(a_cut_is_extended_to_many_vertices_at_once, data::make({false, true}), on_edges)
{
  for (const auto& s : {sample::noisy(sample::torus(40, 20), 0.03, 5),
                        sample::punctured(sample::noisy(sample::plate(2, 5), 0.05, 2), {40, 300})})
  {
    Cut cut = pipeline::cut(s, pipeline::tight_curves());
    const double length = cut.length;
    const std::size_t curves = cut.curves.size();
    std::vector<Index> vertices;
    for (Index v = 3; v < s.number_of_vertices(); v += s.number_of_vertices() / 12) { vertices.push_back(v); }
    extend_cut(s, cut, vertices, on_edges);
    for (const auto& failure : verify_cut(s, cut).failures) { BOOST_ERROR(failure); }
    BOOST_TEST(cut.length > length);
    BOOST_TEST(cut.curves.size() > curves);
    BOOST_TEST(cut.curves.size() <= curves + vertices.size());
    for (Index v : vertices)
    {
      bool is_at = cut.surface.is_boundary_vertex(v);
      cut.surface.for_each_outgoing(v, [&](Index h) { is_at = is_at || cut.surface.seam[h]; });
      BOOST_TEST(is_at);
    }
    Cut again = cut;
    extend_cut(s, again, vertices, on_edges); // nothing is left to do
    BOOST_TEST(again.length == cut.length);
  }
}

// Without an option the stretch is at most 1.1 where it can be; with the shortest seams, what is fair stays; and what
// was asked for is reached with more of them.
BOOST_AUTO_TEST_CASE(the_stretch_that_is_asked_for_is_reached)
{
  for (const auto& s : {sample::sphere(4), sample::dumbbell(6), sample::thorny_torus(8)})
  {
    Unwrap_options shortest, lower;
    shortest.max_stretch = 0;
    lower.max_stretch = 1.02;
    const Unwrapping a = pipeline::unwrap(s, shortest), b = pipeline::unwrap(s), c = pipeline::unwrap(s, lower);
    BOOST_TEST(a.map.distortion.stretch_l2 <= 2);
    BOOST_TEST(b.map.distortion.stretch_l2 <= default_max_stretch);
    BOOST_TEST(c.map.distortion.stretch_l2 <= 1.02);
    BOOST_TEST(a.extended <= b.extended);
    BOOST_TEST(b.extended < c.extended);
    BOOST_TEST(b.cut.length < c.cut.length);
    for (const Unwrapping* u : {&a, &b, &c})
    {
      BOOST_TEST(u->map.is_one_to_one);
      BOOST_TEST((u->extended == 0) == u->extensions.empty());
      for (const auto& failure : verify_cut(s, u->cut).failures) { BOOST_ERROR(failure); }
    }
  }
}

// Struts of few faces stretch most of all; what is not asked for is reached there, too, and no further than if it were.
BOOST_AUTO_TEST_CASE(lattices_are_stretched_no_more_than_others)
{
  const auto is_strut = [](int x, int y, int z) { return (x % 2 == 0) + (y % 2 == 0) + (z % 2 == 0) >= 2; };
  const Triangle_surface s = sample::skin({11, 11, 5}, is_strut);
  Unwrap_options shortest, asked;
  shortest.max_stretch = 0;
  asked.max_stretch = default_max_stretch;
  const Unwrapping a = pipeline::unwrap(s, shortest), b = pipeline::unwrap(s), c = pipeline::unwrap(s, asked);
  BOOST_TEST(a.map.distortion.stretch_l2 > default_max_stretch); // or nothing is shown here
  BOOST_TEST(b.map.distortion.stretch_l2 <= default_max_stretch);
  BOOST_TEST(b.map.is_one_to_one);
  BOOST_TEST((b.map.at == c.map.at));
  for (const auto& failure : verify_cut(s, b.cut).failures) { BOOST_ERROR(failure); }
}

// A stretch that cannot be reached ends the search all the same.
BOOST_AUTO_TEST_CASE(a_stretch_that_cannot_be_reached_is_not_looked_for_without_end)
{
  Unwrap_options options;
  options.max_stretch = 1;
  options.extensions = 40;
  const auto s = sample::sphere(3);
  const Unwrapping u = pipeline::unwrap(s, options);
  BOOST_TEST(u.map.is_one_to_one);
  BOOST_TEST(u.map.distortion.stretch_l2 > 1);
  BOOST_TEST(u.extended > 0u);
  BOOST_TEST(u.extended <= 40u);
}
