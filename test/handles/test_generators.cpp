#include "support/pipeline.h"
#include "support/sample_surfaces.h"

#include <meridian/base/vectors.h>
#include <meridian/curves/flow_lines.h>
#include <meridian/curves/morse_complex.h>
#include <meridian/cut/Cut_options.h>
#include <meridian/cut/join_generators.h>
#include <meridian/field/Ordered_surface.h>
#include <meridian/field/critical_points.h>
#include <meridian/handles/Generators.h>
#include <meridian/handles/find_shortest_basis.h>
#include <meridian/handles/internal/linking.h>
#include <meridian/handles/internal/tree_cotree.h>
#include <meridian/proof/internal/verify_basis.h>
#include <meridian/proof/verify_cut.h>
#include <meridian/proof/verify_generators.h>
#include <meridian/result/recount.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/Surface_curve.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/insert_curves.h>
#include <meridian/surface/open_along.h>

#include <boost/test/data/test_case.hpp>

#include <cmath>
#include <random>

using namespace meridian;

namespace {

void check(const Triangle_surface& s, const Generators& g)
{
  const auto v = verify_generators(s, g);
  for (const auto& failure : v.failures) { BOOST_TEST_MESSAGE(failure); }
  BOOST_TEST(v.failures.size() == 0u);
  BOOST_TEST(static_cast<int>(g.pairs.size()) == g.genus);
  BOOST_TEST(v.curves.front().is_symplectic);
  BOOST_TEST(v.curves.front().is_basis);
}

// The classes of all curves in one fixed basis.
std::vector<std::vector<int>> classes(const Triangle_surface& s, const Generators& g)
{
  const internal::Tree_cotree trees(s);
  std::vector<std::vector<int>> rows;
  for (const auto& pair : g.pairs)
    for (const auto* c : {&pair.meridian, &pair.longitude})
    {
      std::vector<std::pair<Index, int>> crossed;
      for (Index h : internal::walk_on_root(s, g.surface, c->vertices))
      {
        crossed.emplace_back(s.edge(h), s.edge(h) == h ? 1 : -1);
      }
      rows.push_back(trees.integrate(crossed));
    }
  return rows;
}

std::vector<std::pair<std::string, Triangle_surface>> surfaces()
{
  std::vector<std::pair<std::string, Triangle_surface>> all{
    {"coarse torus", sample::torus(4, 3)},
    {"torus", sample::torus(30, 16)},
    {"plate of genus 3", sample::plate(3)},
    {"plate of genus 5", sample::plate(5, 3)},
    {"dumbbell", sample::dumbbell(12)},
    {"torus with two boundary loops", sample::punctured(sample::torus(20, 12), {30, 150})},
    {"plate with boundary loops", sample::punctured(sample::plate(2, 3), {10, 40, 90})},
    {"torus with a large hole",
     sample::without(sample::torus(20, 12), [](Index f) { return f / 24 < 16 && f / 2 % 12 < 10; })},
    {"lattice", sample::skin({5, 5, 5}, [](int i, int j, int k) { return (i % 2) + (j % 2) + (k % 2) < 2; })},
  };
  for (unsigned seed = 0; seed < 6; ++seed)
    all.push_back(
      {"noisy plate " + std::to_string(seed), sample::noisy(sample::renumbered(sample::plate(3, 2), seed), 0.4, seed)});
  return all;
}

} // namespace

BOOST_AUTO_TEST_CASE(pairs_keep_the_contract_tightened_or_not_from_flow_lines_or_arcs)
{
  for (const auto& [name, s] : surfaces()) BOOST_TEST_CONTEXT(name)
  for (bool tighten : {false, true})
    for (bool flow : {false, true})
    {
      Generator_options options;
      options.tighten = tighten;
      options.flow = flow;
      check(s, pipeline::generators(s, options));
    }
}

BOOST_AUTO_TEST_CASE(a_surface_of_genus_0_has_no_pairs)
{
  for (const Triangle_surface& s : {sample::sphere(2), sample::punctured(sample::sphere(2), {0, 1, 4})})
  {
    const Generators g = pipeline::generators(s);
    BOOST_TEST(g.pairs.empty());
    BOOST_TEST(verify_generators(s, g).failures.size() == 0u);
    BOOST_TEST(pipeline::basis(s).loops.empty());
  }
}

