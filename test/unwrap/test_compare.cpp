#include "support/implicit_surfaces.h"
#include "support/pipeline.h"
#include "support/sample_surfaces.h"

#include <meridian/base/Polygon_soup.h>
#include <meridian/base/exceptions.h>
#include <meridian/base/vectors.h>
#include <meridian/curves/contours.h>
#include <meridian/curves/sleeve.h>
#include <meridian/cut/Cut.h>
#include <meridian/cut/Cut_options.h>
#include <meridian/map/planar_map.h>
#include <meridian/result/discs_of.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/unwrap/compare_parameterizations.h>
#include <meridian/unwrap/cut_family.h>

#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

#include <Eigen/Eigenvalues>

#include <set>

namespace data = boost::unit_test::data;
using namespace meridian;

namespace {

constexpr auto all_weights = all<Map_weights>();

Triangle_surface surface(int which)
{
  switch (which)
  {
  case 0: return sample::noisy(sample::torus(48, 24), 0.03, 1);
  case 1: return sample::bitorus(26);
  case 2: return sample::noisy(sample::punctured(sample::torus(40, 20), {7, 410}), 0.02, 4);
  case 3: return sample::noisy(sample::plate(1, 8), 0.02, 2);
  case 4: return sample::sphere(4); // a closed sphere is cut along one path
  default: return sample::teapot(26);
  }
}

// Cuts that differ in everything that may be chosen.
std::vector<Cut> make_cuts(const Triangle_surface& s)
{
  std::vector<Cut_options> all(7);
  pipeline::contours(all[1]).preference = preference::short_length;
  pipeline::contours(all[1]).levels = Levels::TIGHT;
  all[2].method = By_tree_cotree{-1, 4};
  all[3].method = By_tree_cotree{s.number_of_vertices() / 2};
  all[4].method = By_generators();
  pipeline::contours(all[5]).minima = {9};
  pipeline::contours(all[5]).maxima = {s.number_of_vertices() - 5};
  all[5].tightening = Tightening::NONE;
  all[6].method = By_removing_faces();
  std::vector<Cut> cuts;
  for (const Cut_options& o : all) { cuts.push_back(pipeline::cut(s, o.tightening ? o : pipeline::tight_curves(o))); }
  return cuts;
}

std::vector<Cut_disc> make_discs(const Triangle_surface& s)
{
  std::vector<Cut_disc> discs;
  for (const Cut& cut : make_cuts(s)) { discs.push_back(cut_disc_of(s, cut)); }
  return discs;
}

// The boundary edges of a disc.
std::set<std::array<Point, 2>> seam_of(const Cut_disc& d)
{
  std::set<std::array<Point, 2>> seam;
  for (Index h = 0; h < d.disc.number_of_halfedges(); ++h)
  {
    const Point &a = d.disc.points[d.disc.source(h)], &b = d.disc.points[d.disc.target(h)];
    if (d.disc.opposite[h] < 0) { seam.insert({std::min(a, b), std::max(a, b)}); }
  }
  return seam;
}

// What two cuts leave alone, from the seam flags and the parts of faces, by sets.
std::vector<Index> untouched_by_sets(const Triangle_surface& root, const Cut& a, const Cut& b)
{
  std::vector<std::set<Index>> around(root.number_of_vertices());
  std::set<Index> border, touched;
  std::map<std::pair<Index, Index>, int> uses;
  for (const auto& t : root.triangles)
    for (int k = 0; k < 3; ++k)
    {
      const Index v = t[k], w = t[(k + 1) % 3];
      around[v].insert(w);
      around[w].insert(v);
      ++uses[{std::min(v, w), std::max(v, w)}];
    }
  for (const auto& [edge, n] : uses)
  {
    if (n == 1)
    {
      border.insert(edge.first);
      border.insert(edge.second);
    }
  }
  for (const Cut* cut : {&a, &b})
  {
    const Refined_surface& s = cut->surface;
    std::vector<int> parts(root.number_of_faces(), 0);
    for (Index f : s.face_of) { ++parts[f]; }
    for (Index f = 0; f < root.number_of_faces(); ++f)
    {
      if (parts[f] != 1) { touched.insert(root.triangles[f].begin(), root.triangles[f].end()); }
    }
    for (Index h = 0; h < s.number_of_halfedges(); ++h)
      if (s.seam[h])
      {
        for (Index v : {s.source(h), s.target(h)})
        {
          if (v < root.number_of_vertices()) { touched.insert(v); }
        }
      }
  }
  std::vector<Index> result;
  for (Index v = 0; v < root.number_of_vertices(); ++v)
  {
    std::set<Index> one{v};
    one.insert(around[v].begin(), around[v].end());
    std::set<Index> two = one;
    for (Index w : one) { two.insert(around[w].begin(), around[w].end()); }
    const bool is_inner = std::none_of(one.begin(), one.end(), [&](Index w) { return border.count(w) > 0; });
    const bool is_free = std::none_of(two.begin(), two.end(), [&](Index w) { return touched.count(w) > 0; });
    if (is_inner && is_free) { result.push_back(v); }
  }
  return result;
}

// A plane grid of n x n unit squares, centered at the origin: a disc that nothing cuts.
Triangle_surface grid(int n)
{
  Triangle_surface s;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) { s.points.push_back({i - n / 2., j - n / 2., 0}); }
  const auto id = [&](int i, int j) { return static_cast<Index>(i * (n + 1) + j); };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
    {
      s.triangles.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
      s.triangles.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
    }
  return sample::connected(std::move(s));
}

