#include "support/implicit_surfaces.h"
#include "support/pipeline.h"
#include "support/sample_surfaces.h"

#include <meridian/base/exceptions.h>
#include <meridian/base/vectors.h>
#include <meridian/curves/Normal_curves.h>
#include <meridian/curves/contours.h>
#include <meridian/curves/project_contours.h>
#include <meridian/cut/Cut.h>
#include <meridian/cut/Cut_options.h>
#include <meridian/field/Two_point_fields.h>
#include <meridian/field/edge_weights.h>
#include <meridian/field/eigenfunctions.h>
#include <meridian/field/geodesic_distance.h>
#include <meridian/handles/Generators.h>
#include <meridian/handles/find_meridians.h>
#include <meridian/handles/preference.h>
#include <meridian/proof/verify_cut.h>
#include <meridian/proof/verify_generators.h>
#include <meridian/result/recount.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/Triangle_tree.h>
#include <meridian/surface/insert_curves.h>
#include <meridian/surface/open_along.h>
#include <meridian/surface/visibility.h>
#include <meridian/unwrap/cut_family.h>

#include <set>
#include <vector>

namespace data = boost::unit_test::data;
using namespace meridian;

namespace {

Cut check_cut(const Triangle_surface& s, const Cut_options& options)
{
  auto cut = pipeline::cut(s, options);
  const auto v = verify_cut(s, cut);
  BOOST_TEST(static_cast<bool>(v));
  for (const auto& failure : v.failures) { BOOST_ERROR(failure); }
  return cut;
}

std::vector<double> height(const Triangle_surface& s, int axis)
{
  std::vector<double> z;
  for (const Point& p : s.points) { z.push_back(p[axis]); }
  return z;
}

Triangle_surface holed_plate(int genus)
{
  const auto s = sample::noisy(sample::plate(genus, 4), 0.08, 3);
  return sample::punctured(s, {30, s.number_of_vertices() / 2});
}

} // namespace

// Theorem: saddles = 2g + minima + maxima - 2, for any field; the cut is a disc.
BOOST_DATA_TEST_CASE(any_field_gives_a_disc, data::xrange(1, 4) * data::xrange(6), genus, which)
{
  for (const auto& s : {sample::noisy(sample::plate(genus, 4), 0.08, 3), holed_plate(genus)})
  {
    Cut_options o;
    std::mt19937 random(which);
    const auto noise = [&] {
      std::vector<double> x;
      for (Index v = 0; v < s.number_of_vertices(); ++v) { x.push_back(random() % 50); }
      return x;
    };
    Field& field = pipeline::contours(o).field;
    switch (which)
    {
    case 0: field = Given_field{height(s, 0)}; break;
    case 1: field = Eigenfunction_field(); break;
    case 2: field = Eigenfunction_field{1, Weights::INTRINSIC_DELAUNAY}; break;
    case 3: field = Distance_field{9}; break;
    case 4: field = Given_field{noise()}; break; // ties and all
    default: field = Given_field{std::vector<double>(s.number_of_vertices(), 1)}; break;
    }
    check_cut(s, with_method(o, By_flow_lines()));
    check_cut(s, with_method(o, By_generators()));
    auto cut = check_cut(s, pipeline::tight_curves(o));
    BOOST_TEST(cut.counts.saddles == 2 * genus + cut.counts.minima + cut.counts.maxima - 2);
    BOOST_TEST(curves_of(cut, Curve_kind::MERIDIAN).size() == static_cast<std::size_t>(genus));
    pipeline::contours(o).minima = {9}; // the same field with extrema where they are wanted
    pipeline::contours(o).maxima = {s.number_of_vertices() - 5};
    cut = check_cut(s, o);
    BOOST_TEST(cut.counts.minima == 1);
    BOOST_TEST(cut.counts.maxima == 1);
    BOOST_TEST(cut.counts.saddles == 2 * genus);
  }
}

// Descending lines leave one piece for each maximum, so that all but the highest are taken out of the order.
BOOST_AUTO_TEST_CASE(flow_lines_of_several_maxima_give_one_disc)
{
  const auto s = sample::noisy(sample::plate(2, 4), 0.08, 3);
  Cut_options o;
  By_flow_lines method;
  method.minima = {9, 40};
  method.maxima = {100, 200, 300};
  o.method = method;
  const auto cut = check_cut(s, o);
  BOOST_TEST(cut.counts.maxima == 1);
  BOOST_TEST(cut.counts.minima == 2);
}

