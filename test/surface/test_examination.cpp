#include "support/pipeline.h"
#include "support/sample_surfaces.h"

#include <meridian/base/Polygon_soup.h>
#include <meridian/base/exceptions.h>
#include <meridian/base/vectors.h>
#include <meridian/proof/verify_cut.h>
#include <meridian/result/assemble_result.h>
#include <meridian/result/recount.h>
#include <meridian/surface/examine_surface.h>
#include <meridian/surface/renumber.h>

using namespace meridian;

namespace {

Polygon_soup soup_of(std::vector<Point> points, const std::vector<std::vector<Index>>& polygons)
{
  Polygon_soup soup;
  soup.points = std::move(points);
  for (const auto& p : polygons) { soup.add_polygon(p.data(), p.size()); }
  return soup;
}

std::vector<Point> some_points(int n)
{
  std::vector<Point> points;
  for (int i = 0; i < n; ++i) { points.push_back({std::cos(i), std::sin(i), 0.1 * i * i}); }
  return points;
}

bool has_repair(const Examination& e, const std::string& text)
{
  return std::any_of(e.repairs.begin(), e.repairs.end(),
                     [&](const auto& r) { return r.find(text) != std::string::npos; });
}

template <class Call> std::string message_of(Call call)
{
  try
  {
    call();
  }
  catch (const Invalid_input_error& e)
  {
    return e.what();
  }
  return "";
}

Polygon_soup joined(const Polygon_soup& a, const Polygon_soup& b)
{
  Polygon_soup s = a;
  s.points.insert(s.points.end(), b.points.begin(), b.points.end());
  for (std::size_t i = 0; i < b.number_of_polygons(); ++i)
  {
    std::vector<Index> corners;
    for (std::size_t k = 0; k < b.size(i); ++k)
    {
      corners.push_back(b.corner(i, k) + static_cast<Index>(a.points.size()));
    }
    s.add_polygon(corners.data(), corners.size());
  }
  return s;
}

} // namespace

BOOST_AUTO_TEST_CASE(components_are_counted_and_ordered_by_their_first_face)
{
  const auto e = examine_surface(
    joined(sample::soup(sample::plate(2)), sample::soup(sample::punctured(sample::torus(9, 7), {3, 40}))));
  BOOST_REQUIRE(e.components.size() == 2u);
  BOOST_TEST(e.components[0].genus() == 2);
  BOOST_TEST(e.components[0].boundary_loops == 0);
  BOOST_TEST(e.components[1].genus() == 1);
  BOOST_TEST(e.components[1].boundary_loops == 2);
  BOOST_TEST(e.components[1].euler_characteristic() == -2);
  BOOST_TEST(std::is_sorted(e.components[1].vertex_of.begin(), e.components[1].vertex_of.end()));
}

BOOST_AUTO_TEST_CASE(polygons_are_cut_by_a_fan_from_their_lowest_vertex)
{
  const auto e = examine_surface(soup_of(some_points(5), {{3, 4, 0, 1, 2}}));
  const auto& t = e.components.front().surface.triangles;
  BOOST_REQUIRE(t.size() == 3u);
  const std::array<Index, 3> first{0, 1, 2}, second{0, 2, 3}, third{0, 3, 4};
  BOOST_TEST((t[0] == first && t[1] == second && t[2] == third));
  BOOST_TEST(e.components.front().polygon_of[2] == 0);
}

BOOST_AUTO_TEST_CASE(flipped_faces_are_turned_over_the_fewer_ones)
{
  auto s = sample::plate(1);
  std::swap(s.triangles[5][0], s.triangles[5][1]);
  std::swap(s.triangles[9][0], s.triangles[9][1]);
  const auto e = examine_surface(sample::soup(s));
  BOOST_TEST(has_repair(e, "2 faces turned over"));
  BOOST_TEST(has_repair(e, "first: 5, 9"));
  BOOST_TEST(e.components.front().genus() == 1);
  BOOST_TEST(e.components.front().is_flipped[5] == 1);
  const auto run = pipeline::run(sample::soup(s));
  for (const auto& failure : run.verification.failures) { BOOST_ERROR(failure); }
}