template <class Function> std::vector<Plane_point> map_grid(const Triangle_surface& s, const Function& f)
{
  std::vector<Plane_point> at;
  for (const Point& p : s.points) { at.push_back(f(p[0], p[1])); }
  return at;
}

std::vector<Plane_point> moved(std::vector<Plane_point> at, double scale, double angle, const Plane_point& by)
{
  for (Plane_point& p : at)
    p =
      scale
        * Plane_point{std::cos(angle) * p[0] - std::sin(angle) * p[1], std::sin(angle) * p[0] + std::cos(angle) * p[1]}
      + by;
  return at;
}

void check_close(const Map_comparison& a, const Map_comparison& b, double factor = 1)
{
  BOOST_REQUIRE(a.untouched.size() == b.untouched.size());
  const auto near = boost::test_tools::tolerance(1e-9);
  BOOST_TEST(a.variation * factor == b.variation, near);
  BOOST_TEST(a.bound * factor == b.bound, near);
  BOOST_TEST(a.diameter * factor == b.diameter, near);
  BOOST_TEST(a.relative_variation == b.relative_variation, near);
  BOOST_TEST(a.relative_bound == b.relative_bound, near);
}

} // namespace

// Theorem: the bound holds. It is not zero by construction, and both maps obey their equations to rounding.
BOOST_DATA_TEST_CASE(the_variation_is_at_least_the_bound, data::xrange(6), which)
{
  const auto s = surface(which);
  const auto discs = make_discs(s);
  int compared = 0;
  double least = 1, most = 0;
  for (std::size_t i = 0; i < discs.size(); ++i)
    for (std::size_t j = i + 1; j < discs.size(); ++j)
    {
      for (Map_weights kind : all_weights)
      {
        const auto c = compare_parameterizations(s, discs[i], discs[j], kind);
        BOOST_TEST(c.bound <= c.variation);
        BOOST_TEST(c.residual[0] < 1e-12);
        BOOST_TEST(c.residual[1] < 1e-12);
        BOOST_TEST(c.relative_variation <= 1);
        // curves may differ by rounding alone
        if (c.untouched.size() < 2 || discs[i].is_touched == discs[j].is_touched) { continue; }
        ++compared;
        BOOST_TEST(c.bound > 0);
        BOOST_TEST(c.bound > 0.99 * c.discrepancy / c.norm); // what rounding takes off is next to nothing
        if (kind != Map_weights::COTANGENT) { BOOST_TEST((c.flipped[0] == 0 && c.flipped[1] == 0)); }
        least = std::min(least, c.bound / c.variation);
        most = std::max(most, c.bound / c.variation);
      }
    }
  BOOST_TEST(compared >= 15);
  BOOST_TEST_MESSAGE("surface " << which << ", " << s.number_of_vertices() << " vertices: " << compared
                                << " comparisons, bound / variation " << least << " to " << most);
}