// Known answer: contours of the height are level.
BOOST_AUTO_TEST_CASE(meridians_of_the_height_are_level)
{
  const auto s = sample::rotated(sample::torus(60, 30), sample::pi / 2, 0.1);
  for (int axis = 0; axis < 3; ++axis)
  {
    Cut_options o;
    pipeline::contours(o).field = Given_field{height(s, axis)};
    o.tightening = Tightening::NONE;
    const auto cut = check_cut(s, o);
    double low = 1e300, high = -1e300;
    const Named_curve meridian = curves_of(cut, Curve_kind::MERIDIAN).front();
    for (Index v : meridian.vertices)
    {
      low = std::min(low, cut.surface.points[v][axis]);
      high = std::max(high, cut.surface.points[v][axis]);
    }
    BOOST_TEST(high - low < 0.1); // a crossing may go through a vertex close by
  }
}

BOOST_AUTO_TEST_CASE(fields_that_do_not_fit_are_refused)
{
  const auto s = sample::torus(12, 8);
  Cut_options o;
  pipeline::contours(o).field = Given_field{std::vector<double>(5, 0.)};
  BOOST_CHECK_THROW(pipeline::cut(s, o), Invalid_input_error);
  std::vector<double> values(s.number_of_vertices(), 0.);
  values[3] = std::nan("");
  pipeline::contours(o).field = Given_field{values};
  BOOST_CHECK_THROW(pipeline::cut(s, o), Invalid_input_error);
  pipeline::contours(o).field = Given_field{std::vector<double>(s.number_of_vertices(), 0.)};
  pipeline::contours(o).minima = {1};
  BOOST_CHECK_THROW(pipeline::cut(s, o), Invalid_input_error);
  BOOST_CHECK_THROW(eigenfunction_field(s, 0), Invalid_input_error);
  BOOST_CHECK_THROW(eigenfunction_field(s, 1, Weights::MEAN_VALUE), Invalid_input_error);
}

// A field for every vertex of an open surface too, with a free boundary.
BOOST_AUTO_TEST_CASE(generators_of_a_given_field)
{
  const auto s = holed_plate(2);
  for (const bool open : {false, true})
  {
    Generator_options o;
    o.field = Given_field{height(s, 0)};
    o.is_open = open;
    o.levels = Levels::TIGHT;
    const auto g = pipeline::generators(s, o);
    const auto v = verify_generators(s, g);
    BOOST_TEST(static_cast<bool>(v));
    for (const auto& failure : v.failures) { BOOST_ERROR(failure); }
  }
  Generator_options o;
  o.is_open = true;
  o.field = Harmonic_field{Weights::INTRINSIC_DELAUNAY};
  BOOST_CHECK_THROW(pipeline::generators(s, o), Invalid_input_error);
}

// Theorem: the contour of a torus' tube sweeps it from saddle to saddle, and the tightest is no longer than any.
BOOST_AUTO_TEST_CASE(the_tightest_contour_is_at_the_narrowest_place)
{
  auto s = sample::torus(96, 24, 3, 1);
  for (Point& p : s.points) // thinner towards +y
  {
    const double r = std::hypot(p[0], p[1]), thin = 1 - 0.4 * std::max(0., p[1] / r);
    const double x = 3 + (r - 3) * thin;
    p = {p[0] / r * x, p[1] / r * x, p[2] * thin};
  }
  const auto m = pipeline::order(s, height(s, 0), false);
  std::vector<char> is_critical(m.graph.number_of_nodes, 0);
  for (const auto& p : m.critical) { is_critical[m.graph.node[p.vertex]] = 1; }
  bool found_narrow = false;
  for (const Contour& loop : trace_saddle_loops(m))
  {
    const Contour tight = find_tightest_contour(m, loop, is_critical, 60);
    BOOST_TEST(length(m, tight) <= length(m, loop));
    double y = 0;
    for (Index h : tight.halfedges) { y += m.surface.point_on(h, 0.5)[1] / tight.halfedges.size(); }
    if (y > 2)
    {
      found_narrow = true;
      BOOST_TEST(length(m, tight) < 2 * sample::pi * 0.6 * 1.1);
      BOOST_TEST(length(m, tight) > 2 * sample::pi * 0.6 * 0.98);
    }
    // Pieces of one arc: cutting both leaves two pieces.
    if (tight.level != loop.level)
    {
      Refined_surface r(s);
      insert_curves(s, r, project_contours(s, m, {&loop, &tight}));
      const auto opened = open_along(r);
      Triangle_surface o;
      o.triangles = opened.triangles;
      o.points = r.points;
      for (Index v : opened.copy_of) { o.points.push_back(r.points[v]); }
      connect(o);
      BOOST_TEST(boundary_loops(o).size() == 4u);
      BOOST_TEST(sample::euler_characteristic(o) == 0); // two tubes
    }
  }
  BOOST_TEST(found_narrow);
}