BOOST_AUTO_TEST_CASE(surfaces_that_are_not_orientable_are_refused_by_name)
{
  std::vector<std::vector<Index>> strip; // Moebius
  for (Index i = 0; i < 5; ++i) { strip.push_back({i, (i + 1) % 5, (i + 2) % 5}); }
  const std::string text = message_of([&] { examine_surface(soup_of(some_points(5), strip)); });
  BOOST_TEST(text.find("not orientable") != std::string::npos);
  BOOST_TEST(text.find("1 component") != std::string::npos);
  // A closed Klein bottle is not turned into a sphere with two holes.
  std::vector<std::vector<Index>> klein;
  constexpr Index n = 6, m = 5;
  const auto at = [](Index i, Index j) { return i < n ? i * m + j % m : (m - j % m) % m; };
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < m; ++j)
    {
      klein.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      klein.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  BOOST_TEST(message_of([&] { examine_surface(soup_of(some_points(n * m), klein)); }).find("not orientable")
             != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_pinched_vertex_splits_into_one_for_each_fan)
{
  // Two tetrahedra that share a vertex.
  const auto soup =
    soup_of(some_points(7), {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {3, 5, 4}, {3, 4, 6}, {4, 5, 6}, {5, 3, 6}});
  const auto run = pipeline::run(soup);
  BOOST_TEST(run.examination.components.size() == 2u);
  BOOST_TEST(has_repair(run.examination, "1 vertices divided"));
  BOOST_TEST(run.verification.failures.size() == 0u);
  for (const auto& failure : run.verification.failures) { BOOST_ERROR(failure); }
  BOOST_TEST(run.assembled.mesh.copy_of[7 + run.cuts[0].surface.origins.size() + run.cuts[1].surface.origins.size()]
             == 3);
}

BOOST_AUTO_TEST_CASE(edges_with_three_faces_are_refused_and_split_on_demand)
{
  // Two tetrahedra that share an edge.
  const auto soup =
    soup_of(some_points(6), {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 4, 1}, {0, 1, 5}, {1, 4, 5}, {4, 0, 5}});
  const std::string text = message_of([&] { examine_surface(soup); });
  BOOST_TEST(text.find("1 edges have three or more faces (first: 0-1)") != std::string::npos);
  BOOST_TEST(text.find("--repair") != std::string::npos);
  const auto run = pipeline::run(soup, true);
  BOOST_TEST(run.examination.components.size() == 2u);
  for (const auto& c : run.examination.components) { BOOST_TEST(c.euler_characteristic() == 2); }
  for (const auto& failure : run.verification.failures) { BOOST_ERROR(failure); }
  // Three triangles on one edge.
  const auto fan = pipeline::run(soup_of(some_points(5), {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}), true);
  BOOST_TEST(fan.examination.components.size() == 3u);
  for (const auto& failure : fan.verification.failures) { BOOST_ERROR(failure); }
}

BOOST_AUTO_TEST_CASE(sheets_of_an_edge_with_four_faces_may_be_divided_alike)
{
  // Two quadrilaterals back to back: both fans have the diagonal 0-2, so it has four faces.
  const auto run =
    pipeline::run(soup_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}, {3, 2, 1, 0}}), true);
  for (const auto& failure : run.verification.failures) { BOOST_ERROR(failure); }
}

BOOST_AUTO_TEST_CASE(points_that_are_not_finite_are_refused_where_a_face_uses_them)
{
  auto soup = sample::soup(sample::plate(0));
  soup.points.push_back({std::nan(""), 0, 0});
  BOOST_TEST(has_repair(examine_surface(soup), "1 vertices kept that no face uses"));
  soup.points[3][1] = std::nan("");
  soup.points[5][2] = -1e301;
  soup.points[6][0] = HUGE_VAL;
  BOOST_TEST(
    message_of([&] {
      examine_surface(soup);
    }).find("3 vertices of faces have a coordinate that is not a finite number, or beyond 1e300 (first: 3, 5, 6)")
    != std::string::npos);
}

// Squares of lengths stay numbers.
BOOST_AUTO_TEST_CASE(points_of_any_size_are_brought_to_scale)
{
  for (double size : {1e-200, 1e-60, 1e-40, 1., 1e40, 1e60, 1e200})
  {
    const auto e = examine_surface(sample::soup(sample::scaled(sample::plate(0), size)));
    const Surface_component& c = e.components.front();
    BOOST_TEST((c.unit == 1) == (size > 1e-50 && size < 1e50));
    for (const Point& p : c.surface.points)
      for (double x : p) { BOOST_TEST(std::abs(x) < 1e50); }
    BOOST_TEST(c.unit * c.surface.length(0) == size * sample::plate(0).length(0), boost::test_tools::tolerance(1e-12));
  }
}

