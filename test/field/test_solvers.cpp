// Sparse matrices and their solvers, on Laplacians of surfaces and on matrices made to be hard.
#include "support/sample_surfaces.h"

#include "field/multilevel.h"

#include <meridian/base/vectors.h>
#include <meridian/field/Scalar_field.h>
#include <meridian/field/Sparse_matrix.h>
#include <meridian/field/Sparse_solver.h>
#include <meridian/field/edge_weights.h>
#include <meridian/field/solve_harmonic_field.h>
#include <meridian/surface/Closed_model.h>
#include <meridian/surface/Triangle_surface.h>

#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

#include <cmath>
#include <numeric>
#include <random>

namespace data = boost::unit_test::data;
using namespace meridian;

namespace {

constexpr Index side = 160;        // of a grid with more unknowns than are solved for directly
constexpr Index halved_side = 240; // the same, with unknowns that are worked on in halves

// The Laplacian of a graph with some unknowns at rest, as -1 in `row`; `weight(e)` is that of the edge of halfedge `e`.
template <class Weight>
Sparse_matrix laplacian(const Closed_model& g, const std::vector<Index>& row, const Weight& weight)
{
  Sparse_matrix a;
  for (Index v = 0; v < g.number_of_nodes; ++v)
  {
    if (row[v] < 0) { continue; }
    double diagonal = 0;
    for (Index i = g.begin[v]; i < g.begin[v + 1]; ++i)
    {
      const double w = weight(g.halfedge[i]);
      diagonal += w;
      if (row[g.neighbor[i]] >= 0) { a.add(row[g.neighbor[i]], -w); }
    }
    a.add(row[v], diagonal);
    a.end_row();
  }
  return a;
}

std::vector<Index> all_but_first(const Closed_model& g)
{
  std::vector<Index> row(g.number_of_nodes, -1);
  for (Index v = 1; v < g.number_of_nodes; ++v) { row[v] = v - 1; }
  return row;
}

std::vector<double> product(const Sparse_matrix& a, const std::vector<double>& x)
{
  std::vector<double> y(x.size(), 0);
  for (Index i = 0; i < a.rows(); ++i)
    for (Index k = a.begin(i); k < a.end(i); ++k) { y[i] += a.value(k) * x[a.column(k)]; }
  return y;
}

// The largest |b - A x| beside what rounding may leave: the sum of all that was added up.
double residual(const Sparse_matrix& a, const std::vector<double>& x, const std::vector<double>& b)
{
  double worst = 0, largest = 0;
  const std::vector<double> y = product(a, x);
  for (Index i = 0; i < a.rows(); ++i)
  {
    worst = std::max(worst, std::abs(b[i] - y[i]));
    largest = std::max(largest, std::abs(b[i]));
  }
  return worst / largest;
}

std::vector<double> some_numbers(std::size_t n, unsigned seed)
{
  std::mt19937 random(seed);
  std::vector<double> x(n);
  for (double& value : x) { value = static_cast<double>(random() % 20001) / 10000 - 1; }
  return x;
}

std::vector<double> solution_of(Sparse_solver& solver, const Sparse_matrix& a, const std::vector<double>& b)
{
  std::vector<double> x;
  BOOST_REQUIRE(solver.factor(a));
  BOOST_REQUIRE(solver.solve(b, x));
  return x;
}

double largest_difference(const std::vector<double>& x, const std::vector<double>& y)
{
  double most = 0;
  for (std::size_t i = 0; i < x.size(); ++i) { most = std::max(most, std::abs(x[i] - y[i])); }
  return most;
}

const std::string iterative = "conjugate gradients with smoothed aggregation";

} // namespace

BOOST_AUTO_TEST_CASE(rows_are_sorted_and_values_of_one_place_are_summed_in_their_order)
{
  for (const Index width : {5, 100}) // a short row and a long one
  {
    Sparse_matrix a(1);
    for (Index c : {width, Index(2), width - 1}) { a.add(c, 1e16); }
    for (Index c = 0; c < width; ++c) { a.add(width - 1 - c, c == width - 3 ? 1. : 0.5); }
    for (Index c : {width, Index(2), width - 1}) { a.add(c, -1e16); }
    a.end_row();
    a.add(0, 3);
    a.end_row();
    BOOST_TEST(a.rows() == 2);
    BOOST_TEST(a.end(0) - a.begin(0) == width + 1);
    for (Index k = a.begin(0); k < a.end(0); ++k) { BOOST_TEST(a.column(k) == k); }
    BOOST_TEST(a.value(a.place(0, 2)) == (1e16 + 1.) - 1e16); // 0 or 2: it is rounded on the way
    BOOST_TEST(a.value(a.place(0, width)) == 0);
    BOOST_TEST(a.value(a.place(1, 0)) == 3);
  }
}