BOOST_AUTO_TEST_CASE(the_bound_holds_for_members_of_a_family)
{
  const auto s = sample::bitorus(24);
  std::vector<Cut_disc> discs;
  for (const Family_member& member : Cut_family(s, 8)) { discs.push_back(cut_disc_of(s, member.cut)); }
  BOOST_REQUIRE(discs.size() == 8u);
  for (std::size_t i = 1; i < discs.size(); ++i)
  {
    const auto c = compare_parameterizations(s, discs.front(), discs[i], Map_weights::POSITIVE);
    BOOST_TEST(!c.untouched.empty());
    BOOST_TEST(c.bound > 0);
    BOOST_TEST(c.bound <= c.variation);
  }
}

// All numbers again, from dense matrices and other formulas.
BOOST_DATA_TEST_CASE(a_recount_with_dense_matrices_agrees, data::xrange(3) * data::xrange(3), pair, w)
{
  const auto s = sample::noisy(sample::torus(30, 15), 0.05, 3);
  const auto cuts = make_cuts(s);
  const std::array<std::array<std::size_t, 2>, 3> pairs{{{0, 1}, {3, 5}, {1, 4}}};
  const Cut &first = cuts[pairs[pair][0]], &second = cuts[pairs[pair][1]];
  const auto c = compare_parameterizations(s, cut_disc_of(s, first), cut_disc_of(s, second), all_weights[w]);
  BOOST_TEST(c.untouched == untouched_by_sets(s, first, second), boost::test_tools::per_element());
  BOOST_REQUIRE(!c.untouched.empty());

  // The Laplacian of the whole surface, one entry an edge, from the corners of each face.
  const Index n = s.number_of_vertices();
  Eigen::MatrixXd laplacian = Eigen::MatrixXd::Zero(n, n);
  const auto angle = [&](Index a, Index b, Index d) { // at a
    const Point p = s.points[b] - s.points[a], q = s.points[d] - s.points[a];
    return std::acos(dot(p, q) / norm(p) / norm(q));
  };
  for (const auto& t : s.triangles)
    for (int k = 0; k < 3; ++k)
    {
      const Index a = t[k], b = t[(k + 1) % 3], d = t[(k + 2) % 3];
      double x = 0.5; // of the edge a b, in this face
      if (all_weights[w] == Map_weights::COTANGENT) { x = 0.5 / std::tan(angle(d, a, b)); }
      if (all_weights[w] == Map_weights::POSITIVE)
      {
        x = (std::tan(angle(a, b, d) / 2) + std::tan(angle(b, a, d) / 2)) / 2 / distance(s.points[a], s.points[b]);
      }
      laplacian(a, b) -= x;
      laplacian(b, a) -= x;
      laplacian(a, a) += x;
      laplacian(b, b) += x;
    }
  const std::size_t rows = c.untouched.size();
  std::vector<char> is_inside(n, 0);
  for (Index v : c.untouched) { is_inside[v] = 1; }
  Eigen::MatrixXd inside(rows, rows), difference(rows, 2), right = Eigen::MatrixXd::Zero(rows, 2);
  for (std::size_t i = 0; i < rows; ++i)
  {
    const Index v = c.untouched[i];
    for (std::size_t j = 0; j < rows; ++j) { inside(i, j) = laplacian(v, c.untouched[j]); }
    for (int k = 0; k < 2; ++k)
    {
      difference(i, k) = c.at[0][v][k] - c.at[1][v][k];
      for (Index u = 0; u < n; ++u)
      {
        if (!is_inside[u]) { right(i, k) -= laplacian(v, u) * (c.at[0][u][k] - c.at[1][u][k]); }
      }
    }
  }
  const double top = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(inside).eigenvalues().maxCoeff();
  BOOST_TEST(c.norm >= top);
  BOOST_TEST(c.norm <= 1.001 * top);
  BOOST_TEST(c.variation == difference.norm(), boost::test_tools::tolerance(1e-12));
  BOOST_TEST(c.discrepancy == right.norm(), boost::test_tools::tolerance(1e-9));
  BOOST_TEST(c.bound == right.norm() / c.norm, boost::test_tools::tolerance(1e-9));
  // so what was solved with is what is bounded with
  BOOST_TEST((inside * difference - right).norm() < 1e-11 * right.norm());
  const double circle = std::sqrt(area(s) / sample::pi) * 2;
  BOOST_TEST(c.relative_variation == difference.norm() / std::sqrt(double(rows)) / circle,
             boost::test_tools::tolerance(1e-9));
  for (int i = 0; i < 2; ++i) // the gauge
  {
    BOOST_TEST(area_of(i ? second.opened.triangles : first.opened.triangles, c.at[i]) == area(s),
               boost::test_tools::tolerance(1e-9));
    Plane_point sum{0, 0};
    for (Index v : c.untouched) { sum = sum + c.at[i][v]; }
    BOOST_TEST(norm(sum) < 1e-10 * static_cast<double>(rows) * circle);
  }
}

