#include "support/pipeline.h"
#include "support/sample_surfaces.h"

#include <meridian/base/vectors.h>
#include <meridian/curves/contours.h>
#include <meridian/curves/project_contours.h>
#include <meridian/field/Node_order.h>
#include <meridian/field/critical_points.h>
#include <meridian/field/edge_weights.h>
#include <meridian/field/internal/simplify_order.h>
#include <meridian/field/solve_harmonic_field.h>
#include <meridian/handles/select_meridians.h>
#include <meridian/surface/Closed_model.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/insert_curves.h>
#include <meridian/surface/open_along.h>

namespace data = boost::unit_test::data;
using namespace meridian;

namespace {

std::vector<double> random_field(Index n, unsigned seed)
{
  std::mt19937 random(seed);
  std::vector<double> f(n);
  for (double& x : f) { x = static_cast<double>(random() % 1000); } // ties included
  return f;
}

// Counts extrema by neighbours alone, without links.
Critical_counts count_extrema(const Closed_model& g, const std::vector<Index>& rank)
{
  Critical_counts c;
  for (Index a = 0; a < g.number_of_nodes; ++a)
  {
    bool low = true, high = true;
    for (Index i = g.begin[a]; i < g.begin[a + 1]; ++i) { (rank[g.neighbor[i]] < rank[a] ? low : high) = false; }
    c.minima += low;
    c.maxima += high;
  }
  return c;
}

Triangle_surface bordered(int genus, unsigned seed)
{
  const auto s = sample::plate(genus, 3);
  std::mt19937 random(seed);
  std::vector<Index> holes;
  std::vector<char> near(s.number_of_vertices(), 0);
  for (int i = 0; i < 6; ++i)
  {
    const Index v = static_cast<Index>(random() % s.number_of_vertices());
    bool is_free = !near[v];
    s.for_each_outgoing(v, [&](Index h) { is_free = is_free && !near[s.target(h)]; });
    if (!is_free) { continue; }
    holes.push_back(v);
    // Two rings stay between holes.
    s.for_each_outgoing(v, [&](Index h) { s.for_each_outgoing(s.target(h), [&](Index k) { near[s.target(k)] = 1; }); });
  }
  return sample::punctured(s, holes);
}

} // namespace

// Known answer.
BOOST_AUTO_TEST_CASE(height_on_a_box_has_its_lowest_and_highest_vertex)
{
  const auto box = sample::plate(0, 1);
  std::vector<double> height;
  for (const Point& p : box.points) { height.push_back(p[0] + 5 * p[1] + 50 * p[2]); }
  const auto m = pipeline::order(box, height, false);
  BOOST_REQUIRE(m.critical.size() == 2u);
  for (const auto& p : m.critical)
    BOOST_TEST(height[p.vertex] == (p.kind == Critical_kind::MINIMUM ? 0. : 1 + 15 + 50));
}

// Theorem, for every field: saddles = 2g + minima + maxima - 2. Banchoff 1970.
BOOST_DATA_TEST_CASE(saddles_are_counted_by_the_genus_and_the_extrema, data::xrange(5) * data::xrange(10), genus, seed)
{
  for (const Triangle_surface& s : {sample::plate(genus), bordered(genus, seed)})
  {
    const auto m = pipeline::order(s, random_field(s.number_of_vertices(), seed), false);
    const auto c = count(m.critical);
    BOOST_TEST(c.saddles == 2 * genus + c.minima + c.maxima - 2);
    // Unfolding keeps the sum and leaves only simple saddles.
    const auto unfolded = find_critical_points(m.surface, m.rank);
    BOOST_TEST(count(unfolded).saddles == c.saddles);
    BOOST_TEST(count(unfolded).minima == c.minima);
    BOOST_TEST(count(unfolded).maxima == c.maxima);
    for (const auto& p : unfolded) { BOOST_REQUIRE(p.multiplicity == 1); }
    BOOST_TEST(sample::euler_characteristic(m.surface) == sample::euler_characteristic(s));
  }
}