BOOST_AUTO_TEST_CASE(a_factorization_is_made_anew_for_other_values_and_other_places)
{
  const auto s = sample::torus(12, 9);
  const auto g = make_closed_model(s);
  const auto row = all_but_first(g);
  const auto b = some_numbers(g.number_of_nodes - 1, 1);
  for (auto make : {make_symmetric_solver, make_general_solver, make_laplace_solver})
  {
    const auto solver = make();
    for (double factor : {1., 7.})
    {
      const auto a = laplacian(g, row, [&](Index h) { return s.edge(h) % 5 == 0 ? factor : 1.; });
      BOOST_TEST(residual(a, solution_of(*solver, a, b), b) < 1e-12);
    }
    Sparse_matrix diagonal;
    for (Index i = 0; i < g.number_of_nodes - 1; ++i)
    {
      diagonal.add(i, 2);
      diagonal.end_row();
    }
    const auto x = solution_of(*solver, diagonal, b);
    for (std::size_t i = 0; i < b.size(); ++i) { BOOST_TEST(x[i] == b[i] / 2, boost::test_tools::tolerance(1e-15)); }
  }
}

// Each unknown becomes two, as the coordinates of a point: side by side, as pairs with the same neighbours, or the
// second ones after all first; or side by side with one place more, so that they are pairs no longer.
BOOST_AUTO_TEST_CASE(unknowns_in_pairs_are_solved_for_as_others_are)
{
  const auto s = sample::torus(12, 9);
  const auto g = make_closed_model(s);
  const auto a = laplacian(g, all_but_first(g), [](Index) { return 1.; });
  const Index n = a.rows();
  enum class Numbers
  {
    SIDE_BY_SIDE,
    ONE_AFTER_THE_OTHER,
    NOT_QUITE_PAIRS
  };
  for (Numbers numbers : {Numbers::SIDE_BY_SIDE, Numbers::ONE_AFTER_THE_OTHER, Numbers::NOT_QUITE_PAIRS})
  {
    const bool is_apart = numbers == Numbers::ONE_AFTER_THE_OTHER;
    Sparse_matrix both;
    for (Index at = 0; at < 2 * n; ++at)
    {
      const Index i = is_apart ? at % n : at / 2, k = is_apart ? at / n : at % 2;
      for (Index e = a.begin(i); e < a.end(i); ++e)
        for (Index l : {0, 1})
        {
          both.add(is_apart ? l * n + a.column(e) : 2 * a.column(e) + l, (k == l ? 1 : 0.25) * a.value(e));
        }
      if (numbers == Numbers::NOT_QUITE_PAIRS && (at == 0 || at == 2 * n - 1)) { both.add(2 * n - 1 - at, 0.125); }
      both.end_row();
    }
    const auto x = some_numbers(2 * n, 5), b = product(both, x);
    const auto solver = make_symmetric_solver();
    for (int times = 0; times < 2; ++times) // the second time nothing is ordered
    {
      BOOST_TEST(largest_difference(solution_of(*solver, both, b), x) < 1e-11);
    }
  }
}

BOOST_AUTO_TEST_CASE(small_systems_are_solved_directly_and_large_ones_level_by_level)
{
  for (const Index n : {Index(20), side, halved_side})
  {
    const auto s = sample::noisy(sample::torus(n, n), 0.002, 1);
    const auto g = make_closed_model(s);
    const auto w = edge_weights(s, Weights::POSITIVE);
    const auto a = laplacian(g, all_but_first(g), [&](Index h) { return w[h]; });
    const auto exact = some_numbers(a.rows(), 2), b = product(a, exact);
    const auto solver = make_laplace_solver(), direct = make_symmetric_solver();
    const auto x = solution_of(*solver, a, b);
    BOOST_TEST(solver->description() == (n < side ? "direct" : iterative));
    BOOST_TEST((solver->residual() > 0) == (n >= side));
    BOOST_TEST(residual(a, x, b) < 1e-7);
    BOOST_TEST(largest_difference(x, exact) < (n < side ? 1e-10 : 1e-5));
    BOOST_TEST(largest_difference(x, solution_of(*direct, a, b)) < (n < side ? 1e-10 : 1e-5));
    BOOST_TEST((x == solution_of(*make_laplace_solver(), a, b))); // the same digits again
  }
}

// Theorem (Saad 2003, 9.2): conjugate gradients need a preconditioner that is symmetric and positive. One cycle is,
// also where two halves of the unknowns are smoothed side by side.
BOOST_AUTO_TEST_CASE(a_cycle_through_levels_is_symmetric_and_positive)
{
  for (const Index n : {Index(40), halved_side})
  {
    const auto s = sample::renumbered(sample::noisy(sample::torus(n, n), 0.002, 1), 8);
    const auto g = make_closed_model(s);
    const auto w = edge_weights(s, Weights::POSITIVE);
    const auto a = laplacian(g, all_but_first(g), [&](Index h) { return w[h]; });
    std::vector<double> scale;
    for (Index i = 0; i < a.rows(); ++i) { scale.push_back(1 / std::sqrt(a.value(a.place(i, i)))); }
    internal::Unit_matrix matrix;
    std::vector<double> smooth;
    for (Index i = 0; i < a.rows(); ++i)
    {
      std::vector<std::pair<Index, double>> row;
      for (Index k = a.begin(i); k < a.end(i); ++k)
      {
        if (a.column(k) != i) { row.emplace_back(a.column(k), a.value(k) * scale[i] * scale[a.column(k)]); }
      }
      matrix.add_row(row);
      smooth.push_back(1 / scale[i]);
    }
    internal::Multilevel cycle(matrix, smooth);
    const auto u = some_numbers(a.rows(), 3), v = some_numbers(a.rows(), 4);
    std::vector<double> of_u(u.size()), of_v(v.size());
    cycle.solve(u, of_u);
    cycle.solve(v, of_v);
    const auto dot = [](const auto& x, const auto& y) { return std::inner_product(x.begin(), x.end(), y.begin(), 0.); };
    BOOST_TEST(dot(of_u, u) > 0);
    BOOST_TEST(std::abs(dot(of_u, v) - dot(u, of_v)) < 1e-12 * std::sqrt(dot(of_u, u) * dot(of_v, v)));
  }
}

