// Discs unfolded as if they could pass through themselves, and where they overlap then.
#include <boost/test/unit_test.hpp>

#include "support/sample_surfaces.h"

#include <meridian/base/vectors.h>
#include <meridian/cut/find_arc.h>
#include <meridian/map/find_overlaps.h>
#include <meridian/map/planar_map.h>
#include <meridian/map/unfold_disc.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/insert_curves.h>
#include <meridian/surface/measures.h>
#include <meridian/surface/open_along.h>
#include <meridian/surface/pieces.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

using namespace meridian;

namespace {

const double pi = std::acos(-1.);

// How much the lengths of edges differ in the plane, at most, as a part of them.
double length_error(const Triangle_surface& s, const std::vector<Plane_point>& at)
{
  double most = 0;
  for (Index h = 0; h < s.number_of_halfedges(); ++h)
  {
    most = std::max(most, std::abs(norm(at[s.target(h)] - at[s.source(h)]) / s.length(h) - 1));
  }
  return most;
}

// A strip of length 10 and width 1 in the plane.
Triangle_surface strip(int n = 60, int m = 6)
{
  return sample::sheet(n, m, [](double x, double y) { return Point{10 * x, y, 0}; });
}

// A spiral staircase that goes round so often, so flat that it is all but flat.
Triangle_surface staircase(double turns)
{
  return sample::sheet(static_cast<int>(60 * turns), 6, [&](double x, double y) {
    const double angle = 2 * pi * turns * x, r = 1 + y;
    return Point{r * std::cos(angle), r * std::sin(angle), 0.02 * angle};
  });
}

// The parts of a surface that an arc leaves.
std::vector<Surface_piece> divided(const Triangle_surface& s, const Surface_curve& arc)
{
  Refined_surface refined(s);
  insert_curves(s, refined, {arc});
  return pieces_of(surface_of(refined, open_along(refined)));
}

} // namespace

BOOST_AUTO_TEST_CASE(what_is_flat_unfolds_without_distortion)
{
  const std::array<Triangle_surface, 4> all{
    strip(),
    sample::sheet(40, 9,
                  [](double x, double y) {
                    return Point{std::cos(5 * x), std::sin(5 * x), 2 * y};
                  }),
    sample::sheet(30, 7,
                  [](double x, double y) { // a cone
                    return Point{(1 + y) * std::cos(3 * x), (1 + y) * std::sin(3 * x), 2 * y};
                  }),
    sample::renumbered(strip(), 5)};
  for (const Triangle_surface& s : all)
  {
    const auto at = unfold_disc(s);
    // the chords of a cone's rings are not flat altogether
    BOOST_TEST(length_error(s, at) < (&s == &all[2] ? 1e-3 : 1e-9));
    BOOST_TEST(find_flipped_faces(s.triangles, at).size() == 0u);
    BOOST_TEST(area_of(s.triangles, at) == area(s), boost::test_tools::tolerance(1e-3));
    BOOST_TEST(find_overlaps(s, at).part == 0);
  }
}

// The mean curvature of a part of a sphere must go somewhere; faces stay upright, and their sizes about what they were.
BOOST_AUTO_TEST_CASE(a_curved_disc_keeps_its_area_about)
{
  const Triangle_surface s = sample::without(sample::sphere(4), [&, s4 = sample::sphere(4)](Index f) {
    const auto& t = s4.triangles[f];
    return s4.points[t[0]][2] + s4.points[t[1]][2] + s4.points[t[2]][2] < 1.5; // the part above half of the height
  });
  const auto at = unfold_disc(s);
  BOOST_TEST(find_flipped_faces(s.triangles, at).size() == 0u);
  BOOST_TEST(area_of(s.triangles, at) == area(s), boost::test_tools::tolerance(0.05));
  BOOST_TEST(length_error(s, at) < 0.35);
  // as large as it is small
  const auto larger = unfold_disc(sample::scaled(s, 1024));
  for (std::size_t v = 0; v < at.size(); ++v) { BOOST_TEST(norm(larger[v] - 1024 * at[v]) < 1e-6 * 1024); }
}

BOOST_AUTO_TEST_CASE(a_staircase_overlaps_itself_where_it_comes_round)
{
  for (const double turns : {0.9, 1.5, 1.75})
  {
    const Triangle_surface s = staircase(turns);
    const auto at = unfold_disc(s);
    const Overlaps overlaps = find_overlaps(s, at);
    const double expected = std::max(turns - 1, 0.) / turns;
    BOOST_TEST(std::abs(overlaps.part - expected) < 0.03, turns << ": " << overlaps.part);
    for (const auto& [f, g] : overlaps.faces)
    {
      const auto middle = [&](Index face) {
        const auto& t = s.triangles[face];
        return (1. / 3) * (at[t[0]] + at[t[1]] + at[t[2]]);
      };
      BOOST_TEST(f != g);
      BOOST_TEST(norm(middle(f) - middle(g)) < 0.5);
    }
  }
}

BOOST_AUTO_TEST_CASE(an_image_without_area_is_no_trouble)
{
  const Triangle_surface s = strip(4, 2);
  std::vector<Plane_point> at(s.points.size(), {0, 0});
  BOOST_TEST(find_overlaps(s, at).faces.empty());
  for (std::size_t v = 0; v < at.size(); ++v) { at[v] = {1e9 * s.points[v][0], 1e-9 * s.points[v][1]}; }
  BOOST_TEST(find_overlaps(s, at).faces.size() < 10000u);
}