BOOST_DATA_TEST_CASE(what_is_untouched_is_what_sets_say, data::xrange(6), which)
{
  const auto s = surface(which);
  const auto cuts = make_cuts(s);
  for (std::size_t i = 0; i < cuts.size(); ++i)
    for (std::size_t j = i; j < cuts.size(); j += 2)
      BOOST_TEST((find_untouched_vertices(s, cut_disc_of(s, cuts[i]), cut_disc_of(s, cuts[j]))
                  == untouched_by_sets(s, cuts[i], cuts[j])));
}

// The common sub-matrix of the paper: the weights that each disc gives the edges at J, bit for bit.
BOOST_DATA_TEST_CASE(weights_at_untouched_vertices_are_the_same_on_both_discs, data::xrange(6), which)
{
  const auto s = surface(which);
  const auto discs = make_discs(s);
  for (Map_weights kind : all_weights)
  {
    const auto on_root = map_weights(s, kind);
    std::size_t edges = 0, different = 0;
    for (std::size_t i = 0; i + 1 < discs.size(); ++i)
    {
      const Triangle_surface &a = discs[i].disc, &b = discs[i + 1].disc;
      const auto x = map_weights(a, kind), y = map_weights(b, kind);
      for (Index v : find_untouched_vertices(s, discs[i], discs[i + 1]))
        s.for_each_outgoing(v, [&](Index h) {
          const Index g = a.find_halfedge(v, s.target(h)), k = b.find_halfedge(v, s.target(h));
          BOOST_REQUIRE((g >= 0 && k >= 0));
          ++edges;
          different += x[g] != y[k] || x[g] != on_root[h] || x[a.opposite[g]] != on_root[s.opposite[h]];
        });
    }
    BOOST_TEST(edges > 0u);
    BOOST_TEST(different == 0u);
  }
}

BOOST_DATA_TEST_CASE(a_cut_does_not_differ_from_itself, data::xrange(3), w)
{
  const auto s = surface(0);
  const auto d = cut_disc_of(s, pipeline::cut(s));
  const auto c = compare_parameterizations(s, d, d, all_weights[w]);
  BOOST_TEST(c.untouched.size() > 100u);
  BOOST_TEST(c.variation == 0);
  BOOST_TEST(c.discrepancy == 0);
  BOOST_TEST(c.bound == 0);
  BOOST_TEST(c.norm > 0);
  BOOST_TEST(c.distortion[0].stretch_l2 == c.distortion[1].stretch_l2);
  BOOST_TEST(c.distortion[0].stretch_l2 >= 1 - 1e-12);
}

BOOST_DATA_TEST_CASE(the_order_of_the_cuts_does_not_matter, data::xrange(3), w)
{
  const auto s = surface(1);
  const auto discs = make_discs(s);
  for (std::size_t i = 0; i + 1 < discs.size(); ++i)
  {
    const auto a = compare_parameterizations(s, discs[i], discs[i + 1], all_weights[w]),
               b = compare_parameterizations(s, discs[i + 1], discs[i], all_weights[w]);
    check_close(a, b);
    BOOST_TEST(a.untouched == b.untouched, boost::test_tools::per_element());
    BOOST_TEST(a.distortion[0].stretch_l2 == b.distortion[1].stretch_l2, boost::test_tools::tolerance(1e-12));
  }
}

// Metamorphic: units, numbers and the position in the plane do not matter.
BOOST_DATA_TEST_CASE(a_larger_surface_varies_in_proportion, data::xrange(3), w)
{
  const auto s = surface(0);
  const auto discs = make_discs(s);
  for (double factor : {1024., 1e-7, 37.})
  {
    const auto larger = sample::scaled(s, factor);
    Cut_disc a = discs[0], b = discs[3];
    a.disc = sample::scaled(a.disc, factor);
    b.disc = sample::scaled(b.disc, factor);
    check_close(compare_parameterizations(s, discs[0], discs[3], all_weights[w]),
                compare_parameterizations(larger, a, b, all_weights[w]), factor);
  }
}