BOOST_AUTO_TEST_CASE(tightening_shortens_and_keeps_the_classes)
{
  for (const auto& [name, s] : surfaces())
  {
    if (boundary_loops(s).size() > 0) { continue; }
    BOOST_TEST_CONTEXT(name)
    {
      Generator_options options;
      options.tighten = false;
      const Generators loose = pipeline::generators(s, options), tight = pipeline::generators(s);
      BOOST_TEST(total_length(tight) <= total_length(loose) * (1 + 1e-9));
      BOOST_TEST((classes(s, loose) == classes(s, tight)));
    }
  }
}

BOOST_AUTO_TEST_CASE(on_a_torus_the_curves_come_close_to_the_shortest_ones)
{
  const Generators g = pipeline::generators(sample::torus(120, 60));
  // around the tube
  BOOST_TEST(g.pairs.front().meridian.length == 2 * sample::pi, boost::test_tools::tolerance(0.02));
  // the inner circle
  BOOST_TEST(g.pairs.front().longitude.length == 2 * 2 * sample::pi, boost::test_tools::tolerance(0.03));
  const Homology_basis b = pipeline::basis(sample::torus(120, 60));
  BOOST_TEST(b.loops.size() == 2u);
  BOOST_TEST(b.loops[0].length == 2 * sample::pi, boost::test_tools::tolerance(0.02));
  BOOST_TEST(b.loops[1].length == 4 * sample::pi, boost::test_tools::tolerance(0.03));
}

BOOST_AUTO_TEST_CASE(scaling_mirroring_and_refining_change_lengths_as_they_should)
{
  const Triangle_surface s = sample::noisy(sample::plate(2, 3), 0.2, 5);
  const double length = total_length(pipeline::generators(s));
  BOOST_TEST(total_length(pipeline::generators(sample::scaled(s, 8))) == 8 * length);
  BOOST_TEST(total_length(pipeline::generators(sample::mirrored(s))) == length, boost::test_tools::tolerance(0.1));
  BOOST_TEST(total_length(pipeline::generators(sample::renumbered(s, 7))) == length, boost::test_tools::tolerance(0.1));
  BOOST_TEST(total_length(pipeline::generators(sample::subdivided(s))) == length, boost::test_tools::tolerance(0.1));
  const Generators one = pipeline::generators(s), two = pipeline::generators(s);
  BOOST_TEST((one.pairs.front().longitude.vertices == two.pairs.front().longitude.vertices
              && one.surface.points == two.surface.points));
}

BOOST_AUTO_TEST_CASE(short_bases_are_bases)
{
  for (const auto& [name, s] : surfaces()) BOOST_TEST_CONTEXT(name)
  for (bool tighten : {false, true})
  {
    Basis_options options;
    options.tighten = tighten;
    const Homology_basis b = pipeline::basis(s, options);
    const auto v = verify_generators(s, b);
    for (const auto& failure : v.failures) { BOOST_TEST_MESSAGE(failure); }
    BOOST_TEST(v.failures.size() == 0u);
    BOOST_TEST(v.curves.front().is_basis);
  }
}

// Loops run through faces and edges, and where they lie there is no part of it.
BOOST_AUTO_TEST_CASE(short_bases_do_not_depend_on_where_points_are)
{
  for (const auto& [n, m] : {std::pair{3, 3}, {3, 4}, {5, 3}, {4, 4}})
    for (int kind = 0; kind < 4; ++kind)
      for (unsigned seed = 0; seed < (n * m == 9 ? 9u : 3u); ++seed)
        for (bool tighten : {false, true}) BOOST_TEST_CONTEXT(n << " x " << m << " " << kind << " " << seed)
          {
            Triangle_surface s = sample::renumbered(sample::torus(n, m), seed);
            std::mt19937 random(seed);
            const auto fraction = [&] { return static_cast<double>(random()) / 4294967296.; };
            for (Point& p : s.points)
            {
              if (kind == 0) { p = {1, 2, 3}; }
              if (kind == 1) { p = {fraction(), 0, 0}; }
              if (kind == 2) { p = {std::pow(10, 200 * fraction() - 100), 0, 0}; }
              if (kind == 3) { p = {std::floor(3 * fraction()), std::floor(3 * fraction()), 0}; }
            }
            Basis_options options;
            options.tighten = tighten;
            const auto v = verify_generators(s, pipeline::basis(s, options));
            BOOST_TEST(v.failures.size() == 0u);
            BOOST_TEST(v.curves.front().is_basis);
          }
}