BOOST_AUTO_TEST_CASE(an_arc_divides_a_strip_across_its_middle)
{
  for (const bool on_edges : {false, true})
    for (const Triangle_surface& s : {strip(), sample::renumbered(strip(), 3)})
    {
      const Surface_curve arc = find_arc(s, {}, on_edges);
      BOOST_TEST_REQUIRE(arc.points.size() > 1u);
      if (!on_edges) { BOOST_TEST(length(s, arc) == 1, boost::test_tools::tolerance(0.02)); }
      for (const Curve_point& p : arc.points) { BOOST_TEST((!on_edges || p.is_vertex())); }
      const auto pieces = divided(s, arc);
      BOOST_TEST_REQUIRE(pieces.size() == 2u);
      if (on_edges) { continue; } // an edge with both ends on the border cuts off a corner
      for (const auto& p : pieces)
      {
        BOOST_TEST(sample::euler_characteristic(p.surface) == 1);
        BOOST_TEST(area(p.surface) == 5, boost::test_tools::tolerance(0.1));
      }
    }
}

// Where the strip is narrow the arc is short, and it is worth to be uneven for that.
BOOST_AUTO_TEST_CASE(an_arc_takes_the_narrow_place)
{
  const Triangle_surface s = sample::sheet(80, 8, [](double x, double y) {
    return Point{10 * x, (std::abs(x - 0.35) < 0.04 ? 0.2 : 1) * (y - 0.5), 0};
  });
  const Surface_curve arc = find_arc(s, {}, false);
  BOOST_TEST(length(s, arc) < 0.25);
  for (const Curve_point& p : arc.points) { BOOST_TEST(std::abs(position(s, p)[0] - 3.5) < 0.5); }
}

// What overlaps comes apart: neither part of a staircase of one and three quarters turns overlaps itself any more, and
// pairs that are all at one end are parted there.
BOOST_AUTO_TEST_CASE(an_arc_parts_what_should_be_apart)
{
  const Triangle_surface s = staircase(1.75);
  const Overlaps overlaps = find_overlaps(s, unfold_disc(s));
  const auto pieces = divided(s, find_arc(s, overlaps.faces, false));
  BOOST_TEST_REQUIRE(pieces.size() == 2u);
  for (const auto& p : pieces) { BOOST_TEST(find_overlaps(p.surface, unfold_disc(p.surface)).part < 0.02); }

  const Triangle_surface flat = strip(80, 6);
  std::vector<std::array<Index, 2>> apart;
  const auto place = [&](Index f) { return flat.points[flat.triangles[f][0]][0]; };
  for (Index f = 0; f < flat.number_of_faces(); ++f)
    for (Index g = 0; g < f; ++g)
    {
      if (std::abs(place(f) - 1) < 0.3 && std::abs(place(g) - 2) < 0.3) { apart.push_back({f, g}); }
    }
  const Surface_curve arc = find_arc(flat, apart, false);
  for (const Curve_point& p : arc.points) { BOOST_TEST(std::abs(position(flat, p)[0] - 1.5) < 0.5); }
}

BOOST_AUTO_TEST_CASE(an_arc_that_is_not_good_gives_way_to_the_next)
{
  const Triangle_surface s = strip();
  int tries = 0;
  const auto far_off = [&](const Surface_curve& arc) {
    ++tries;
    return std::abs(position(s, arc.points.front())[0] - 5) > 0.3;
  };
  const Surface_curve arc = find_arc(s, {}, false, far_off);
  BOOST_TEST_REQUIRE(arc.points.size() > 1u);
  BOOST_TEST(tries > 1);
  BOOST_TEST(far_off(arc));
  BOOST_TEST(find_arc(s, {}, false, [](const Surface_curve&) { return false; }).points.empty());
}

BOOST_AUTO_TEST_CASE(a_face_has_no_arc)
{
  const Triangle_surface one = sample::connected({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}, {}, {}});
  BOOST_TEST(find_arc(one, {}, false).points.empty());
  BOOST_TEST(unfold_disc(one).size() == 3u);
  const Triangle_surface two =
    sample::connected({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {1, 3, 2}}, {}, {}});
  BOOST_TEST(divided(two, find_arc(two, {}, true)).size() == 2u);
}

BOOST_AUTO_TEST_CASE(pieces_are_what_is_connected)
{
  Triangle_surface s = sample::torus(6, 5);
  const Triangle_surface other = strip(5, 2);
  const Index n = s.number_of_vertices();
  for (const auto& t : other.triangles) { s.triangles.push_back({t[0] + n, t[1] + n, t[2] + n}); }
  s.points.insert(s.points.end(), other.points.begin(), other.points.end());
  std::swap(s.triangles.front(), s.triangles.back());
  connect(s);
  const auto pieces = pieces_of(s);
  BOOST_TEST_REQUIRE(pieces.size() == 2u);
  BOOST_TEST(sample::euler_characteristic(pieces[0].surface) == 1); // its face is first now
  BOOST_TEST(sample::euler_characteristic(pieces[1].surface) == 0);
  const auto number = number_pieces(s);
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t f = 0; f < pieces[i].faces.size(); ++f)
    {
      BOOST_TEST(number[pieces[i].faces[f]] == static_cast<Index>(i));
      for (std::size_t k = 0; k < 3; ++k)
      {
        const Index v = pieces[i].surface.triangles[f][k];
        BOOST_TEST(pieces[i].vertices[v] == s.triangles[pieces[i].faces[f]][k]);
        BOOST_TEST((pieces[i].surface.points[v] == s.points[pieces[i].vertices[v]]));
        const Index h = static_cast<Index>(3 * f + k), o = pieces[i].surface.opposite[h];
        const Index whole = s.opposite[3 * pieces[i].faces[f] + k];
        BOOST_TEST((o < 0 ? whole < 0 : 3 * pieces[i].faces[o / 3] + o % 3 == whole));
      }
    }
}
