#include "field/cgal_distances.h"
#include "support/sample_surfaces.h"

#include <meridian/base/exceptions.h>
#include <meridian/base/vectors.h>
#include <meridian/curves/sleeve.h>
#include <meridian/field/Scalar_field.h>
#include <meridian/field/adapt_solver.h>
#include <meridian/field/curved_vertices.h>
#include <meridian/field/edge_weights.h>
#include <meridian/field/eigenfunctions.h>
#include <meridian/field/geodesic_distance.h>
#include <meridian/field/intrinsic_delaunay.h>
#include <meridian/field/solve_harmonic_field.h>
#include <meridian/surface/Closed_model.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/measures.h>

#include <CGAL/Eigen_solver_traits.h>

#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

namespace data = boost::unit_test::data;
using namespace meridian;

namespace {

const auto tolerance = [](double relative) { return boost::test_tools::tolerance(relative); };

double product(const std::vector<double>& mass, const std::vector<double>& x, const std::vector<double>& y)
{
  double sum = 0;
  for (std::size_t i = 0; i < mass.size(); ++i) { sum += mass[i] * x[i] * y[i]; }
  return sum;
}

Eigenfunctions eigenfunctions(const Triangle_surface& s, int k, Weights kind = Weights::COTANGENT)
{
  const auto g = make_closed_model(s);
  return find_eigenfunctions(g, edge_weights(s, kind), node_areas(s, g), k);
}

// A closed surface without symmetry, on which all eigenvalues differ.
Triangle_surface potato(unsigned seed = 1)
{
  auto s = sample::sphere(4);
  for (Point& p : s.points) { p = {2 * p[0] + 0.3 * p[1] * p[1], 1.4 * p[1] + 0.2 * p[2] * p[0], p[2] + 0.1 * p[0]}; }
  return sample::noisy(s, 0.01, seed);
}

// A unit sphere of revolution with few circles of latitude and many of longitude: thin faces.
Triangle_surface thin_sphere(int around, int along)
{
  Triangle_surface s;
  for (int j = 1; j < along; ++j)
    for (int i = 0; i < around; ++i)
    {
      const double u = 2 * sample::pi * (i + 0.5 * j) / around, v = sample::pi * j / along;
      s.points.push_back({std::sin(v) * std::cos(u), std::sin(v) * std::sin(u), std::cos(v)});
    }
  const Index north = s.number_of_vertices(), south = north + 1;
  s.points.push_back({0, 0, 1});
  s.points.push_back({0, 0, -1});
  for (int i = 0; i < around; ++i)
  {
    const int n = (i + 1) % around, last = (along - 2) * around;
    s.triangles.push_back({north, i, n});
    s.triangles.push_back({south, last + n, last + i});
    for (int j = 0; j + 2 < along; ++j)
    {
      s.triangles.push_back({j * around + i, (j + 1) * around + i, j * around + n});
      s.triangles.push_back({j * around + n, (j + 1) * around + i, (j + 1) * around + n});
    }
  }
  return sample::connected(std::move(s));
}

// A flat parallelogram, the diagonals the long way. Two of its corners are cut off by edges from boundary to boundary.
Triangle_surface sheared_grid(int n)
{
  Triangle_surface s;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) { s.points.push_back({i + 0.4 * j, double(j), 0}); }
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
    {
      const Index a = i * (n + 1) + j, b = a + n + 1;
      s.triangles.push_back({a, b, b + 1});
      s.triangles.push_back({a, b + 1, a + 1});
    }
  return sample::connected(std::move(s));
}

// Solvers that break in two ways.
using Cholesky_traits = CGAL::Eigen_solver_traits<Eigen::SimplicialLDLT<CGAL::Eigen_sparse_matrix<double>::EigenType>>;
struct Failing_solver : Cholesky_traits
{
  bool linear_solver(const Vector&, Vector&) { return false; }
};
struct Wrong_solver : Cholesky_traits
{
  bool linear_solver(const Vector&, Vector& x)
  {
    x[0] = std::numeric_limits<double>::quiet_NaN();
    return true;
  }
};

double intrinsic_area(const Intrinsic_triangulation& t)
{
  double sum = 0;
  for (Index h = 0; h < t.number_of_halfedges(); ++h) { sum += t.area(h) / 3; }
  return sum;
}