BOOST_DATA_TEST_CASE(other_numbers_of_vertices_and_faces_change_nothing, data::xrange(3), w)
{
  const auto s = surface(1);
  const auto discs = make_discs(s);
  std::mt19937 random(5);
  std::vector<Index> number(s.number_of_vertices());
  std::iota(number.begin(), number.end(), Index(0));
  for (Index i = s.number_of_vertices(); i-- > 1;) { std::swap(number[i], number[random() % (i + 1)]); }
  // the vertices of the root alone; faces in reverse, corners turned
  const auto renumbered = [&](const Triangle_surface& from) {
    Triangle_surface t = from;
    for (Index v = 0; v < s.number_of_vertices(); ++v) { t.points[number[v]] = from.points[v]; }
    for (auto& corners : t.triangles)
    {
      for (Index& v : corners)
      {
        if (v < s.number_of_vertices()) { v = number[v]; }
      }
      std::rotate(corners.begin(), corners.begin() + 1, corners.end());
    }
    std::reverse(t.triangles.begin(), t.triangles.end());
    return sample::connected(std::move(t));
  };
  const auto other = [&](const Cut_disc& d) {
    Cut_disc r{renumbered(d.disc), d.is_touched};
    for (Index v = 0; v < s.number_of_vertices(); ++v) { r.is_touched[number[v]] = d.is_touched[v]; }
    return r;
  };
  const auto a = compare_parameterizations(s, discs[0], discs[1], all_weights[w]);
  const auto b = compare_parameterizations(renumbered(s), other(discs[0]), other(discs[1]), all_weights[w]);
  check_close(a, b);
  std::vector<Index> expected;
  for (Index v : a.untouched) { expected.push_back(number[v]); }
  std::sort(expected.begin(), expected.end());
  BOOST_TEST(b.untouched == expected, boost::test_tools::per_element());
}

// What a cut touches does not depend on the side of the seam that keeps the old vertex.
BOOST_DATA_TEST_CASE(which_side_of_the_seam_keeps_a_vertex_does_not_matter, data::xrange(6), which)
{
  const auto s = surface(which);
  for (const Cut& cut : make_cuts(s))
  {
    Cut other = cut;
    std::vector<Index> name(cut.surface.number_of_vertices() + cut.opened.copy_of.size());
    std::iota(name.begin(), name.end(), Index(0));
    for (std::size_t i = 0; i < cut.opened.copy_of.size(); ++i)
    {
      std::swap(name[cut.opened.copy_of[i]], name[cut.surface.number_of_vertices() + i]);
    }
    for (auto& t : other.opened.triangles)
    {
      for (Index& v : t) { v = name[v]; }
    }
    const Cut_disc a = cut_disc_of(s, cut), b = cut_disc_of(s, other);
    BOOST_TEST((a.is_touched == b.is_touched));
  }
}

BOOST_AUTO_TEST_CASE(a_map_that_is_moved_in_the_plane_is_brought_back)
{
  const auto s = surface(0);
  const auto discs = make_discs(s);
  const auto weights = map_weights(s, Map_weights::POSITIVE);
  const auto c = compare_parameterizations(s, discs[0], discs[5], Map_weights::POSITIVE);
  const Plane_point right{3, -2};
  for (double angle : {0., 0.4, 1.9, -3.1})
    check_close(c, compare_maps(s, discs[0], discs[5], weights, {c.at[0], moved(c.at[1], 2.5, angle, right)}));
  check_close(c, compare_maps(s, discs[0], discs[5], weights, {moved(c.at[0], 0.3, 1, right), c.at[1]}));
  // No rigid motion of the second map brings it nearer.
  for (double angle : {-1e-4, 1e-4, 0.1, 2., 3.1})
    for (double x : {-1e-4, 0., 1e-4})
    {
      const auto at = moved(c.at[1], 1, angle, {x, -x});
      double square = 0;
      for (Index v : c.untouched)
      {
        const Plane_point d = at[v] - c.at[0][v];
        square += dot(d, d);
      }
      BOOST_TEST(std::sqrt(square) > c.variation);
    }
}