BOOST_AUTO_TEST_CASE(damaged_and_degenerate_faces_follow_stated_policies)
{
  auto soup = sample::soup(sample::plate(1));
  const Index repeated[] = {1, 1, 2}, two[] = {1, 2};
  soup.add_polygon(repeated, 3);
  soup.add_polygon(two, 2);
  const auto e = examine_surface(soup);
  BOOST_TEST(has_repair(e, "2 faces left out"));
  BOOST_TEST(e.components.front().genus() == 1);
  const auto run = pipeline::run(soup);
  for (const auto& failure : run.verification.failures) { BOOST_ERROR(failure); }
  const Index outside[] = {0, 1, 5000};
  soup.add_polygon(outside, 3);
  BOOST_TEST(message_of([&] { examine_surface(soup); }).find("1 faces name a vertex that the file does not have")
             != std::string::npos);
  BOOST_TEST(message_of([&] { examine_surface(Polygon_soup()); }).find("no usable face") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(faces_without_area_are_kept_and_cut)
{
  auto s = sample::torus(12, 8);
  for (Index v : {20, 21, 22, 23}) { s.points[v] = s.points[20]; }
  const auto run = pipeline::run(sample::soup(s));
  BOOST_TEST(has_repair(run.examination, "faces kept that have no area"));
  for (const auto& failure : run.verification.failures) { BOOST_ERROR(failure); }
}

BOOST_AUTO_TEST_CASE(all_points_in_one_place_are_cut_too)
{
  auto s = sample::plate(2);
  for (Point& p : s.points) { p = {1, 2, 3}; }
  const auto run = pipeline::run(sample::soup(s)),
             of_curves = pipeline::run(sample::soup(s), false, pipeline::tight_curves());
  BOOST_TEST(curves_of(of_curves.cuts.front(), Curve_kind::MERIDIAN).size() == 2u);
  for (const auto& failure : of_curves.verification.failures) { BOOST_ERROR(failure); }
  for (const auto& failure : run.verification.failures) { BOOST_ERROR(failure); }
}

namespace {

// Says that a component is the soup that it came from, whatever its numbers: its faces are the soup's, corner by corner
// but for those turned over, each once, at the soup's points, and its twins are those of its edges.
void check_is_soup(const Surface_component& c, const Polygon_soup& soup)
{
  const Triangle_surface& s = c.surface;
  std::set<Index> faces, vertices;
  for (Index f = 0; f < s.number_of_faces(); ++f)
  {
    std::array<Index, 3> corners;
    for (int k = 0; k < 3; ++k) { corners[k] = c.vertex_of[s.triangles[f][k]]; }
    if (c.is_flipped[f]) { std::swap(corners[1], corners[2]); }
    const Index polygon = c.polygon_of[f];
    BOOST_REQUIRE(polygon == c.triangle_of[f]);
    BOOST_TEST(std::equal(corners.begin(), corners.end(), soup.corners.begin() + soup.begin[polygon]));
    faces.insert(polygon);
  }
  for (Index v = 0; v < s.number_of_vertices(); ++v)
  {
    BOOST_TEST((s.points[v] == soup.points[c.vertex_of[v]]));
    BOOST_TEST(s.source(s.outgoing[v]) == v);
    vertices.insert(c.vertex_of[v]);
  }
  BOOST_TEST(static_cast<Index>(faces.size()) == s.number_of_faces());
  BOOST_TEST(static_cast<Index>(vertices.size()) == s.number_of_vertices());
  Triangle_surface again = s;
  connect(again);
  BOOST_TEST((again.opposite == s.opposite));
}

} // namespace

// Numbers change, and nothing else; the shuffled surface lies in order after it, and is cut and recounted as ever.
BOOST_AUTO_TEST_CASE(renumbering_brings_together_what_is_near)
{
  const auto torus = sample::punctured(sample::torus(240, 120), {5, 7777});
  auto shuffled = sample::soup(sample::renumbered(torus, 3));
  for (std::size_t f = 0; f < shuffled.number_of_polygons(); f += 7) // some faces are turned over
  {
    std::swap(shuffled.corners[shuffled.begin[f] + 1], shuffled.corners[shuffled.begin[f] + 2]);
  }
  BOOST_TEST(!is_scattered(torus));
  Triangle_surface triangle;
  triangle.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  triangle.triangles = {{0, 1, 2}};
  for (const auto& small : {sample::torus(40, 20), sample::connected(triangle)}) // all of it fits in a cache
  {
    BOOST_TEST(!is_scattered(sample::renumbered(small, 3)));
  }
  Examination e = examine_surface(shuffled);
  Surface_component& c = e.components.front();
  check_is_soup(c, shuffled);
  BOOST_TEST(is_scattered(c.surface));
  renumber(c);
  check_is_soup(c, shuffled);
  BOOST_TEST(!is_scattered(c.surface));
  double gap = 0; // of the numbers along an edge
  for (Index h = 0; h < c.surface.number_of_halfedges(); ++h)
  {
    gap += std::abs(double(c.surface.source(h)) - c.surface.target(h)) / c.surface.number_of_halfedges();
  }
  BOOST_TEST(gap < 0.05 * c.surface.number_of_vertices()); // a third in no order
  const std::vector<Cut> cuts{pipeline::cut(c.surface)};
  for (const auto& failure : verify_cut(shuffled, assemble_result(shuffled, e, cuts).mesh).failures)
  {
    BOOST_ERROR(failure);
  }
}