double mean_relative_error(const std::vector<double>& d, const std::vector<double>& expected)
{
  double sum = 0;
  for (std::size_t i = 0; i < d.size(); ++i)
  {
    if (expected[i] > 0) { sum += std::abs(d[i] - expected[i]) / expected[i]; }
  }
  return sum / static_cast<double>(d.size());
}

} // namespace

// Known answer: l (l + 1), 2 l + 1 times.
BOOST_AUTO_TEST_CASE(eigenvalues_of_the_unit_sphere)
{
  const auto e = eigenfunctions(sample::sphere(6), 8);
  BOOST_REQUIRE(e.values.size() == 9u);
  BOOST_TEST(e.values[0] == 0.);
  for (int i = 1; i < 9; ++i) { BOOST_TEST(e.values[i] == (i < 4 ? 2. : 6.), tolerance(5e-4)); }
  // The first three are coordinates turned: their squares add up to one function.
  for (std::size_t v = 0; v < e.functions[1].size(); ++v)
  {
    double sum = 0;
    for (int i = 1; i < 4; ++i) { sum += e.functions[i][v] * e.functions[i][v]; }
    BOOST_TEST(sum == 3 / (4 * sample::pi), tolerance(1e-3));
  }
}

// Known answer: 4 pi^2 (k^2 + l^2) on the unit square with opposite sides joined.
BOOST_AUTO_TEST_CASE(eigenvalues_of_the_flat_torus)
{
  constexpr int n = 80;
  const auto s = sample::torus(n, n);
  const auto g = make_closed_model(s);
  std::vector<double> weights(s.number_of_halfedges(), 0);
  for (Index h = 0; h < s.number_of_halfedges(); ++h)
  {
    const Index u = s.source(h), v = s.target(h);
    if (u / n == v / n || u % n == v % n) { weights[h] = 1; } // no diagonal
  }
  const auto e = find_eigenfunctions(g, weights, std::vector<double>(n * n, 1. / (n * n)), 8);
  const double square = 4 * sample::pi * sample::pi;
  for (int i = 1; i < 9; ++i) { BOOST_TEST(e.values[i] == (i < 5 ? 1 : 2) * square, tolerance(1e-3)); }
  // Known to all digits on the grid: 4 n^2 (sin^2(pi k / n) + sin^2(pi l / n)).
  const double sine = std::sin(sample::pi / n), grid = 4. * n * n * sine * sine;
  for (int i = 1; i < 9; ++i) { BOOST_TEST(e.values[i] == (i < 5 ? 1 : 2) * grid, tolerance(1e-9)); }
}

// Theorem: eigenfunctions are orthogonal, and L x = lambda M x.
BOOST_DATA_TEST_CASE(eigenfunctions_are_orthonormal_solutions, data::xrange(8), which)
{
  const Triangle_surface s = which == 0   ? sample::sphere(0)
                             : which == 1 ? sample::sphere(1)
                             : which == 2 ? sample::torus(40, 20)
                             : which == 3 ? sample::plate(2)
                             : which == 4 ? potato()
                             : which == 5 ? sample::dumbbell(60)
                             : which == 6 ? sample::punctured(sample::torus(30, 18), {5, 200, 400})
                                          : sample::torus(800, 8, 300);
  const auto g = make_closed_model(s);
  const int k = std::min(9, g.number_of_nodes - 1);
  const auto mass = node_areas(s, g);
  for (Weights kind : {Weights::COTANGENT, Weights::POSITIVE})
  {
    const auto weights = edge_weights(s, kind);
    const auto e = find_eigenfunctions(g, weights, mass, k);
    BOOST_REQUIRE(e.values.size() == static_cast<std::size_t>(k) + 1);
    BOOST_REQUIRE(e.functions.size() == e.values.size());
    for (int i = 0; i <= k; ++i)
    {
      for (int j = 0; j <= i; ++j)
      {
        BOOST_TEST(std::abs(product(mass, e.functions[i], e.functions[j]) - (i == j)) < 1e-12);
      }
      BOOST_TEST((i == 0 || e.values[i - 1] <= e.values[i]));
      double residual = 0;
      for (Index a = 0; a < g.number_of_nodes; ++a)
      {
        double r = -e.values[i] * mass[a] * e.functions[i][a];
        for (Index j = g.begin[a]; j < g.begin[a + 1]; ++j)
        {
          r += weights[g.halfedge[j]] * (e.functions[i][a] - e.functions[i][g.neighbor[j]]);
        }
        residual += r * r / mass[a];
      }
      BOOST_TEST(std::sqrt(residual) <= 1e-6 * e.values[k]);
      // The energy of the scaled function is the square of the eigenvalue.
      const auto f = scaled_eigenfunction(e, i);
      BOOST_TEST(product(mass, f, f) == e.values[i], tolerance(1e-10));
    }
  }
}