// Of these points on a line a loop is shortest that runs through a face twice.
BOOST_AUTO_TEST_CASE(short_bases_of_loops_that_return_to_a_face_are_bases)
{
  Triangle_surface s;
  for (double x : {0.280, 0.603, 0.988, 0.880, 0.134, 0.854, 0.720, 0.090, 0.765}) { s.points.push_back({x, 0, 0}); }
  s.triangles = {{7, 3, 1}, {7, 1, 6}, {6, 1, 0}, {6, 0, 8}, {8, 0, 3}, {8, 3, 7}, {3, 5, 4}, {3, 4, 1}, {1, 4, 2},
                 {1, 2, 0}, {0, 2, 5}, {0, 5, 3}, {5, 7, 6}, {5, 6, 4}, {4, 6, 8}, {4, 8, 2}, {2, 8, 7}, {2, 7, 5}};
  s = sample::connected(std::move(s));
  BOOST_TEST(verify_generators(s, pipeline::basis(s)).curves.front().is_basis);
}

BOOST_AUTO_TEST_CASE(on_a_torus_the_meridian_is_a_handle_loop_and_the_longitude_a_tunnel_loop_however_it_lies)
{
  const auto expect = [](const Triangle_surface& s, Loop_class meridian, Loop_class longitude,
                         const Generator_options& options = Generator_options()) {
    const Generators g = pipeline::classified(s, options);
    BOOST_TEST(name_of(g.pairs.front().meridian.loop_class) == std::string(name_of(meridian)));
    BOOST_TEST(name_of(g.pairs.front().longitude.loop_class) == std::string(name_of(longitude)));
  };
  const Triangle_surface s = sample::torus(24, 12);
  expect(s, Loop_class::HANDLE, Loop_class::TUNNEL);
  for (const auto& [a, b] :
       {std::pair{sample::pi / 2, 0.}, {0., sample::pi / 2}, {0.3, 1.1}, {2.2, -0.7}, {1e-9, 1e-9}})
    expect(sample::rotated(s, a, b), Loop_class::HANDLE, Loop_class::TUNNEL);
  expect(sample::mirrored(s), Loop_class::HANDLE, Loop_class::TUNNEL);
  Triangle_surface inwards = s; // the normals point to the bounded side
  for (auto& t : inwards.triangles) { std::swap(t[1], t[2]); }
  expect(sample::connected(inwards), Loop_class::HANDLE, Loop_class::TUNNEL);
  // With the extrema at the bottom and at the top of the tube, contours go the long way round.
  Generator_options options;
  options.minima = {9};
  options.maxima = {3};
  for (Index i = 1; i < 24; ++i)
  {
    options.minima.push_back(i * 12 + 9);
    options.maxima.push_back(i * 12 + 3);
  }
  expect(s, Loop_class::TUNNEL, Loop_class::HANDLE, options);
  // On a plate with holes every loop bounds on one side, or on none.
  const Generators many = pipeline::classified(sample::plate(4));
  for (const auto& pair : many.pairs)
  {
    BOOST_TEST((pair.meridian.loop_class != Loop_class::UNKNOWN && pair.longitude.loop_class != Loop_class::UNKNOWN));
  }
}

BOOST_AUTO_TEST_CASE(on_a_knotted_tube_one_framing_bounds_outside)
{
  constexpr int n = 120, m = 16;
  const Triangle_surface s = sample::tube(n, m, 0.35, sample::trefoil);
  BOOST_TEST((pipeline::classified(s).pairs.front().meridian.loop_class == Loop_class::HANDLE));
  // Closed ways along the tube that turn k times around it, and the way around it.
  std::vector<std::vector<Index>> walks;
  const auto step = [&](Index a, Index b) { return s.find_halfedge(a, b); };
  for (int k = -8; k <= 8; ++k)
  {
    auto& walk = walks.emplace_back();
    for (int i = 0; i < n; ++i) { walk.push_back(step(i * m, (i + 1) % n * m)); }
    for (int j = 0; j < m * std::abs(k); ++j)
    {
      const int from = j % m, to = (j + 1) % m;
      walk.push_back(k > 0 ? step(from, to) : step((m - from) % m, (m - to) % m));
    }
  }
  auto& around = walks.emplace_back();
  for (int j = 0; j < m; ++j) { around.push_back(step(j, (j + 1) % m)); }
  const auto sides = internal::find_bounding_sides(s, walks);
  BOOST_REQUIRE(sides.size() == walks.size());
  int outside = 0, inside = 0;
  for (std::size_t i = 0; i + 1 < sides.size(); ++i)
  {
    outside += sides[i].outside;
    inside += sides[i].inside;
  }
  BOOST_TEST(outside == 1);
  BOOST_TEST(inside == 0);
  BOOST_TEST((sides.back().inside && !sides.back().outside));
}

