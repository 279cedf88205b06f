// Slits that are opened, and where charts are near themselves.
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

#include "support/sample_surfaces.h"

#include <meridian/base/vectors.h>
#include <meridian/map/is_one_to_one.h>
#include <meridian/map/open_slits.h>
#include <meridian/map/planar_map.h>
#include <meridian/proof/verify_packing.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/measures.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace data = boost::unit_test::data;
using namespace meridian;

namespace {

std::vector<Plane_point> flat(const Triangle_surface& s)
{
  std::vector<Plane_point> at;
  for (const Point& p : s.points) { at.push_back({p[0], p[1]}); }
  return at;
}

// A strip that is folded in the plane to a U upside down: two legs of some width, 2 high and so far apart, below half a
// ring. Counterclockwise.
Triangle_surface folded(double apart, double width, int along = 60, int across = 6)
{
  return sample::sheet(along, across, [&](double x, double y) {
    constexpr double pi = 3.14159265358979;
    const double inner = apart / 2, radius = inner + width * y, leg = 2, arc = pi * (inner + width / 2);
    const double s = x * (2 * leg + arc);
    if (s < leg) { return Point{radius, s, 0}; }
    if (s > leg + arc) { return Point{-radius, 2 * leg + arc - s, 0}; }
    const double angle = pi * (s - leg) / arc;
    return Point{radius * std::cos(angle), leg + radius * std::sin(angle), 0};
  });
}

// The map of it with its faces upright.
std::pair<Triangle_surface, std::vector<Plane_point>> upright(Triangle_surface s)
{
  std::vector<Plane_point> at = flat(s);
  if (area_of(s.triangles, at) < 0)
  {
    for (Plane_point& p : at) { p[0] = -p[0]; }
  }
  return {std::move(s), std::move(at)};
}

// The least distance of the inner sides of the legs, from 0 to `high`.
double distance_of_legs(const Triangle_surface& s, const std::vector<Plane_point>& before,
                        const std::vector<Plane_point>& at, double inner, double high)
{
  double left = -1e9, right = 1e9;
  for (Index v = 0; v < s.number_of_vertices(); ++v)
  {
    if (std::abs(std::abs(before[v][0]) - inner) > 1e-9 || before[v][1] > high) { continue; }
    if (before[v][0] < 0) { left = std::max(left, at[v][0]); }
    else { right = std::min(right, at[v][0]); }
  }
  return right - left;
}

} // namespace

BOOST_AUTO_TEST_CASE(a_slit_becomes_as_wide_as_the_gap)
{
  constexpr double apart = 1e-3, gap = 0.05;
  const auto [s, before] = upright(folded(apart, 1));
  std::vector<Plane_point> at = before;
  BOOST_TEST_REQUIRE(is_one_to_one(s, at));
  const Opened_slits sides = open_slits(s, at, gap);
  BOOST_TEST(sides.before > 20u);
  BOOST_TEST(sides.after == 0u);
  BOOST_TEST(is_one_to_one(s, at));
  // eight gaps along the border, 0.2 on each side, belong to the end of the slit
  BOOST_TEST(distance_of_legs(s, before, at, apart / 2, 2 - 0.25) >= gap);
  BOOST_TEST(distance_of_legs(s, before, at, apart / 2, 2 - 0.25) < 2 * gap);
  double farthest = 0;
  for (std::size_t v = 0; v < at.size(); ++v)
  {
    const double moved = norm(at[v] - before[v]);
    farthest = std::max(farthest, moved);
    if (std::abs(before[v][0]) > apart / 2 + 4.5 * gap) { BOOST_TEST(moved == 0); }
    if (std::abs(before[v][0]) > apart / 2 + 3 * gap) { BOOST_TEST(moved < gap / 6); }
  }
  BOOST_TEST(farthest < gap);
  std::vector<Plane_point> again = at;
  BOOST_TEST(open_slits(s, again, gap).before == 0u);
  BOOST_TEST((again == at)); // what is wide enough stays
}