// Known answer: all eigenvalues of a small graph, where Krylov's spaces end early: the tetrahedron's has 4 three times.
BOOST_AUTO_TEST_CASE(no_copy_of_an_eigenvalue_is_missed)
{
  Triangle_surface s;
  s.points = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  s.triangles = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
  connect(s);
  const auto g = make_closed_model(s);
  for (int k = 1; k <= 3; ++k)
  {
    const auto e = find_eigenfunctions(g, std::vector<double>(12, 1), std::vector<double>(4, 1), k);
    for (int i = 1; i <= k; ++i) { BOOST_TEST(e.values[i] == 4., tolerance(1e-12)); }
  }
  // Whatever is asked for, a triple eigenvalue is not broken off or left out.
  for (int k = 1; k < 17; ++k)
  {
    const auto few = eigenfunctions(sample::sphere(1), k), all = eigenfunctions(sample::sphere(1), 17);
    for (int i = 0; i <= k; ++i) { BOOST_TEST(few.values[i] == all.values[i], tolerance(1e-9)); }
  }
}

// Metamorphic: lengths in other units, vertices with other numbers.
BOOST_DATA_TEST_CASE(units_do_not_matter, data::make({1e-40, 1e-3, 7., 1e40}), factor)
{
  const auto s = potato();
  const auto t = sample::scaled(s, factor);
  for (Weights kind : {Weights::COTANGENT, Weights::POSITIVE})
  {
    const auto e = eigenfunctions(s, 6, kind), f = eigenfunctions(t, 6, kind);
    for (int i = 1; i <= 6; ++i)
    {
      BOOST_TEST(f.values[i] * factor * factor * (kind == Weights::POSITIVE ? factor : 1) == e.values[i],
                 tolerance(1e-9));
      for (std::size_t v = 0; v < s.points.size(); ++v)
      {
        BOOST_REQUIRE(std::abs(f.functions[i][v] * factor - e.functions[i][v]) < 1e-6);
      }
    }
  }
  const auto d = geodesic_distance(s, {3}), b = geodesic_distance(t, {3});
  for (std::size_t v = 0; v < s.points.size(); ++v) { BOOST_REQUIRE(std::abs(b[v] / factor - d[v]) < 1e-9); }
}

BOOST_DATA_TEST_CASE(numbers_do_not_matter, data::xrange(3), seed)
{
  const auto s = potato();
  const auto t = sample::renumbered(s, seed);
  std::map<Point, Index> at;
  for (Index v = 0; v < s.number_of_vertices(); ++v) { at[t.points[v]] = v; }
  const auto e = eigenfunctions(s, 6), f = eigenfunctions(t, 6);
  const auto d = geodesic_distance(s, {3}), b = geodesic_distance(t, {at[s.points[3]]});
  for (Index v = 0; v < s.number_of_vertices(); ++v)
  {
    const Index w = at[s.points[v]];
    for (int i = 0; i <= 6; ++i) { BOOST_REQUIRE(std::abs(f.functions[i][w] - e.functions[i][v]) < 1e-6); }
    BOOST_REQUIRE(std::abs(b[w] - d[v]) < 1e-9);
  }
  for (int i = 1; i <= 6; ++i) { BOOST_TEST(f.values[i] == e.values[i], tolerance(1e-9)); }
  const auto [low, high] = find_curved_extrema(s, make_closed_model(s), e);
  const auto [other_low, other_high] = find_curved_extrema(t, make_closed_model(t), f);
  BOOST_TEST(other_low == at[s.points[low]]);
  BOOST_TEST(other_high == at[s.points[high]]);
}