// Preferences: weights along the loops, and what an eye does not see.
BOOST_AUTO_TEST_CASE(meridians_keep_to_low_weights)
{
  const auto s = sample::noisy(sample::plate(4, 4), 0.05, 8);
  Index low = 0;
  for (Index v = 0; v < s.number_of_vertices(); ++v)
  {
    if (s.points[v][0] < s.points[low][0]) { low = v; }
  }
  std::vector<double> weight;
  for (const Point& p : s.points) { weight.push_back(p[1]); }
  const auto mean = [&](const Cut& cut) {
    double sum = 0, n = 0;
    for (const Named_curve& m : curves_of(cut, Curve_kind::MERIDIAN))
    {
      for (Index v : m.vertices)
      {
        sum += cut.surface.points[v][1];
        ++n;
      }
    }
    return sum / n;
  };
  Cut_options o;
  o.tightening = Tightening::NONE;
  pipeline::contours(o).preference = preference::low_weight(weight);
  const double near = mean(check_cut(s, o));
  for (double& w : weight) { w = -w; }
  pipeline::contours(o).preference = preference::low_weight(weight);
  const double far = mean(check_cut(s, o));
  BOOST_TEST(near < far);
  // The average along a loop of a constant is that constant.
  const auto m = pipeline::order(s, height(s, 0), true);
  const std::vector<double> ones(s.number_of_vertices(), 2.5);
  for (const Contour& loop : trace_saddle_loops(m))
  {
    BOOST_TEST(std::abs(internal::average_along(s, m, loop, ones) - 2.5) < 1e-12);
  }
  const auto x = height(s, 0); // of the field itself, its level
  for (const Contour& loop : trace_saddle_loops(m))
  {
    const double at = (m.field(m.order.nodes[loop.level]) + m.field(m.order.nodes[loop.level + 1])) / 2;
    BOOST_TEST(std::abs(internal::average_along(s, m, loop, x) - at) < 0.2);
  }
}

// Known answer: of a sphere one half is seen; of a torus on edge the inside of the far rim is hidden behind the near
// one.
BOOST_AUTO_TEST_CASE(what_an_eye_sees)
{
  const auto ball = sample::sphere(4);
  const auto seen = visibility(ball, {0, 0, 5});
  for (Index v = 0; v < ball.number_of_vertices(); ++v)
    if (std::abs(ball.points[v][2]) > 0.1) { BOOST_TEST(seen[v] == (ball.points[v][2] > 0)); }
  const auto ring = sample::torus(48, 24);
  const auto from_side = visibility(ring, {1, 0, 0});
  for (Index v = 0; v < ring.number_of_vertices(); ++v)
  {
    const Point& p = ring.points[v];
    if (p[0] > 3.6) { BOOST_TEST(from_side[v] == 1); } // the near outside
    // behind the near rim
    if (p[0] < -1.9 && p[0] > -2.6 && std::abs(p[1]) < 1 && std::abs(p[2]) < 0.7) { BOOST_TEST(from_side[v] == 0); }
  }
  BOOST_CHECK_THROW(visibility(ball, {0, 0, 0}), Invalid_input_error);
}

// Every method with every tightening, on edges and off them.
namespace {

// Theorem: a cut graph is its curves. Each runs along seam edges, closed or not as it says; together along all.
void check_curves(const Cut& cut)
{
  const Refined_surface& s = cut.surface;
  std::set<Index> passed, seams;
  for (const Named_curve& c : cut.curves)
  {
    BOOST_TEST(c.is_closed == (c.kind == Curve_kind::MERIDIAN || c.kind == Curve_kind::LONGITUDE));
    for (Index v : c.vertices) { BOOST_REQUIRE((v >= 0 && v < s.number_of_vertices())); }
    for (std::size_t i = 0; i + (c.is_closed ? 0 : 1) < c.vertices.size(); ++i)
    {
      const Index h = s.find_halfedge(c.vertices[i], c.vertices[(i + 1) % c.vertices.size()]);
      BOOST_REQUIRE(h >= 0);
      passed.insert(s.edge(h));
    }
    if (c.kind == Curve_kind::MERIDIAN) { BOOST_TEST((c.saddle >= 0 && c.saddle < s.number_of_vertices())); }
  }
  for (Index h = 0; h < s.number_of_halfedges(); ++h)
  {
    if (s.seam[h]) { seams.insert(s.edge(h)); }
  }
  BOOST_TEST(passed == seams, boost::test_tools::per_element());
}

} // namespace