BOOST_AUTO_TEST_CASE(a_surface_that_meets_itself_or_has_a_boundary_has_no_classes)
{
  for (const Triangle_surface& s : {sample::torus(24, 12, 0.5, 1), sample::punctured(sample::torus(20, 12), {30})})
  {
    const Generators g = pipeline::classified(s);
    BOOST_TEST((g.pairs.front().meridian.loop_class == Loop_class::UNKNOWN));
    BOOST_TEST((g.pairs.front().longitude.loop_class == Loop_class::UNKNOWN));
  }
}

BOOST_AUTO_TEST_CASE(flow_lines_come_to_critical_points_and_those_down_from_all_saddles_leave_a_disc)
{
  for (unsigned seed = 0; seed < 12; ++seed)
  {
    const Triangle_surface s =
      seed % 2 ? sample::noisy(sample::plate(3, 2), 0.3, seed) : sample::noisy(sample::torus(18, 11), 0.2, seed);
    std::vector<double> field;
    std::mt19937 random(seed);
    for (Index v = 0; v < s.number_of_vertices(); ++v)
      // noise, and slopes
      field.push_back(seed < 6 ? static_cast<double>(random()) : s.points[v][0] + 0.3 * s.points[v][1]);
    const Ordered_surface m = pipeline::order(s, field, seed % 3 == 0);
    const Morse_complex c = make_morse_complex(m);
    const Critical_counts counts = count(find_critical_points(m.surface, m.rank));
    BOOST_TEST(c.critical.size() == static_cast<std::size_t>(counts.minima + counts.maxima + counts.saddles));
    BOOST_TEST(c.edges.size() == static_cast<std::size_t>(4 * counts.saddles));
    std::vector<Surface_curve> down;
    for (const Flow_line& line : c.lines)
    {
      BOOST_TEST((m.rank[line.end] < m.rank[line.start]) == line.descends);
      if (line.descends) { down.push_back(line.curve); }
    }
    // The lines down from all saddles, with the minima, are a graph whose complement has a disc for each maximum.
    Refined_surface cut = m.surface;
    insert_curves(s, cut, down);
    const Triangle_surface opened = surface_of(cut, open_along(cut));
    BOOST_TEST(static_cast<int>(boundary_loops(opened).size()) == counts.maxima);
    BOOST_TEST(sample::euler_characteristic(opened) == counts.maxima);
  }
}

BOOST_AUTO_TEST_CASE(lines_that_come_to_a_saddle_are_found)
{
  // On an upright torus both lines up from the lower saddle come to the upper one: its grid is symmetric.
  const Triangle_surface s = sample::torus(24, 12);
  std::vector<double> height;
  for (const Point& p : s.points) { height.push_back(p[0]); }
  const Morse_complex upright = make_morse_complex(pipeline::order(s, height, true));
  std::vector<double> generic;
  for (const Point& p : s.points) { generic.push_back(p[0] + 0.31 * p[1] + 0.17 * p[2]); }
  const Morse_complex leaning = make_morse_complex(pipeline::order(sample::noisy(s, 0.05, 1), generic, true));
  BOOST_TEST(leaning.is_morse_smale());
  BOOST_TEST(upright.is_morse_smale() == upright.connections.empty());
}