BOOST_AUTO_TEST_CASE(areas_of_nodes_add_up)
{
  const auto s = sample::punctured(sample::torus(30, 18), {5, 200, 400});
  const auto areas = node_areas(s, make_closed_model(s));
  BOOST_TEST(std::accumulate(areas.begin(), areas.end(), 0.) == area(s), tolerance(1e-12));
  // A loop has a third of each face at each of its corners.
  const auto g = make_closed_model(s);
  double loop = 0;
  for (Index h = 0; h < s.number_of_halfedges(); ++h)
  {
    const auto& t = s.triangles[h / 3];
    if (g.node[s.source(h)] == g.first_loop_node)
    {
      loop += norm(cross(s.points[t[1]] - s.points[t[0]], s.points[t[2]] - s.points[t[0]])) / 6;
    }
  }
  BOOST_TEST(areas[g.first_loop_node] == loop, tolerance(1e-12));
  for (double a : node_areas(sample::scaled(s, 0), g)) { BOOST_REQUIRE(a > 0); }
}

// Known answer: the ends of an egg.
BOOST_AUTO_TEST_CASE(curved_extrema_of_an_ellipsoid_are_its_ends)
{
  auto s = sample::sphere(4);
  for (Point& p : s.points) { p[0] *= 3; }
  const auto [a, b] = find_curved_extrema(s, make_closed_model(s), eigenfunctions(s, 6));
  BOOST_TEST(std::min(a, b) == 0);
  BOOST_TEST(std::max(a, b) == 1);

  // Functions made by hand: the height has its extrema elsewhere; a function and its negative have the same ones.
  const auto g = make_closed_model(s);
  Eigenfunctions e;
  e.values = {0, 1};
  e.functions.resize(2);
  for (const Point& p : s.points) { e.functions[1].push_back(p[2]); }
  BOOST_TEST((find_curved_extrema(s, g, e) == std::make_pair(Index(5), Index(4))));
  e.values = {0, 1, 1};
  e.functions.resize(3);
  for (Index v = 0; v < s.number_of_vertices(); ++v)
  {
    e.functions[1][v] = s.points[v][0];
    e.functions[2].push_back(-s.points[v][0]);
  }
  const auto [c, d] = find_curved_extrema(s, g, e);
  BOOST_TEST(c + d == 1);
}

BOOST_AUTO_TEST_CASE(curved_extrema_keep_off_loops_where_they_can)
{
  auto s = sample::punctured(sample::torus(30, 18), {5, 200, 400});
  const auto g = make_closed_model(s);
  const auto [a, b] = find_curved_extrema(s, g, eigenfunctions(s, 8));
  BOOST_TEST(a != b);
  BOOST_TEST((!g.is_loop(a) && !g.is_loop(b)));
  Eigenfunctions e;
  e.values = {0, 1};
  e.functions.resize(2);
  for (Index v : g.representative) { e.functions[1].push_back(s.points[v][0] * s.points[v][1]); }
  // beyond all others
  for (Index n = g.first_loop_node; n < g.number_of_nodes; ++n) { e.functions[1][n] = n % 2 ? 9 : -9; }
  const auto [i, j] = find_curved_extrema(s, g, e);
  BOOST_TEST((!g.is_loop(i) && !g.is_loop(j)));
  // A disc with one interior vertex has two nodes, both extrema.
  const auto t = sample::without(sample::sphere(0), [](Index f) { return f >= 4; });
  const auto h = make_closed_model(t);
  BOOST_REQUIRE(h.number_of_nodes == 2);
  const auto [c, d] = find_curved_extrema(t, h, eigenfunctions(t, 1));
  BOOST_TEST(c + d == 1);
}

// Known answer: another solver finds the same field.
BOOST_AUTO_TEST_CASE(a_solver_of_cgal_can_take_the_place_of_ours)
{
  const auto s = sample::sphere(3);
  const auto ours = geodesic_distance(s, {0}), theirs = geodesic_distance(s, {0}, adapt_solver<Cholesky_traits>);
  for (std::size_t v = 1; v < ours.size(); ++v) { BOOST_TEST(ours[v] == theirs[v], tolerance(1e-9)); }
}

