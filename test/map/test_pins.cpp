// Maps whose vertices are drawn to where they shall be.
#include <boost/test/unit_test.hpp>

#include "support/sample_surfaces.h"

#include <meridian/base/exceptions.h>
#include <meridian/base/vectors.h>
#include <meridian/map/distortion.h>
#include <meridian/map/is_one_to_one.h>
#include <meridian/map/pack_charts.h>
#include <meridian/map/pin_map.h>
#include <meridian/map/planar_map.h>
#include <meridian/proof/verify_packing.h>
#include <meridian/surface/Triangle_surface.h>

#include <array>
#include <vector>

using namespace meridian;

namespace {

// A square of n x n squares, 1 long, and its map as it is.
struct Sheet
{
  Triangle_surface surface;
  std::vector<Plane_point> at;
  explicit Sheet(int n) : surface(sample::sheet(n, n, [](double x, double y) { return Point{x, y, 0}; }))
  {
    for (const Point& p : surface.points) { at.push_back({p[0], p[1]}); }
  }
  double stretch() const
  {
    return measure_distortion(surface.points, surface.triangles, at,
                              measure_faces(surface.points, surface.triangles, at))
      .stretch_l2;
  }
};

void check_there(const Sheet& s, const std::vector<Map_pin>& pins)
{
  for (const Map_pin& p : pins) { BOOST_TEST((s.at[p.vertex] == p.at)); }
  BOOST_TEST(is_one_to_one(s.surface, s.at));
}

} // namespace

BOOST_AUTO_TEST_CASE(two_pins_turn_and_scale)
{
  Sheet s(20);
  const std::vector<Map_pin> pins{{0, {0.5, 0.5}}, {20, {0.5, 0.75}}}; // the lower side goes up, a quarter as long
  BOOST_TEST(pin_map(s.surface, s.at, pins) == 0);
  check_there(s, pins);
  BOOST_TEST(s.stretch() < 1 + 1e-9);
  BOOST_TEST(norm(s.at[20 * 21] - Plane_point{0.25, 0.5}) < 1e-9); // the upper left corner
}

BOOST_AUTO_TEST_CASE(one_pin_moves)
{
  Sheet s(8);
  const std::vector<Plane_point> before = s.at;
  const std::vector<Map_pin> pins{{40, {3, -7}}};
  BOOST_TEST(pin_map(s.surface, s.at, pins) == 0);
  check_there(s, pins);
  for (std::size_t v = 0; v < before.size(); ++v)
  {
    BOOST_TEST(norm((s.at[v] - s.at[40]) - (before[v] - before[40])) < 1e-12);
  }
}

// The corners stay, and a vertex in the middle goes aside.
BOOST_AUTO_TEST_CASE(many_pins_are_drawn_to_their_places)
{
  for (const Plane_point& aside : {Plane_point{0.3, 0.05}, Plane_point{-0.35, 0.35}, Plane_point{0, 0.45}})
  {
    Sheet s(20);
    const Index middle = 10 * 21 + 10;
    const std::vector<Map_pin> pins{
      {0, {0, 0}}, {20, {1, 0}}, {20 * 21, {0, 1}}, {20 * 21 + 20, {1, 1}}, {middle, s.at[middle] + aside}};
    BOOST_TEST(pin_map(s.surface, s.at, pins) == 0);
    check_there(s, pins);
    BOOST_TEST(s.stretch() > 1.001);
    BOOST_TEST(s.stretch() < 2);
  }
}

// Two vertices cannot be in one place: they come as near as a map that is one-to-one lets them.
BOOST_AUTO_TEST_CASE(what_cannot_be_is_told)
{
  Sheet s(10);
  const std::vector<Map_pin> pins{{0, {0, 0}}, {10, {1, 0}}, {36, {0.4, 0.6}}, {80, {0.4, 0.6}}};
  const double away = pin_map(s.surface, s.at, pins);
  BOOST_TEST(away > 0);
  BOOST_TEST(away < 0.2);
  BOOST_TEST(is_one_to_one(s.surface, s.at));
}

BOOST_AUTO_TEST_CASE(charts_are_packed_beside_those_that_are_fixed)
{
  const Sheet sheet(3);
  std::vector<Chart> charts(6, Chart{&sheet.surface.triangles, sheet.at, 1});
  charts[4].is_fixed = true;
  for (Plane_point& p : charts[4].at) { p = 0.25 * p + Plane_point{0.4, 0.375}; }
  const std::vector<Plane_point> fixed = charts[4].at;
  pack_charts(charts);
  BOOST_TEST((charts[4].at == fixed));
  std::vector<std::array<Index, 3>> faces;
  std::vector<Plane_point> all;
  for (const Chart& c : charts)
  {
    BOOST_TEST(covered_area(c) == 1. / 16, boost::test_tools::tolerance(1e-9)); // at its density
    const auto n = static_cast<Index>(all.size());
    for (const auto& t : *c.triangles) { faces.push_back({t[0] + n, t[1] + n, t[2] + n}); }
    all.insert(all.end(), c.at.begin(), c.at.end());
  }
  BOOST_TEST(verify_packing(faces, all, {2, 2048, 2048}).failures.size() == 0u);
  std::vector<Chart> too_many(16, charts[4]);
  for (std::size_t i = 1; i < too_many.size(); ++i) { too_many[i].is_fixed = false; }
  BOOST_CHECK_THROW(pack_charts(too_many), Invalid_input_error);
  std::vector<Chart> both(2, charts[4]); // in one place
  BOOST_CHECK_THROW(pack_charts(both), Invalid_input_error);
  for (Plane_point& p : both[1].at) { p[0] += 0.2525; } // beside each other
  BOOST_CHECK_NO_THROW(pack_charts(both));
}