// Known answers on a plane grid, where cotangent weights are the five-point stencil: its norm, harmonic polynomials,
// and the bound attained by the highest eigenvector.
BOOST_DATA_TEST_CASE(the_five_point_stencil_of_a_grid, data::make({5, 6, 9, 16, 40}), n)
{
  const auto s = grid(n);
  const Cut_disc d{s, std::vector<char>(s.number_of_vertices(), 0)};
  const auto weights = map_weights(s, Map_weights::COTANGENT);
  const auto same = map_grid(s, [](double x, double y) { return Plane_point{x, y}; });
  const double bend = 0.3 / n;
  const auto bent = map_grid(s, [&](double x, double y) {
    return Plane_point{x + bend * (x * x - y * y), y + bend * 2 * x * y};
  });
  const auto c = compare_maps(s, d, d, weights, {same, bent});
  const int inside = n - 3; // vertices of J a side
  BOOST_TEST(c.untouched.size() == static_cast<std::size_t>(inside * inside));
  const double top = 4 + 4 * std::cos(sample::pi / (inside + 1));
  BOOST_TEST(c.norm >= top);
  BOOST_TEST(c.norm <= std::min(1.001 * top, 8.));
  BOOST_TEST(c.residual[1] < 1e-15);
  BOOST_TEST(c.bound > 0);
  BOOST_TEST(c.bound <= c.variation);
  BOOST_TEST(c.diameter == 2 * n / std::sqrt(sample::pi), boost::test_tools::tolerance(1e-12));
  BOOST_TEST(c.distortion[0].stretch_l2 == 1, boost::test_tools::tolerance(1e-12));
}

// A map that does not obey the equations has a large residual, and the bound holds all the same.
BOOST_DATA_TEST_CASE(the_bound_holds_for_maps_that_do_not_obey_the_equations, data::xrange(20), seed)
{
  const auto s = grid(9);
  const Cut_disc d{s, std::vector<char>(s.number_of_vertices(), 0)};
  std::mt19937 random(seed);
  const double amount = std::pow(10., -seed);
  const auto noise = [&] { return amount * (static_cast<double>(random()) / 4294967296. - 0.5); };
  const auto harmonic = [&](double x, double y) { return Plane_point{x + 0.02 * (x * x - y * y), y + 0.04 * x * y}; };
  const auto first = map_grid(s, [&](double x, double y) { return Plane_point{x, y} + Plane_point{noise(), noise()}; });
  const auto second = map_grid(s, [&](double x, double y) { return harmonic(x, y) + Plane_point{noise(), noise()}; });
  const auto c = compare_maps(s, d, d, map_weights(s, Map_weights::COTANGENT), {first, second});
  BOOST_TEST(c.bound <= c.variation);
  if (seed == 0) { BOOST_TEST(c.residual[0] > 1e-3); }
  if (seed > 3) { BOOST_TEST(c.bound > 0); }
}

// One vertex: its image is the origin of both maps, so that there is no variation, and rounding makes no bound.
BOOST_AUTO_TEST_CASE(a_single_untouched_vertex_has_no_variation)
{
  const auto s = grid(4);
  const Cut_disc d{s, std::vector<char>(s.number_of_vertices(), 0)};
  const auto same = map_grid(s, [](double x, double y) { return Plane_point{x, y}; });
  for (int i = 0; i < 50; ++i)
  {
    const auto first = moved(same, 1.3 + i, 0.7 * i, {0.1, i / 3.}),
               second = moved(same, 0.3, 0.9 * i, {7, 1. / (i + 1)});
    const auto c = compare_maps(s, d, d, map_weights(s, Map_weights::COTANGENT), {first, second});
    BOOST_TEST(c.untouched.size() == 1u);
    BOOST_TEST(c.bound == 0);
    BOOST_TEST(c.residual[0] < 1e-14);
  }
}

BOOST_AUTO_TEST_CASE(nothing_untouched_means_no_bound)
{
  const auto s = sample::torus(6, 5);
  const auto a = cut_disc_of(s, pipeline::cut(s));
  Cut_options o;
  o.method = By_tree_cotree();
  const auto c = compare_parameterizations(s, a, cut_disc_of(s, pipeline::cut(s, o)));
  BOOST_TEST(c.untouched.empty());
  BOOST_TEST(c.variation == 0);
  BOOST_TEST(c.bound == 0);
  BOOST_TEST(c.norm == 0);
  BOOST_TEST(c.distortion[0].stretch_l2 >= 1 - 1e-12);
  BOOST_TEST(c.diameter > 0);
}