BOOST_AUTO_TEST_CASE(what_cannot_be_solved_is_refused)
{
  const auto s = sample::sphere(2);
  const auto g = make_closed_model(s);
  const auto mass = node_areas(s, g);
  auto weights = edge_weights(s, Weights::COTANGENT);
  BOOST_CHECK_THROW(find_eigenfunctions(g, weights, mass, 0), Invalid_input_error);
  BOOST_CHECK_THROW(find_eigenfunctions(g, weights, mass, g.number_of_nodes), Invalid_input_error);
  BOOST_CHECK_THROW(geodesic_distance(s, {}), Invalid_input_error);
  BOOST_CHECK_THROW(find_eigenfunctions(g, weights, mass, 3, adapt_solver<Failing_solver>), Solver_error);
  BOOST_CHECK_THROW(find_eigenfunctions(g, weights, mass, 3, adapt_solver<Wrong_solver>), Solver_error);
  BOOST_CHECK_THROW(geodesic_distance(s, {0}, adapt_solver<Failing_solver>), Solver_error);
  BOOST_CHECK_THROW(geodesic_distance(s, {0}, adapt_solver<Wrong_solver>), Solver_error);
  weights[7] = weights[s.opposite[7]] = std::numeric_limits<double>::quiet_NaN();
  BOOST_CHECK_THROW(find_eigenfunctions(g, weights, mass, 3), Solver_error);
}

// Known answer: great circles. Measured: 0.0232, 0.0130 and 0.0078.
BOOST_DATA_TEST_CASE(distance_on_the_sphere_is_that_along_great_circles, data::make({4, 5, 6}), levels)
{
  const auto s = sample::sphere(levels);
  std::vector<double> expected;
  for (const Point& p : s.points) { expected.push_back(std::acos(std::max(-1., std::min(1., p[0])))); }
  const auto d = geodesic_distance(s, {0});
  BOOST_TEST(d[0] == 0.);
  BOOST_TEST(mean_relative_error(d, expected) < (levels == 4 ? 0.03 : levels == 5 ? 0.015 : 0.008));
}

// Oracle: CGAL's exact shortest paths, and its heat method. Measured: 0.015 to 0.037 from the paths, as CGAL's own, and
// 5e-6 from CGAL's.
BOOST_DATA_TEST_CASE(distance_agrees_with_shortest_paths, data::xrange(4), which)
{
  const Triangle_surface s = which == 0   ? sample::sphere(4)
                             : which == 1 ? sample::noisy(sample::torus(60, 30), 0.05, 1)
                             : which == 2
                               ? potato()
                               : sample::punctured(sample::noisy(sample::torus(60, 30), 0.05, 1), {5, 800, 1200});
  const Index source = 17;
  const auto d = geodesic_distance(s, {source}), exact = exact_distance(s, source), cgal = cgal_distance(s, source);
  BOOST_TEST(mean_relative_error(d, exact) < 0.04);
  // On closed surfaces both solve the same equations; on the boundary CGAL's heat may be negative.
  BOOST_TEST(mean_relative_error(d, cgal) < (which == 3 ? 2e-3 : 2e-5));
}

BOOST_AUTO_TEST_CASE(distance_from_several_vertices_is_that_from_the_nearest)
{
  const auto s = sample::torus(60, 30);
  const auto both = geodesic_distance(s, {0, 900}), a = geodesic_distance(s, {0}), b = geodesic_distance(s, {900});
  std::vector<double> nearest;
  for (std::size_t v = 0; v < a.size(); ++v) { nearest.push_back(std::min(a[v], b[v])); }
  BOOST_TEST(both[0] == 0.);
  BOOST_TEST(both[900] == 0.);
  BOOST_TEST(mean_relative_error(both, nearest) < 0.05);
}

// CGAL 5.5 answers 1.8e308 on the first and does not end on the others.
BOOST_AUTO_TEST_CASE(distance_is_finite_on_long_surfaces_and_faces_without_area)
{
  const auto ring = sample::torus(8000, 6, 1200);
  const auto d = geodesic_distance(ring, {0});
  BOOST_TEST(*std::max_element(d.begin(), d.end()) == 1200 * sample::pi, tolerance(0.02));
  for (double amount : {0., 1e-16, 1e-9})
    for (int axes : {1, 2, 3})
    {
      auto s = sample::torus(40, 24);
      for (Point& p : s.points)
      {
        for (int k = 0; k < axes; ++k) { p[2 - k] *= amount; }
      }
      const auto x = geodesic_distance(s, {0});
      for (Index v = 0; v < s.number_of_vertices(); ++v)
      {
        BOOST_REQUIRE(std::isfinite(x[v]));
        if (axes < 3) { BOOST_REQUIRE(x[v] >= distance(s.points[v], s.points[0]) - 0.3); }
      }
      const auto g = make_closed_model(s);
      const auto w = make_intrinsic_delaunay_graph(s);
      const auto mass = node_areas(s, g);
      const auto e = find_eigenfunctions(w.graph, w.weights, mass, 4);
      for (int i = 0; i <= 4; ++i)
      {
        BOOST_REQUIRE((std::isfinite(e.values[i]) && e.values[i] >= 0));
        for (int j = 0; j <= i; ++j)
        {
          BOOST_TEST(std::abs(product(mass, e.functions[i], e.functions[j]) - (i == j)) < 1e-12);
        }
      }
    }
}