BOOST_DATA_TEST_CASE(simplification_leaves_one_minimum_and_one_maximum, data::xrange(4) * data::xrange(15), genus, seed)
{
  for (const Triangle_surface& s : {sample::plate(genus), bordered(genus, seed)})
  {
    const auto m = pipeline::order(s, random_field(s.number_of_vertices(), 100 + seed), true);
    const auto c = count(m.critical);
    BOOST_TEST(c.minima == 1);
    BOOST_TEST(c.maxima == 1);
    BOOST_TEST(c.saddles == 2 * genus);
  }
}

BOOST_DATA_TEST_CASE(a_constant_field_is_ordered_and_simplified_too, data::xrange(4), genus)
{
  const auto s = bordered(genus, 3);
  const auto m = pipeline::order(s, std::vector<double>(s.number_of_vertices(), 7), true);
  BOOST_TEST(count(m.critical).saddles == 2 * genus);
}

BOOST_DATA_TEST_CASE(an_st_numbering_has_only_the_allowed_extrema, data::xrange(4) * data::xrange(10), genus, seed)
{
  const auto s = sample::renumbered(bordered(genus, seed), seed);
  const auto g = make_closed_model(s);
  std::mt19937 random(seed);
  std::vector<Index> low{static_cast<Index>(random() % g.number_of_nodes)}, high;
  do {
    high = {static_cast<Index>(random() % g.number_of_nodes)};
  } while (high == low);
  const auto nodes = internal::st_numbering(g, low, high);
  std::vector<Index> rank(g.number_of_nodes, -1);
  for (std::size_t i = 0; i < nodes.size(); ++i) { rank[nodes[i]] = static_cast<Index>(i); }
  BOOST_TEST(nodes.front() == low.front());
  BOOST_TEST(nodes.back() == high.front());
  const auto c = count_extrema(g, rank);
  BOOST_TEST(c.minima == 1);
  BOOST_TEST(c.maxima == 1);
}

BOOST_AUTO_TEST_CASE(several_extrema_may_be_kept)
{
  const auto s = sample::torus(30, 12);
  const auto g = make_closed_model(s);
  const auto field = pipeline::harmonic(s, g, {{0, 0}, {100, 0}, {200, 1}, {300, 1}});
  auto order = order_nodes(g, field);
  simplify_order(g, order, {0, 100}, {200, 300});
  const auto c = count_extrema(g, order.rank);
  BOOST_TEST(c.minima == 2);
  BOOST_TEST(c.maxima == 2);
}