// Degenerate input: faces without area, and edges without length, within J. Weights are bounded there.
BOOST_DATA_TEST_CASE(faces_without_area_do_not_break_the_equations, data::xrange(3), w)
{
  auto s = sample::noisy(sample::torus(40, 20), 0.02, 6);
  for (Index v = 5; v + 1 < s.number_of_vertices(); v += 37) { s.points[v + 1] = s.points[v]; }
  const auto discs = make_discs(s);
  std::size_t different_alone = 0;
  for (std::size_t i = 1; i < 4; ++i)
  {
    const auto c = compare_parameterizations(s, discs[0], discs[i], all_weights[w]);
    BOOST_TEST(!c.untouched.empty());
    BOOST_TEST(c.bound <= c.variation);
    BOOST_TEST(c.residual[0] < 1e-12);
    BOOST_TEST(c.residual[1] < 1e-12);
    // The discs disagree about bounded weights, so that those of the surface are taken.
    const auto on_root = map_weights(s, all_weights[w]), alone = map_weights(discs[i].disc, all_weights[w]);
    const auto used = internal::weights_on_disc(s, discs[i].disc, c.untouched, on_root, alone);
    std::size_t different = 0;
    for (Index v : c.untouched)
      s.for_each_outgoing(v, [&](Index h) {
        const Index g = discs[i].disc.find_halfedge(v, s.target(h)), o = discs[i].disc.opposite[g];
        different += used[g] != on_root[h] || used[o] != on_root[h];
        different_alone += alone[g] != on_root[h];
      });
    BOOST_TEST(different == 0u);
  }
  if (all_weights[w] == Map_weights::POSITIVE) { BOOST_TEST(different_alone > 0u); } // where there are new vertices
}

namespace {

// Two tori. The first has two fans at one point, and one vertex that no face uses; the second is of quadrilaterals,
// every third turned over.
Polygon_soup two_tori_pinched_at(Index pinched)
{
  Polygon_soup input = sample::soup(sample::noisy(sample::torus(24, 12), 0.05, 1));
  const Index n = static_cast<Index>(input.points.size()), lost = n / 2 + 40;
  for (Index& v : input.corners)
  {
    if (v == lost) { v = pinched; }
  }
  const auto other = sample::noisy(sample::torus(30, 12), 0.05, 2);
  for (const Point& p : other.points) { input.points.push_back({p[0] + 9, p[1], p[2]}); }
  for (int i = 0; i < 30; ++i)
    for (int j = 0; j < 12; ++j)
    {
      std::array<Index, 4> q{i * 12 + j, (i + 1) % 30 * 12 + j, (i + 1) % 30 * 12 + (j + 1) % 12,
                             i * 12 + (j + 1) % 12};
      for (Index& v : q) { v += n; }
      if (i % 3 == 0) { std::reverse(q.begin(), q.end()); }
      input.add_polygon(q.data(), 4);
    }
  return input;
}

} // namespace