// Theorem: flips keep the surface: its area, the angle around every vertex, and the edges' number; in the end the
// angles across from no edge add up to more than pi.
BOOST_DATA_TEST_CASE(flips_keep_the_surface_and_end_delaunay, data::xrange(7), which)
{
  const Triangle_surface s = which == 0   ? sample::noisy(sample::plate(2, 4), 0.1, 1)
                             : which == 1 ? sample::noisy(sample::sphere(4), 0.03, 2)
                             : which == 2 ? thin_sphere(100, 10)
                             : which == 3 ? sample::noisy(sample::torus(60, 7), 0.2, 3)
                             : which == 4 ? sheared_grid(8)
                             : which == 5
                               ? sample::plate(2, 4)
                               : sample::punctured(sample::noisy(sample::torus(60, 9), 0.1, 4), {5, 200, 400});
  const auto t = make_intrinsic_delaunay(s);
  BOOST_TEST(intrinsic_area(t) == area(s), tolerance(1e-5));
  std::vector<double> angle(s.number_of_vertices(), 0), expected = angle;
  Index flipped = 0;
  for (Index h = 0; h < s.number_of_halfedges(); ++h)
  {
    expected[s.source(h)] += corner_angle(s, h);
    const Index last = t.next[t.next[h]];
    angle[t.source[h]] += std::atan2(1, t.cotangent(t.next[h]));
    BOOST_REQUIRE(t.next[last] == h);
    if (t.opposite[h] < 0) { continue; }
    flipped += t.source[h] != s.source(h);
    BOOST_REQUIRE(t.opposite[t.opposite[h]] == h);
    BOOST_REQUIRE(t.source[t.opposite[h]] == t.target(h));
    BOOST_REQUIRE((t.length[h] >= 0 && t.length[h] <= t.length[t.opposite[h]]));
    BOOST_REQUIRE(t.cotangent(h) + t.cotangent(t.opposite[h]) > -1e-8);
  }
  for (Index v = 0; v < s.number_of_vertices(); ++v) { BOOST_REQUIRE(std::abs(angle[v] - expected[v]) < 1e-3); }
  BOOST_TEST((flipped > 0 || which == 2 || which == 5));

  const auto w = make_weighted_graph(s, t);
  const auto g = make_closed_model(s);
  BOOST_TEST(w.graph.node == g.node, boost::test_tools::per_element());
  BOOST_TEST(w.graph.representative == g.representative, boost::test_tools::per_element());
  BOOST_TEST(w.graph.number_of_nodes == g.number_of_nodes);
  BOOST_TEST(w.graph.first_loop_node == g.first_loop_node);
  for (Index a = 0; a < g.number_of_nodes; ++a)
  {
    BOOST_REQUIRE(w.graph.begin[a] < w.graph.begin[a + 1]);
    for (Index i = w.graph.begin[a]; i < w.graph.begin[a + 1]; ++i)
    {
      const Index h = w.graph.halfedge[i];
      BOOST_REQUIRE(w.weights[h] > 0);
      // symmetric
      BOOST_REQUIRE((w.weights[h] <= w.weights[t.opposite[h]] && w.weights[h] >= w.weights[t.opposite[h]]));
      BOOST_REQUIRE(
        (g.node[t.source[h]] == a && w.graph.neighbor[i] == g.node[t.target(h)] && w.graph.neighbor[i] != a));
    }
  }
}