BOOST_AUTO_TEST_CASE(longitudes_of_flow_lines_are_monotone_in_the_field_they_name)
{
  int made = 0;
  for (const Triangle_surface& s : {sample::torus(40, 20), sample::plate(2, 4), sample::dumbbell(12)})
  {
    Generator_options options;
    options.tighten = false;
    Generators g = pipeline::generators(s, options);
    for (auto& pair : g.pairs)
    {
      if (pair.longitude.method != Curve_method::FLOW) { continue; }
      ++made;
      BOOST_TEST(verify_generators(s, g).failures.size() == 0u);
      const auto good = pair.longitude.field;
      pair.longitude.field[good.begin()->first] += 10; // one value wrong
      BOOST_TEST(verify_generators(s, g).failures.size() == 1u);
      pair.longitude.field = good;
    }
  }
  BOOST_TEST(made > 0);
}

// Tightened, one loop of flow lines on the larger surface would be short enough to be taken.
BOOST_AUTO_TEST_CASE(of_many_handles_flow_lines_are_sought_where_nothing_is_tightened)
{
  for (const bool tighten : {true, false})
    for (const bool is_large : {false, true})
    {
      Generator_options options;
      options.tighten = tighten;
      const Triangle_surface s =
        is_large ? sample::noisy(sample::plate(16, 1), 0.4, 3) : sample::noisy(sample::plate(4, 1), 0.1, 1);
      const Generators g = pipeline::generators(s, options);
      const bool any = std::any_of(g.pairs.begin(), g.pairs.end(), [](const auto& p) { return p.longitude.was_flow; });
      BOOST_TEST(any == (!is_large || !tighten), "large: " << is_large << ", tightened: " << tighten);
    }
}

BOOST_AUTO_TEST_CASE(cut_graphs_from_generators_and_flow_lines_leave_discs)
{
  for (const auto& [name, s] : surfaces()) BOOST_TEST_CONTEXT(name)
  for (int k = 0; k < 4; ++k)
  {
    Cut_options options;
    By_generators by_generators;
    by_generators.join = k == 1 ? Generator_join::COMPLEX : k == 2 ? Generator_join::SADDLES : Generator_join::SURFACE;
    options.method = by_generators;
    if (k == 3) { options.method = By_flow_lines(); }
    const auto v = verify_cut(s, pipeline::cut(s, options));
    for (const auto& failure : v.failures) { BOOST_TEST_MESSAGE(failure); }
    BOOST_TEST(v.failures.size() == 0u);
  }
}

BOOST_AUTO_TEST_CASE(free_and_closed_boundaries_give_bases_of_the_same_group)
{
  int arcs = 0;
  for (const auto& [name, s] : surfaces())
  {
    if (boundary_loops(s).empty()) { continue; }
    BOOST_TEST_CONTEXT(name)
    for (bool tighten : {false, true})
    {
      Generator_options options;
      options.tighten = tighten;
      const Generators closed = pipeline::generators(s, options);
      options.is_open = true;
      const Generators open = pipeline::generators(s, options);
      check(s, closed);
      check(s, open);
      BOOST_TEST(open.counts.saddles == 2 * open.genus);
      arcs += open.arcs;
      // Both were counted as bases, with all boundary loops but one, of the first homology of one surface.
    }
  }
  BOOST_TEST(arcs > 0);
}

BOOST_AUTO_TEST_CASE(determinants_are_those_of_the_integers)
{
  using verification::Integer_row;
  const auto unimodular = [](std::vector<std::vector<int>> rows) {
    std::vector<Integer_row> sparse;
    for (const auto& row : rows)
    {
      sparse.emplace_back();
      for (std::size_t c = 0; c < row.size(); ++c)
      {
        if (row[c] != 0) { sparse.back()[static_cast<std::int32_t>(c)] = row[c]; }
      }
    }
    return verification::is_unimodular(sparse, static_cast<std::int32_t>(rows.size()));
  };
  BOOST_TEST(unimodular({{1}}));
  BOOST_TEST(unimodular({{-1}}));
  BOOST_TEST(!unimodular({{0}}));
  BOOST_TEST(!unimodular({{3}}));
  BOOST_TEST(unimodular({{3, 5}, {1, 2}}));
  BOOST_TEST(!unimodular({{3, 5}, {1, 3}}));                  // 4
  BOOST_TEST(!unimodular({{1, 2}, {2, 4}}));                  // 0
  BOOST_TEST(unimodular({{2, 3, 5}, {5, 7, 12}, {1, 1, 3}})); // -1
  BOOST_TEST(!unimodular({{2, 0, 0}, {0, 2, 0}, {0, 0, 1}}));
}