BOOST_DATA_TEST_CASE(every_method_gives_a_disc, data::xrange(number_of<Cut_method>) * data::xrange(0, 4), method, genus)
{
  for (const auto& s : {sample::noisy(sample::plate(genus, 4), 0.08, 3), holed_plate(genus)})
    for (const Tightening t : {Tightening::NONE, Tightening::CURVES, Tightening::GRAPH})
      for (const bool on_edges : {false, true})
      {
        Cut_options o;
        o.method = all<Cut_method>()[method];
        o.tightening = t;
        o.on_edges = on_edges;
        if (auto* tree_cotree = std::get_if<By_tree_cotree>(&o.method)) { tree_cotree->bases = 3; }
        const auto cut = check_cut(s, o);
        check_curves(cut);
        if (on_edges && genus > 0) { BOOST_TEST(cut.surface.origins.empty()); }
        if (t == Tightening::GRAPH && !on_edges) { BOOST_TEST(cut.length <= cut.length_found * 1.05); }
      }
}

// Where the mesh is too coarse for loops of edges, the error says so; where it may be refined, few vertices come.
BOOST_AUTO_TEST_CASE(loops_of_edges_need_room)
{
  const auto s = sample::torus(9, 3, 3, 1); // three vertices around its tube
  Cut_options o;
  pipeline::contours(o).field = Given_field{height(s, 0)};
  o.on_edges = true;
  int refused = 0, refined = 0;
  for (const auto& surface : {sample::plate(3, 1), sample::plate(6, 1), sample::noisy(sample::plate(5, 1), 0.1, 2)})
  {
    Cut_options e;
    e.on_edges = true;
    try
    {
      check_cut(surface, e);
    }
    catch (const Invalid_input_error& error)
    {
      ++refused;
      BOOST_TEST(std::string(error.what()).find("first: ") != std::string::npos);
      e.refine_where_needed = true;
      const auto cut = check_cut(surface, e);
      refined += !cut.surface.origins.empty();
      e.on_edges = e.refine_where_needed = false;
      BOOST_TEST(cut.surface.origins.size() < check_cut(surface, e).surface.origins.size());
    }
  }
  BOOST_TEST(refused == refined);
}

// A family: as many as asked for, all discs, all different, found one at a time, the same each time.
BOOST_AUTO_TEST_CASE(a_family_has_different_members)
{
  const auto s = sample::noisy(sample::plate(2, 4), 0.08, 3);
  std::set<std::pair<std::string, double>> known;
  std::vector<double> lengths;
  int n = 0;
  for (const Family_member& member : Cut_family(s, 16))
  {
    ++n;
    BOOST_TEST(static_cast<bool>(verify_cut(s, member.cut)));
    BOOST_TEST(known.emplace(member.name, member.cut.length).second);
    lengths.push_back(member.cut.length);
  }
  BOOST_TEST(n == 16);
  Cut_family again(s, 3);
  for (int i = 0; i < 3; ++i)
  {
    const auto member = again.next();
    BOOST_REQUIRE(member.has_value());
    BOOST_TEST(member->cut.length == lengths[i]);
  }
  BOOST_TEST(!again.next().has_value());
  // A disc has one cut: none.
  Triangle_surface triangle;
  triangle.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  triangle.triangles = {{0, 1, 2}};
  connect(triangle);
  Cut_family alone(triangle, 5);
  BOOST_TEST(alone.next().has_value());
  BOOST_TEST(!alone.next().has_value());
  // An error of the first member is the caller's.
  Cut_options wrong;
  pipeline::contours(wrong).minima = pipeline::contours(wrong).maxima = {3};
  Cut_family bad(s, 2, wrong);
  BOOST_CHECK_THROW(bad.next(), Invalid_input_error);
}

BOOST_AUTO_TEST_CASE(the_best_cuts_are_those_that_none_beats)
{
  const std::vector<std::array<double, 3>> costs{{1, 5, 3}, {2, 4, 3}, {2, 5, 3}, {1, 5, 3}, {3, 3, 9}, {9, 9, 1}};
  const std::vector<char> expected{1, 1, 0, 1, 1, 1};
  BOOST_TEST((find_best_cuts(costs) == expected));
  BOOST_TEST(find_best_cuts({}).empty());
}

// What keeps a surface takes none that is about to end.
BOOST_AUTO_TEST_CASE(no_family_of_a_temporary)
{
  static_assert(std::is_constructible_v<Cut_family, const Triangle_surface&, int>);
  static_assert(!std::is_constructible_v<Cut_family, Triangle_surface, int>);
  static_assert(!std::is_constructible_v<internal::Two_point_fields, Triangle_surface, Make_solver>);
  static_assert(!std::is_constructible_v<Normal_curves, Triangle_surface, Index>);
  static_assert(!std::is_constructible_v<Triangle_tree, Triangle_surface>);
}