BOOST_DATA_TEST_CASE(weights_of_any_size_are_solved_for, data::make({3, 6, 9}), decades)
{
  const auto s = sample::torus(side, side);
  const auto g = make_closed_model(s);
  std::mt19937 random(static_cast<unsigned>(decades));
  std::vector<double> w(s.number_of_halfedges());
  for (Index h = 0; h < s.number_of_halfedges(); ++h)
  {
    if (s.edge(h) == h) { w[h] = std::pow(10., decades * (static_cast<double>(random() % 2001) / 1000 - 1)); }
  }
  for (Index h = 0; h < s.number_of_halfedges(); ++h) { w[h] = w[s.edge(h)]; }
  const auto solver = make_laplace_solver();
  const auto a = laplacian(g, all_but_first(g), [&](Index h) { return w[h]; });
  std::vector<double> b(a.rows(), 0);
  b[a.rows() / 2] = 1;
  BOOST_TEST(residual(a, solution_of(*solver, a, b), b) < 1e-5);
  BOOST_TEST(solver->description() == iterative);
  const Scalar_field f = solve_harmonic_field(s, g, w, {{0, 0.}, {g.number_of_nodes / 2, 1.}});
  for (Index v = 0; v < g.number_of_nodes; ++v) // the maximum principle
  {
    BOOST_REQUIRE(f(v) > -1e-5);
    BOOST_REQUIRE(f(v) < 1 + 1e-5);
  }
}

BOOST_AUTO_TEST_CASE(a_field_does_not_depend_on_the_numbers_of_vertices_or_on_the_solver)
{
  const auto s = sample::noisy(sample::torus(side, side), 0.002, 3);
  const auto field = [](const Triangle_surface& t, Index low, Index high, Make_solver make) {
    const auto g = make_closed_model(t);
    const auto f =
      solve_harmonic_field(t, g, edge_weights(t, Weights::POSITIVE), {{g.node[low], 0.}, {g.node[high], 1.}}, make);
    std::vector<double> at;
    for (Index v = 0; v < t.number_of_vertices(); ++v) { at.push_back(f(g.node[v])); }
    return at;
  };
  const Index high = s.number_of_vertices() / 2;
  const auto expected = field(s, 0, high, make_symmetric_solver);
  BOOST_TEST(largest_difference(field(s, 0, high, make_laplace_solver), expected) < 1e-6);
  const auto other = sample::renumbered(s, 5);
  std::map<std::array<double, 3>, Index> number;
  for (Index v = 0; v < other.number_of_vertices(); ++v) { number[other.points[v]] = v; }
  const auto there = field(other, number.at(s.points[0]), number.at(s.points[high]), make_laplace_solver);
  std::vector<double> back;
  for (Index v = 0; v < s.number_of_vertices(); ++v) { back.push_back(there[number.at(s.points[v])]); }
  BOOST_TEST(largest_difference(back, expected) < 1e-6);
}

BOOST_AUTO_TEST_CASE(what_does_not_converge_is_solved_directly)
{
  // The square of a Laplacian: positive definite, but of the fourth order.
  const auto s = sample::torus(side, side);
  const auto g = make_closed_model(s);
  const auto a = laplacian(g, all_but_first(g), [](Index) { return 1.; });
  Sparse_matrix square;
  for (Index i = 0; i < a.rows(); ++i)
  {
    for (Index k = a.begin(i); k < a.end(i); ++k)
      for (Index l = a.begin(a.column(k)); l < a.end(a.column(k)); ++l)
      {
        square.add(a.column(l), a.value(k) * a.value(l));
      }
    square.end_row();
  }
  const auto solver = make_laplace_solver();
  const auto b = some_numbers(a.rows(), 4), x = solution_of(*solver, square, b);
  BOOST_TEST(solver->description() == "direct");
  BOOST_TEST(solver->residual() == 0);
  BOOST_TEST(residual(square, x, b) < 1e-5);

  Sparse_matrix negative; // and what no solver takes is refused
  for (Index i = 0; i < side * side; ++i)
  {
    negative.add(i, i == 7 ? -1 : 1);
    negative.end_row();
  }
  BOOST_TEST(!make_laplace_solver()->factor(negative));
}