// sin x + sin y - sin(x + y) on a torus: one minimum, one maximum and one double saddle, whose contours do not cut the
// handle.
BOOST_AUTO_TEST_CASE(a_double_saddle_on_a_torus_becomes_two_whose_loops_cut_the_handle)
{
  constexpr int n = 36;
  const auto s = sample::torus(n, n);
  std::vector<double> f;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
    {
      const double x = 2 * sample::pi * i / n, y = 2 * sample::pi * j / n;
      f.push_back(std::sin(x) + std::sin(y) - std::sin(x + y));
    }
  const auto m = pipeline::order(s, f, false);
  const auto c = count(m.critical);
  BOOST_TEST(c.minima == 1);
  BOOST_TEST(c.maxima == 1);
  BOOST_TEST(c.saddles == 2);
  BOOST_TEST(count(find_critical_points(m.surface, m.rank)).saddles == 2);
  const auto loops = trace_saddle_loops(m);
  std::vector<std::size_t> order(loops.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  const auto chosen = select_meridians(m, loops, order);
  BOOST_REQUIRE(chosen.size() == 1u);
  const auto curves = project_contours(s, m, {&loops[chosen.front().loop]});
  Refined_surface refined(s);
  insert_curves(s, refined, curves);
  const Triangle_surface o = surface_of(refined, open_along(refined));
  BOOST_TEST(boundary_loops(o).size() == 2u);
  BOOST_TEST(sample::euler_characteristic(o) == 0); // an annulus, for it is connected:
  std::vector<Index> reached{0};
  std::vector<char> seen(o.number_of_faces(), 0);
  seen[0] = 1;
  for (std::size_t i = 0; i < reached.size(); ++i)
    for (Index h = 3 * reached[i]; h < 3 * reached[i] + 3; ++h)
      if (o.opposite[h] >= 0 && !seen[o.opposite[h] / 3])
      {
        seen[o.opposite[h] / 3] = 1;
        reached.push_back(o.opposite[h] / 3);
      }
  BOOST_TEST(reached.size() == static_cast<std::size_t>(o.number_of_faces()));
}

// Metamorphic: turning the field upside down swaps the extrema and keeps the saddles.
BOOST_DATA_TEST_CASE(negating_the_field_swaps_minima_and_maxima, data::xrange(4), genus)
{
  const auto s = sample::plate(genus);
  std::vector<double> f(s.number_of_vertices());
  std::iota(f.begin(), f.end(), 0.);
  std::shuffle(f.begin(), f.end(), std::mt19937(5));
  const auto up = count(pipeline::order(s, f, false).critical);
  for (double& x : f) { x = -x; }
  const auto down = count(pipeline::order(s, f, false).critical);
  BOOST_TEST(up.minima == down.maxima);
  BOOST_TEST(up.maxima == down.minima);
  BOOST_TEST(up.saddles == down.saddles);
}

// Maximum principle: positive weights leave extrema only where values are prescribed.
BOOST_DATA_TEST_CASE(positive_weights_have_no_other_extrema, data::make({false, true}), is_mean_value)
{
  const Weights weights = is_mean_value ? Weights::MEAN_VALUE : Weights::POSITIVE;
  const auto s = sample::noisy(sample::plate(3, 4), 0.1, 4);
  const auto g = make_closed_model(s);
  const auto field = pipeline::harmonic(s, g, {{0, 0}, {200, 1}}, weights);
  const auto c = count_extrema(g, order_nodes(g, field).rank);
  BOOST_TEST(c.minima == 1);
  BOOST_TEST(c.maxima == 1);
  for (double x : field.value) { BOOST_REQUIRE((x >= 0 && x <= 1)); }
}

// Known answer: on a square with prescribed sides every linear function solves the cotangent equations. The square is
// the plane grid; all its boundary is prescribed one vertex at a time, so it is not shrunk: the grid lies on a sphere.
BOOST_AUTO_TEST_CASE(cotangent_weights_reproduce_linear_functions)
{
  const auto s = sample::noisy(sample::plate(0, 6), 0., 0); // a box; its top side is flat
  const auto g = make_closed_model(s);
  std::vector<Dirichlet_value> prescribed;
  for (Index v = 0; v < s.number_of_vertices(); ++v)
  {
    const Point& p = s.points[v];
    const bool is_inside_top = p[2] > 0.99 && p[0] > 0.01 && p[0] < 0.99 && p[1] > 0.01 && p[1] < 2.99;
    if (!is_inside_top) { prescribed.push_back({v, 2 * p[0] - p[1] + 3}); }
  }
  const auto field = pipeline::harmonic(s, g, prescribed, Weights::COTANGENT);
  for (Index v = 0; v < s.number_of_vertices(); ++v)
    BOOST_TEST(field(v) == 2 * s.points[v][0] - s.points[v][1] + 3, boost::test_tools::tolerance(1e-10));
}

BOOST_AUTO_TEST_CASE(weights_are_finite_on_faces_without_area)
{
  auto s = sample::torus(8, 6);
  s.points[1] = s.points[0]; // an edge without length
  s.points[9] = 0.5 * (s.points[8] + s.points[10]);
  for (Weights kind : {Weights::POSITIVE, Weights::MEAN_VALUE, Weights::COTANGENT})
    for (double w : edge_weights(s, kind))
    {
      BOOST_REQUIRE((std::isfinite(w) && (kind == Weights::COTANGENT || w > 0)));
    }
}

BOOST_AUTO_TEST_CASE(digits_are_kept_where_the_field_is_flat)
{
  const auto s = sample::dumbbell(60);
  const auto g = make_closed_model(s);
  const auto field = pipeline::harmonic(s, g, {{400, 0}, {500, 1}});
  BOOST_TEST(field.regions.size() > 1u);
  const auto order = order_nodes(g, field);
  const auto c = count_extrema(g, order.rank); // no sweep was needed
  BOOST_TEST(c.minima == 1);
  BOOST_TEST(c.maxima == 1);
}