BOOST_AUTO_TEST_CASE(opening_goes_with_scale)
{
  const auto [s, before] = upright(folded(1e-3, 1));
  std::vector<Plane_point> at = before, large;
  for (const Plane_point& p : before) { large.push_back(1024. * p); }
  open_slits(s, at, 0.05);
  open_slits(s, large, 1024 * 0.05);
  for (Plane_point& p : at) { p = 1024. * p; }
  BOOST_TEST((at == large));
}

// A leg that is narrower than the gap is no slit: what is between its sides is the surface.
BOOST_AUTO_TEST_CASE(what_is_narrow_is_no_slit)
{
  const auto [s, before] = upright(folded(1, 0.02));
  std::vector<Plane_point> at = before;
  BOOST_TEST(open_slits(s, at, 0.05).before == 0u);
  BOOST_TEST((at == before));
  BOOST_TEST(find_near_themselves(s.triangles, at, 0.05).empty());
}

// Legs as wide as a hair cannot give way by more: what can be done is, and the rest counted.
BOOST_AUTO_TEST_CASE(what_cannot_give_way_is_counted)
{
  const auto [s, before] = upright(folded(1e-3, 0.02, 200, 2));
  std::vector<Plane_point> at = before;
  const Opened_slits sides = open_slits(s, at, 0.3);
  BOOST_TEST(sides.before > 0u);
  BOOST_TEST(sides.after > 0u);
  BOOST_TEST(sides.after <= sides.before);
  BOOST_TEST(is_one_to_one(s, at));
  BOOST_TEST((find_near_themselves(s.triangles, at, 0.3).size() > 0));
}

// Known answer: legs 1/8 apart.
BOOST_AUTO_TEST_CASE(where_a_chart_is_near_itself_is_recounted)
{
  const auto [s, at] = upright(folded(0.125, 1));
  BOOST_TEST(find_near_themselves(s.triangles, at, 0.125).empty()); // exactly so far is far enough
  const auto near = find_near_themselves(s.triangles, at, 0.126);
  // faces with a side on the inner border of a leg, but for those near the end of the slit
  std::vector<Index> expected;
  for (Index h = 0; h < s.number_of_halfedges(); ++h)
  {
    const auto is_inner = [&](Index v) { return std::abs(std::abs(at[v][0]) - 0.0625) < 1e-9; };
    const Index v = s.source(h), w = s.target(h);
    if (s.opposite[h] >= 0 || !is_inner(v) || !is_inner(w)) { continue; }
    // the way around the end is twice what is left of the leg, and half a circle
    const double way = 2 * (2 - std::max(at[v][1], at[w][1])) + 3.14159 * 0.0625;
    if (way > 8 * 0.126 + 0.15) { expected.push_back(h / 3); }
  }
  std::sort(expected.begin(), expected.end());
  BOOST_TEST(expected.size() > 10u);
  BOOST_TEST(std::includes(near.begin(), near.end(), expected.begin(), expected.end()));
  BOOST_TEST(near.size() <= expected.size() + 8);
  std::vector<Plane_point> wide = at; // the same in texels that are not squares
  for (Plane_point& p : wide) { p[0] /= 4; }
  BOOST_TEST((find_near_themselves(s.triangles, wide, {0.126 * 16, 64, 16}) == near));
  // charts that are near each other are another matter
  std::vector<std::array<Index, 3>> two = s.triangles;
  std::vector<Plane_point> all = at;
  const auto n = static_cast<Index>(at.size());
  for (const auto& t : s.triangles) { two.push_back({t[0] + n, t[1] + n, t[2] + n}); }
  for (const Plane_point& p : at) { all.push_back(p + Plane_point{2.2, 0}); }
  BOOST_TEST(find_near_themselves(two, all, 0.12).empty());
  for (Plane_point& p : all) { p = 0.2 * p + Plane_point{0.25, 0.1}; } // into one tile
  const Verification found = verify_packing(two, all, 0.2 * 0.12);
  BOOST_TEST_REQUIRE(found.failures.size() == 1u);
  BOOST_TEST(found.failures[0].find("nearer to another chart") != std::string::npos, found.failures[0]);
}