// Known answer: a flat strip whose diagonals run the long way, and its weights. Flips turn every diagonal.
BOOST_AUTO_TEST_CASE(diagonals_of_a_sheared_grid_are_turned)
{
  constexpr int n = 12;
  const auto s = sheared_grid(n);
  const auto t = make_intrinsic_delaunay(s);
  int turned = 0;
  for (Index h = 0; h < t.number_of_halfedges(); ++h)
  {
    const Point along = s.points[t.target(h)] - s.points[t.source[h]];
    BOOST_TEST(t.length[h] == norm(along), tolerance(1e-4));
    turned += std::abs(along[1]) > 0.5 && along[0] * along[1] < -0.1; // (1 - 0.4, -1)
  }
  BOOST_TEST(turned == 2 * n * n);
}

// Maximum principle on thin faces: cotangent weights of the surface break it, those of the intrinsic triangulation do
// not.
BOOST_DATA_TEST_CASE(intrinsic_weights_leave_no_other_extrema, data::xrange(4), which)
{
  const Triangle_surface s = which == 0   ? thin_sphere(60, 6)
                             : which == 1 ? sample::noisy(sample::torus(240, 8), 0.1, 1)
                             : which == 3
                               ? sample::noisy(sample::dumbbell(60), 0.25, 1) // with flat regions
                               : sample::punctured(sample::noisy(sample::torus(240, 12), 0.1, 2), {5, 300, 700});
  const auto g = make_closed_model(s);
  const Index low = which == 3 ? 400 : 3, high = which == 3 ? 500 : g.number_of_nodes - 5;
  const auto extrema = [&](const Closed_model& joined, const Scalar_field& field) {
    int count = 0;
    for (Index a = 0; a < g.number_of_nodes; ++a)
    {
      bool is_low = true, is_high = true;
      const Index r = field.region_of(a);
      for (Index i = joined.begin[a]; i < joined.begin[a + 1]; ++i)
      {
        const double x = field.value_in(r, joined.neighbor[i]);
        is_low = is_low && x >= field.value[a];
        is_high = is_high && x <= field.value[a];
      }
      count += is_low || is_high;
    }
    return count;
  };
  const auto w = make_intrinsic_delaunay_graph(s);
  BOOST_TEST(extrema(w.graph, solve_harmonic_field(s, g, w.graph, w.weights, {{low, 0}, {high, 1}})) == 2);
  const auto on_mesh = edge_weights(s, Weights::COTANGENT);
  if (which == 1 || which == 2)
  {
    BOOST_TEST(extrema(g, solve_harmonic_field(s, g, on_mesh, {{low, 0}, {high, 1}})) > 2);
  }
}

// A solver's graph of its own changes nothing if it is the surface's.
BOOST_AUTO_TEST_CASE(a_field_on_a_delaunay_surface_is_the_same_in_both_graphs)
{
  const auto s = sample::sphere(4);
  const auto g = make_closed_model(s);
  const auto w = make_intrinsic_delaunay_graph(s);
  const auto a = solve_harmonic_field(s, g, edge_weights(s, Weights::COTANGENT), {{0, 0}, {1, 1}});
  const auto b = solve_harmonic_field(s, g, w.graph, w.weights, {{0, 0}, {1, 1}});
  for (Index v = 0; v < g.number_of_nodes; ++v) { BOOST_REQUIRE(std::abs(a(v) - b(v)) < 1e-4); }
  // Flat regions with a handle are solved again in any graph.
  const auto bell = sample::dumbbell(60);
  const auto h = make_closed_model(bell);
  const auto x = make_intrinsic_delaunay_graph(bell);
  BOOST_TEST(solve_harmonic_field(bell, h, x.graph, x.weights, {{400, 0}, {500, 1}}).regions.size() > 1u);
}

// Known answer on a badly shaped surface.
BOOST_AUTO_TEST_CASE(eigenvalues_of_a_badly_shaped_sphere_with_intrinsic_weights)
{
  auto s = sample::sphere(5);
  std::mt19937 random(1);
  for (Point& p : s.points) // moved on the sphere by up to most of an edge
  {
    for (double& x : p) { x += 0.025 * (static_cast<double>(random()) / 4294967296. - 0.5); }
    p = (1 / norm(p)) * p;
  }
  const auto w = make_intrinsic_delaunay_graph(s);
  const auto e = find_eigenfunctions(w.graph, w.weights, node_areas(s, w.graph), 8);
  for (int i = 1; i < 9; ++i) { BOOST_TEST(e.values[i] == (i < 4 ? 2. : 6.), tolerance(5e-3)); }
}