// The same from a result's arrays: several components, polygons, faces turned over, and a pinched vertex on the seam.
BOOST_AUTO_TEST_CASE(discs_of_a_result_are_those_of_its_cuts)
{
  int separate = 0; // cuts through one fan that leave the other alone
  for (Index pinched : {30, 75, 100, 140})
  {
    const Polygon_soup input = two_tori_pinched_at(pinched);
    const Index n = 24 * 12; // vertices of the first
    std::array<pipeline::Run, 3> runs;
    for (int i = 0; i < 3; ++i)
    {
      Cut_options o;
      // the two fans: one vertex of the file is not used, so that the second is the last
      if (i > 0) { o.links.source = i == 1 ? pinched : n - 1; }
      runs[i] = pipeline::run(input, true, o);
      BOOST_REQUIRE(runs[i].verification.failures.empty());
      BOOST_REQUIRE(runs[i].examination.added_vertex_of.size() == 1u);
      const auto discs = cut_discs_of(input, runs[i].examination, runs[i].assembled.mesh);
      BOOST_REQUIRE(discs.size() == 2u);
      for (std::size_t k = 0; k < 2; ++k)
      {
        const Triangle_surface& root = runs[i].examination.components[k].surface;
        const Cut_disc expected = cut_disc_of(root, runs[i].cuts[k]);
        BOOST_TEST((discs[k].is_touched == expected.is_touched));
        BOOST_TEST(discs[k].disc.number_of_vertices() == expected.disc.number_of_vertices());
        BOOST_TEST((seam_of(discs[k]) == seam_of(expected)));
        BOOST_TEST((std::equal(root.points.begin(), root.points.end(), discs[k].disc.points.begin())));
      }
    }
    const auto last = cut_discs_of(input, runs[2].examination, runs[2].assembled.mesh)[0];
    BOOST_TEST(last.is_touched[n - 1]);
    separate += !last.is_touched[pinched];
    const auto& vertex_of = runs[2].examination.components[0].vertex_of;
    BOOST_TEST(vertex_of[pinched] == pinched);
    BOOST_TEST(vertex_of[n - 1] >= static_cast<Index>(input.points.size()));
    for (std::size_t k = 0; k < 2; ++k)
    {
      const Triangle_surface& root = runs[0].examination.components[k].surface;
      const auto a = cut_discs_of(input, runs[0].examination, runs[0].assembled.mesh)[k],
                 b = cut_discs_of(input, runs[2].examination, runs[2].assembled.mesh)[k];
      const auto c = compare_parameterizations(root, a, b);
      BOOST_TEST(!c.untouched.empty());
      BOOST_TEST(c.bound > 0);
      BOOST_TEST(c.bound <= c.variation);
      check_close(
        c, compare_parameterizations(root, cut_disc_of(root, runs[0].cuts[k]), cut_disc_of(root, runs[2].cuts[k])));
    }
  }
  BOOST_TEST(separate > 0);
}

BOOST_AUTO_TEST_CASE(extreme_units_of_a_file_are_those_of_its_surface)
{
  const auto input = sample::soup(sample::scaled(surface(0), 1e120));
  const auto a = pipeline::run(input);
  Cut_options o;
  o.method = By_tree_cotree();
  const auto b = pipeline::run(input, false, o);
  const Triangle_surface& root = a.examination.components[0].surface;
  BOOST_TEST(a.examination.components[0].unit > 1);
  const auto c = compare_parameterizations(root, cut_discs_of(input, a.examination, a.assembled.mesh)[0],
                                           cut_discs_of(input, b.examination, b.assembled.mesh)[0]);
  BOOST_TEST(c.bound > 0);
  check_close(c, compare_parameterizations(root, cut_disc_of(root, a.cuts[0]), cut_disc_of(root, b.cuts[0])));
}

BOOST_AUTO_TEST_CASE(what_does_not_belong_together_is_refused)
{
  const auto s = surface(0), other = sample::torus(48, 24), small = sample::torus(12, 8);
  const auto d = cut_disc_of(s, pipeline::cut(s)), of_small = cut_disc_of(small, pipeline::cut(small)),
             of_other = cut_disc_of(other, pipeline::cut(other));
  BOOST_CHECK_THROW(compare_parameterizations(s, d, of_small), Invalid_input_error);
  BOOST_CHECK_THROW(compare_parameterizations(s, d, of_other), Invalid_input_error); // as many vertices, elsewhere
  const Cut_disc whole{s, std::vector<char>(s.number_of_vertices(), 0)};             // not opened
  BOOST_CHECK_THROW(compare_parameterizations(s, whole, d), Invalid_input_error);
  Cut_disc denied = d;
  denied.is_touched.assign(denied.is_touched.size(), 0); // says that nothing was cut
  BOOST_CHECK_THROW(compare_parameterizations(s, denied, denied), Invalid_input_error);
  auto c = compare_parameterizations(s, d, d);
  c.at[1].pop_back();
  BOOST_CHECK_THROW(compare_maps(s, d, d, map_weights(s, Map_weights::UNIFORM), c.at), Invalid_input_error);
  BOOST_CHECK_THROW(
    compare_maps(s, d, d, map_weights(s, Map_weights::UNIFORM), {c.at[0], moved(c.at[0], 0, 0, {1, 1})}),
    Invalid_input_error);
  auto run = pipeline::run(sample::soup(small));
  const auto elsewhere = pipeline::run(sample::soup(s));
  BOOST_CHECK_THROW(cut_discs_of(sample::soup(s), elsewhere.examination, run.assembled.mesh), Invalid_input_error);
  run.assembled.mesh.component_of[3] = 7;
  BOOST_CHECK_THROW(cut_discs_of(sample::soup(small), run.examination, run.assembled.mesh), Invalid_input_error);
}
