#include "support/pipeline.h"
#include "support/sample_surfaces.h"

#include <meridian/base/Progress_observer.h>
#include <meridian/base/exceptions.h>
#include <meridian/base/names.h>
#include <meridian/base/vectors.h>
#include <meridian/curves/Normal_curves.h>
#include <meridian/curves/add_contours.h>
#include <meridian/curves/chords.h>
#include <meridian/curves/contours.h>
#include <meridian/curves/project_contours.h>
#include <meridian/curves/tighten_curves.h>
#include <meridian/cut/Cut.h>
#include <meridian/cut/Cut_options.h>
#include <meridian/cut/internal/link_search.h>
#include <meridian/cut/internal/slit_surface.h>
#include <meridian/cut/join_generators.h>
#include <meridian/field/Ordered_surface.h>
#include <meridian/field/edge_weights.h>
#include <meridian/handles/Generators.h>
#include <meridian/handles/find_generators.h>
#include <meridian/handles/find_meridians.h>
#include <meridian/handles/internal/tree_cotree.h>
#include <meridian/handles/preference.h>
#include <meridian/handles/select_meridians.h>
#include <meridian/map/Map_method.h>
#include <meridian/map/embed_in_plane.h>
#include <meridian/proof/internal/verify_basis.h>
#include <meridian/result/recount.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/insert_curves.h>
#include <meridian/surface/open_along.h>

#include <functional>
#include <set>
#include <string>
#include <vector>

namespace data = boost::unit_test::data;
using namespace meridian;

namespace {

void check_is_disc(const Triangle_surface& s, const Cut& cut)
{
  const Verification recount = verify_cut(s, cut);
  BOOST_TEST(static_cast<bool>(recount));
  for (const auto& failure : recount.failures) { BOOST_ERROR(failure); }
  const auto meridians = curves_of(cut, Curve_kind::MERIDIAN).size();
  BOOST_TEST(meridians <= static_cast<std::size_t>(cut.genus));
  if (cut.tightening != Tightening::GRAPH) { BOOST_TEST(meridians == static_cast<std::size_t>(cut.genus)); }
}

// Turns along a closed curve, in radians: 2 pi for a convex plane curve.
double total_turning(const Cut& cut, const std::vector<Index>& curve)
{
  double sum = 0;
  const auto& p = cut.surface.points;
  const std::size_t n = curve.size();
  for (std::size_t i = 0; i < n; ++i)
  {
    const Point a = p[curve[(i + 1) % n]] - p[curve[i]], b = p[curve[(i + 2) % n]] - p[curve[(i + 1) % n]];
    sum += std::atan2(norm(cross(a, b)), dot(a, b));
  }
  return sum;
}

// The genus of what is left, and the number of its pieces, when faces are not walked across crossed edges: counted by
// inserting the loops and flooding, with nothing of the selection.
std::pair<int, int> recount(const Triangle_surface& root, const Ordered_surface& m,
                            const std::vector<const Contour*>& loops)
{
  Refined_surface s(root);
  insert_curves(root, s, project_contours(root, m, loops));
  const auto opened = open_along(s);
  const Triangle_surface o = surface_of(s, opened);
  int pieces = 0;
  std::vector<char> seen(o.number_of_faces(), 0);
  for (Index f = 0; f < o.number_of_faces(); ++f)
  {
    if (seen[f]) { continue; }
    ++pieces;
    seen[f] = 1;
    std::vector<Index> stack{f};
    while (!stack.empty())
    {
      const Index g = stack.back();
      stack.pop_back();
      for (Index h = 3 * g; h < 3 * g + 3; ++h)
        if (o.opposite[h] >= 0 && !seen[o.opposite[h] / 3])
        {
          seen[o.opposite[h] / 3] = 1;
          stack.push_back(o.opposite[h] / 3);
        }
    }
  }
  const int genus = (2 * pieces - sample::euler_characteristic(o) - static_cast<int>(boundary_loops(o).size())) / 2;
  return {genus, pieces};
}

} // namespace

BOOST_DATA_TEST_CASE(contours_are_closed_and_simple_with_the_higher_side_on_their_left, data::xrange(3), genus)
{
  const auto s = sample::noisy(sample::plate(genus, 3), 0.1, 1);
  std::vector<double> f;
  for (const Point& p : s.points) { f.push_back(p[0] + 0.3 * p[1] + 0.2 * p[2]); }
  const auto m = pipeline::order(s, f, false);
  for (Index level = 0; level + 1 < m.graph.number_of_nodes; level += 7)
  {
    std::size_t crossings = 0;
    for (const Contour& c : trace_level(m, level))
    {
      crossings += c.halfedges.size();
      std::vector<Index> sorted(c.halfedges);
      std::sort(sorted.begin(), sorted.end());
      BOOST_REQUIRE((std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end()));
      for (std::size_t i = 0; i < c.halfedges.size(); ++i)
      {
        const Index h = c.halfedges[i], next = c.halfedges[(i + 1) % c.halfedges.size()];
        BOOST_REQUIRE(rises_through(m, h, level));
        BOOST_REQUIRE(m.surface.face(m.surface.opposite[h]) == m.surface.face(next)); // goes on where it came
        // The higher end of the edge is on the left of the direction of travel: it is the target of h, which has the
        // face that the curve comes from on its left.
        BOOST_REQUIRE(m.rank[m.surface.target(h)] > level);
      }
    }
    std::size_t all = 0;
    for (Index h = 0; h < m.surface.number_of_halfedges(); ++h) { all += rises_through(m, h, level); }
    BOOST_TEST(crossings == all); // every crossed edge lies on one contour
  }
}

// Known answer: the higher side of a contour of height lies above it.
BOOST_AUTO_TEST_CASE(the_contours_of_height_on_a_sphere_go_round_counterclockwise_seen_from_above)
{
  const auto s = sample::noisy(sample::sphere(3), 0.01, 1);
  std::vector<double> f;
  for (const Point& p : s.points) { f.push_back(p[2]); }
  const auto m = pipeline::order(s, f, true);
  const auto contours = trace_level(m, m.graph.number_of_nodes / 2);
  BOOST_REQUIRE(contours.size() == 1u);
  double area = 0; // of the projection, counterclockwise positive
  std::vector<Point> p;
  for (Index h : contours.front().halfedges)
  {
    p.push_back(m.surface.point_on(h, crossing_fraction(m, h, contours.front().level)));
  }
  for (std::size_t i = 0; i < p.size(); ++i)
  {
    const Point &a = p[i], &b = p[(i + 1) % p.size()];
    area += (a[0] * b[1] - a[1] * b[0]) / 2;
  }
  BOOST_TEST(area == sample::pi, boost::test_tools::tolerance(0.1));
}

// The paper's greedy search, loop after loop with a recount each time, and the union-find give the same loops.
BOOST_DATA_TEST_CASE(union_find_and_greedy_search_choose_the_same_loops, data::xrange(100), seed)
{
  std::mt19937 random(seed);
  const int genus = 1 + seed % 4;
  Triangle_surface s = sample::noisy(sample::plate(genus, 2), 0.2, seed);
  if (seed % 3 == 0) { s = sample::punctured(s, {static_cast<Index>(random() % s.number_of_vertices())}); }
  std::vector<double> f;
  for (const Point& p : s.points)
  {
    f.push_back(p[0] + 0.7 * p[1] + static_cast<double>(random() % 1000) / (seed % 2 ? 2000. : 400.));
  }
  const auto m = pipeline::order(s, f, seed % 5 != 0);
  const auto loops = trace_saddle_loops(m);
  std::vector<std::size_t> order(loops.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  for (std::size_t i = order.size(); i-- > 1;) { std::swap(order[i], order[random() % (i + 1)]); }

  std::vector<std::size_t> greedy;
  std::vector<const Contour*> kept;
  for (std::size_t i : order)
  {
    if (greedy.size() == static_cast<std::size_t>(genus)) { break; }
    kept.push_back(&loops[i]);
    const auto [left, pieces] = recount(s, m, kept);
    if (pieces == 1)
    {
      BOOST_REQUIRE(left == genus - static_cast<int>(kept.size()));
      greedy.push_back(i);
    }
    else { kept.pop_back(); }
  }
  const auto chosen = select_meridians(m, loops, order);
  std::vector<std::size_t> found;
  for (const auto& c : chosen)
  {
    found.push_back(c.loop);
    BOOST_TEST(c.genus_after == genus - static_cast<int>(found.size()));
    BOOST_TEST(c.components_after == 1);
  }
  BOOST_TEST(found == greedy, boost::test_tools::per_element());
}

BOOST_DATA_TEST_CASE(closed_surfaces_become_discs, data::xrange(6), genus)
{
  for (int k : {1, 3})
  {
    const auto s = sample::plate(genus, k);
    check_is_disc(s, pipeline::cut(s));
    check_is_disc(s, pipeline::cut(s, pipeline::tight_curves()));
  }
}

BOOST_DATA_TEST_CASE(bordered_surfaces_become_discs, data::xrange(3) * data::xrange(1, 4), genus, holes)
{
  const auto whole = sample::plate(genus, 6);
  std::vector<Index> centers;
  for (Index v = 0; v < whole.number_of_vertices() && centers.size() < static_cast<std::size_t>(holes); ++v)
  {
    const Point& p = whole.points[v];
    const double x = p[0] - 0.5, y = p[1] - 0.5;
    if (p[2] == 1 && std::abs(x - std::round(x)) < 0.01 && std::abs(y - std::round(y)) < 0.01) { centers.push_back(v); }
  }
  BOOST_REQUIRE(centers.size() == static_cast<std::size_t>(holes));
  const auto s = sample::punctured(whole, centers);
  const auto cut = pipeline::cut(s);
  BOOST_TEST(cut.boundary_loops == holes);
  BOOST_TEST(cut.genus == genus);
  check_is_disc(s, cut);
  if (genus == 0 && holes == 1) { BOOST_TEST(cut.length == 0); }
}

// All vertices on the boundary: two bands that cross, thickened from a one-vertex torus.
BOOST_AUTO_TEST_CASE(a_torus_with_all_vertices_on_one_boundary_loop_is_cut)
{
  auto s = sample::torus(3, 3);
  s = sample::without(s, [](Index f) { return f == 4; });
  const auto all = sample::torus(4, 4);
  const auto cut = pipeline::cut(s);
  BOOST_TEST(cut.boundary_loops == 1);
  check_is_disc(s, cut);
  // A strip of the grid in each direction; every vertex lies on its rim.
  const auto bands = sample::without(all, [](Index f) { return f / 2 / 4 != 0 && f / 2 % 4 != 0; });
  Index inside = 0;
  for (Index v = 0; v < bands.number_of_vertices(); ++v) { inside += !bands.is_boundary_vertex(v); }
  BOOST_TEST(inside == 0);
  const auto cut_bands = pipeline::cut(bands);
  BOOST_TEST(cut_bands.genus == 1);
  check_is_disc(bands, cut_bands);
}

BOOST_AUTO_TEST_CASE(the_smallest_closed_surfaces_are_cut)
{
  Triangle_surface tetrahedron;
  tetrahedron.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  tetrahedron.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  connect(tetrahedron);
  const auto cut = pipeline::cut(tetrahedron);
  BOOST_TEST(cut.opened.seams.size() >= 2u);
  check_is_disc(tetrahedron, cut);

  Triangle_surface pillow; // two faces that share all three edges
  pillow.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  pillow.triangles = {{0, 1, 2}, {0, 2, 1}};
  connect(pillow);
  check_is_disc(pillow, pipeline::cut(pillow));

  Triangle_surface seven; // Moebius' torus: seven vertices, every two of them joined
  for (int i = 0; i < 7; ++i) { seven.points.push_back({std::cos(i), std::sin(2. * i), 0.3 * i}); }
  for (Index i = 0; i < 7; ++i)
  {
    seven.triangles.push_back({i, (i + 1) % 7, (i + 3) % 7});
    seven.triangles.push_back({i, (i + 3) % 7, (i + 2) % 7});
  }
  connect(seven);
  BOOST_TEST(sample::euler_characteristic(seven) == 0);
  check_is_disc(seven, pipeline::cut(seven));
}

// Known answer: the shortest meridian of a torus is its tube.
BOOST_AUTO_TEST_CASE(the_cut_of_a_torus_is_about_a_meridian_and_the_inner_circle)
{
  const auto s = sample::noisy(sample::torus(90, 30), 0.01, 1);
  Cut_options options;
  pipeline::contours(options).preference = preference::short_length;
  const auto cut = pipeline::cut(s, options);
  BOOST_TEST(cut.length > 2 * sample::pi + 2 * sample::pi * 2 - 0.5);
  BOOST_TEST(cut.length < (2 * sample::pi + 2 * sample::pi * 2) * 1.25);
}

BOOST_AUTO_TEST_CASE(every_option_gives_a_disc)
{
  const auto s = sample::noisy(sample::punctured(sample::plate(2, 4), {30}), 0.05, 7);
  const auto check = [&](const Cut_options& o) {
    const auto result = pipeline::run(sample::soup(s), false, o);
    for (const auto& failure : result.verification.failures) { BOOST_ERROR(failure); }
    return result.cuts.front();
  };
  Cut_options o;
  for (Weights w : {Weights::POSITIVE, Weights::MEAN_VALUE, Weights::COTANGENT})
  {
    pipeline::contours(o).field = Harmonic_field{w};
    check(o);
  }
  o = Cut_options();
  for (const Preference& p : {Preference(preference::gaussian_curvature), Preference(preference::mean_curvature),
                              Preference(preference::short_length), preference::position({1, 0, 0}),
                              Preference([](const Loop_candidate&) { return std::nan(""); })})
  {
    pipeline::contours(o).preference = p;
    check(o);
  }
  o = Cut_options();
  pipeline::contours(o).minima = {3, 50};
  pipeline::contours(o).maxima = {100};
  BOOST_TEST(check(o).counts.minima == 2);
  o = Cut_options();
  o.links.bifurcations = true;
  const double with = check(o).length;
  const double without = check(pipeline::tight_curves()).length;
  BOOST_TEST(with <= without * 1.01);
  o = Cut_options();
  o.links.source = 200;
  const auto cut = check(o);
  bool passes = false;
  for (const Named_curve& link : curves_of(cut, Curve_kind::LINK))
  {
    passes = passes || std::count(link.vertices.begin(), link.vertices.end(), 200) > 0;
  }
  BOOST_TEST(passes);
}

// Known answers: what the plane can and cannot do.
BOOST_DATA_TEST_CASE(links_through_the_plane_give_a_disc, data::xrange(4), genus)
{
  for (const auto& s :
       {sample::noisy(sample::plate(genus, 4), 0.05, 2), sample::punctured(sample::plate(genus, 4), {40}),
        sample::punctured(sample::torus(30, 20), {5, 100, 200, 300, 420})})
  {
    Cut_options o;
    o.link_domain = Link_domain::PLANE;
    o.links.source = 11;
    const auto run = pipeline::run(sample::soup(s), false, o);
    for (const auto& failure : run.verification.failures) { BOOST_ERROR(failure); }
    const Cut& cut = run.cuts.front();
    BOOST_TEST(cut.links_in_plane == (cut.genus > 0 || cut.boundary_loops > 0));
    bool passes = (cut.genus == 0 && cut.boundary_loops == 0) || s.is_boundary_vertex(11);
    for (const Named_curve& c : cut.curves)
    {
      passes = passes || std::count(c.vertices.begin(), c.vertices.end(), 11) > 0;
    }
    BOOST_TEST(passes);
  }
}

BOOST_AUTO_TEST_CASE(a_plane_that_underflows_is_left_for_the_surface)
{
  // A hole at the end of a tube 100 radii long.
  Triangle_surface tube;
  constexpr int ring = 8, rings = 160;
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < ring; ++j)
    {
      tube.points.push_back({0.7 * i, std::cos(2 * sample::pi * j / ring), std::sin(2 * sample::pi * j / ring)});
    }
  for (int i = 0; i + 1 < rings; ++i)
    for (int j = 0; j < ring; ++j)
    {
      const Index a = i * ring + j, b = i * ring + (j + 1) % ring;
      tube.triangles.push_back({a, b, a + ring});
      tube.triangles.push_back({b, b + ring, a + ring});
    }
  connect(tube);
  BOOST_TEST(!embed_in_plane(tube).is_valid);
  Cut_options o;
  o.link_domain = Link_domain::PLANE;
  const auto run = pipeline::run(sample::soup(tube), false, o);
  for (const auto& failure : run.verification.failures) { BOOST_ERROR(failure); }
  BOOST_TEST(!run.cuts.front().links_in_plane);
  BOOST_TEST(run.cuts.front().link_note.find("turned over") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_source_on_a_sphere_is_reached_from_everywhere)
{
  for (int levels : {0, 1, 2})
    for (Index v = 0; v < 6; ++v)
    {
      Cut_options o;
      o.links.source = v;
      const auto run = pipeline::run(sample::soup(sample::noisy(sample::sphere(levels), 0.1, 4)), false, o);
      for (const auto& failure : run.verification.failures) { BOOST_ERROR(failure); }
      bool passes = false;
      for (const Named_curve& link : curves_of(run.cuts.front(), Curve_kind::LINK))
      {
        passes = passes || std::count(link.vertices.begin(), link.vertices.end(), v) > 0;
      }
      BOOST_TEST(passes);
    }
}

BOOST_AUTO_TEST_CASE(extrema_on_one_boundary_loop_are_refused)
{
  const auto s = sample::punctured(sample::plate(1, 4), {30});
  const auto loop = boundary_loops(s).front();
  Cut_options o;
  pipeline::contours(o).minima = {s.source(loop[0])};
  pipeline::contours(o).maxima = {s.source(loop[2])};
  BOOST_CHECK_EXCEPTION(pipeline::cut(s, o), Invalid_input_error, [](const auto& e) {
    return std::string(e.what()).find("one boundary loop") != std::string::npos;
  });
}

// Metamorphic relations: the cut does not depend on numbers, unit or side.
BOOST_DATA_TEST_CASE(renumbering_scaling_and_mirroring_keep_the_cut, data::xrange(3), genus)
{
  for (const auto& s : {sample::noisy(sample::plate(genus, 4), 0.1, 11),
                        sample::punctured(sample::noisy(sample::plate(genus, 4), 0.1, 12), {40})})
  {
    const auto cut = pipeline::cut(s, pipeline::tight_curves());
    const auto same = [&](const Triangle_surface& other, double scale) {
      const auto c = pipeline::cut(other, pipeline::tight_curves());
      BOOST_TEST(c.genus == cut.genus);
      BOOST_TEST(c.boundary_loops == cut.boundary_loops);
      BOOST_TEST(curves_of(c, Curve_kind::MERIDIAN).size() == curves_of(cut, Curve_kind::MERIDIAN).size());
      BOOST_TEST(curves_of(c, Curve_kind::LINK).size() == curves_of(cut, Curve_kind::LINK).size());
      if (cut.length > 0) { BOOST_TEST(c.length == cut.length * scale, boost::test_tools::tolerance(1e-6)); }
      check_is_disc(other, c);
    };
    for (unsigned seed : {1u, 2u}) { same(sample::renumbered(s, seed), 1); }
    same(sample::scaled(s, 1e-6), 1e-6);
    same(sample::scaled(s, 1e6), 1e6);
    same(sample::mirrored(s), 1);
    const auto fine = pipeline::cut(sample::subdivided(s), pipeline::tight_curves());
    BOOST_TEST(fine.genus == cut.genus);
    BOOST_TEST(fine.boundary_loops == cut.boundary_loops);
    BOOST_TEST(curves_of(fine, Curve_kind::MERIDIAN).size() == curves_of(cut, Curve_kind::MERIDIAN).size());
    if (cut.length > 0) { BOOST_TEST(fine.length == cut.length, boost::test_tools::tolerance(0.15)); }
  }
}

BOOST_AUTO_TEST_CASE(the_same_input_gives_the_same_bytes)
{
  const auto s = sample::noisy(sample::plate(3, 5), 0.1, 5);
  const auto a = pipeline::cut(s), b = pipeline::cut(s);
  BOOST_TEST(a.opened.triangles.size() == b.opened.triangles.size());
  BOOST_TEST((a.opened.triangles == b.opened.triangles));
  BOOST_TEST((a.surface.points == b.surface.points));
}

// A handle at the end of a tube 60 radii long, both extrema at the other end: its meridian is as smooth as the other
// one.
BOOST_DATA_TEST_CASE(a_handle_behind_a_long_tube_is_cut_smoothly, data::make({20., 60., 150.}), tube)
{
  const auto s = sample::dumbbell(tube);
  Cut_options o;
  pipeline::contours(o).minima = {400}; // on the first torus, off its plane of symmetry
  pipeline::contours(o).maxima = {610};
  const auto cut = pipeline::cut(s, pipeline::tight_curves(o));
  check_is_disc(s, cut);
  BOOST_TEST(cut.counts.saddles == 4);
  BOOST_REQUIRE(curves_of(cut, Curve_kind::MERIDIAN).size() == 2u);
  if (tube >= 60) { BOOST_TEST(cut.flat_regions > 0); }
  double near = 0, far = 0;
  for (const Named_curve& curve : curves_of(cut, Curve_kind::MERIDIAN))
    (cut.surface.points[curve.vertices.front()][0] > 8 + tube / 2 ? far : near) = total_turning(cut, curve.vertices);
  BOOST_TEST_MESSAGE("tube " << tube << ": turning " << near << " at the near end, " << far << " at the far end");
  BOOST_REQUIRE((near > 0 && far > 0));
  BOOST_TEST(near < 1.6 * 2 * sample::pi); // contours near a saddle have a corner
  BOOST_TEST(far < 1.2 * near);
}

BOOST_AUTO_TEST_CASE(an_observer_sees_the_stages_in_order_and_can_end_the_run)
{
  struct Watcher : Progress_observer
  {
    std::vector<Stage> started, finished;
    std::size_t steps = 1000;
    void stage_started(Stage stage) override { started.push_back(stage); }
    void stage_finished(Stage stage) override { finished.push_back(stage); }
    bool go_further() override { return started.size() <= steps; }
  };
  const auto s = sample::plate(1);
  Watcher all;
  Cut_options o;
  o.observer = &all;
  pipeline::cut(s, o);
  BOOST_TEST((all.started == all.finished));
  BOOST_TEST((std::is_sorted(all.started.begin(), all.started.end())));
  BOOST_TEST(all.started.size() == 10u);
  Watcher two;
  two.steps = 2;
  o.observer = &two;
  BOOST_CHECK_THROW(pipeline::cut(s, o), Cancelled);
  BOOST_TEST(two.finished.size() == 2u);
}

// Scale of the field: crossings keep away from vertices, so that no face becomes a sliver without need.
BOOST_AUTO_TEST_CASE(slivers_are_avoided)
{
  const auto s = sample::noisy(sample::torus(60, 24), 0.02, 3);
  const auto cut = pipeline::cut(s);
  BOOST_TEST(cut.smallest_angle_before > 0.3);
  BOOST_TEST(cut.smallest_angle_after > 0.02);
}

// Tightening keeps the class of every meridian: how often it crosses the loops of a basis of homology.
BOOST_DATA_TEST_CASE(tightened_meridians_keep_their_class, data::xrange(1, 7), genus)
{
  for (const auto& s :
       {sample::noisy(sample::plate(genus, 4), 0.15, genus), sample::punctured(sample::plate(genus, 4), {30, 90})})
  {
    std::vector<double> height;
    for (const Point& p : s.points) { height.push_back(p[0] + 0.3 * p[1]); }
    const auto m = pipeline::order(s, height, true);
    Meridian_search search;
    search.loops = trace_saddle_loops(m);
    find_meridians(s, m, genus, preference::short_length, search);
    for (const Loop_candidate& c : search.candidates) { BOOST_TEST(!c.average); } // its loop may have moved
    Normal_curves curves(s, genus);
    internal::add_contours(internal::project_crossings(s, m, search.chosen()), curves, 1);
    const internal::Tree_cotree basis(s);
    const auto classes = [&] {
      std::vector<std::vector<int>> all;
      for (Index c = 0; c < genus; ++c)
      {
        std::vector<std::pair<Index, int>> flow;
        for (Index x : curves.crossings(c)) // the walk along the vertices on its left
        {
          const Index from = s.target(curves[x].halfedge), to = s.target(curves[curves[x].next].halfedge);
          if (from == to) { continue; }
          const Index h = s.find_halfedge(from, to), g = h >= 0 ? h : s.find_halfedge(to, from);
          flow.emplace_back(s.edge(g), s.source(s.edge(g)) == from ? 1 : -1);
        }
        all.push_back(basis.integrate(flow));
      }
      return all;
    };
    const auto before = classes();
    BOOST_TEST((before != std::vector<std::vector<int>>(genus, std::vector<int>(basis.edges().size(), 0))));
    const double length = tighten_curves(curves);
    BOOST_TEST(length > 0);
    BOOST_TEST((classes() == before));
    for (Index crossings : count_crossings(curves)) { BOOST_TEST(crossings == 0); }
  }
}

// The search for links may end early: contacts come nearest first, so what comes later cannot change the tree.
BOOST_AUTO_TEST_CASE(the_early_end_of_the_link_search_gives_the_whole_tree)
{
  using internal::Link_search;
  const Triangle_surface s =
    sample::punctured(sample::noisy(sample::torus(40, 20), 0.05, 3), {0, 55, 110, 300, 471, 700});
  Refined_surface refined(s);
  internal::Slit_surface slit(s, refined, false);
  BOOST_REQUIRE(slit.number_of_loops() == 6);
  const auto early = Link_search(slit).find_spanning_contacts();
  const auto whole = Link_search(slit).find_spanning_contacts(Link_search::Extent::WHOLE);
  BOOST_REQUIRE(early.size() == 5u);
  BOOST_REQUIRE(whole.size() == early.size());
  for (std::size_t i = 0; i < early.size(); ++i)
  {
    BOOST_TEST(early[i].from == whole[i].from);
    BOOST_TEST(early[i].to == whole[i].to);
    BOOST_TEST(early[i].halfedge == whole[i].halfedge);
    BOOST_TEST(early[i].along == whole[i].along);
  }
}

namespace {

// Names are different words without spaces, and lead back to their values.
template <class Enum> bool are_same(Enum a, Enum b) { return a == b; }
template <class... Type> bool are_same(const std::variant<Type...>& a, const std::variant<Type...>& b)
{
  return a.index() == b.index();
}

template <class Enum> void check_names()
{
  std::set<std::string> names;
  for (const Enum& value : all<Enum>())
  {
    const std::string name = name_of(value);
    BOOST_TEST(names.insert(name).second, name);
    BOOST_TEST(!name.empty());
    BOOST_TEST(name.find_first_not_of("abcdefghijklmnopqrstuvwxyz-_") == std::string::npos, name);
    BOOST_REQUIRE(from_name<Enum>(name).has_value());
    BOOST_TEST(are_same(from_name<Enum>(name).value(), value), name);
    BOOST_TEST(!from_name<Enum>(name + "x").has_value());
  }
  BOOST_TEST(names.size() == number_of<Enum>);
  BOOST_TEST(!from_name<Enum>("").has_value());
}

} // namespace

BOOST_AUTO_TEST_CASE(names_are_different_and_lead_back_to_their_values)
{
  check_names<Stage>();
  check_names<Weights>();
  check_names<Levels>();
  check_names<Cut_method>();
  check_names<Field>();
  check_names<Extrema>();
  check_names<Tightening>();
  check_names<Link_domain>();
  check_names<Generator_join>();
  check_names<Curve_method>();
  check_names<Loop_class>();
  check_names<Curve_kind>();
  check_names<Map_method>();
  check_names<Map_border>();
}

namespace {

std::string refusal(const std::function<void()>& run)
{
  try
  {
    run();
  }
  catch (const Invalid_input_error& e)
  {
    return e.what();
  }
  return "";
}

Cut_options with(Cut_method method)
{
  Cut_options o;
  o.method = std::move(method);
  return o;
}

// Contours of a field between extrema.
Cut_options with(Field field, std::vector<Index> minima = {}, std::vector<Index> maxima = {})
{
  By_contours contours;
  static_cast<Field_options&>(contours) = {{std::move(minima), std::move(maxima)}, std::move(field)};
  return with(contours);
}

// Choices, one of which another would leave without effect.
std::vector<Cut_options> wrong_choices()
{
  std::vector<Cut_options> all(4);
  all[0].link_domain = Link_domain::PLANE;
  all[0].links.bifurcations = true;
  all[1].refine_where_needed = true;
  all[2].on_edges = all[2].refine_where_needed = true;
  all[2].tightening = Tightening::GRAPH;
  all[3].links.source = 3;
  all[3].tightening = Tightening::GRAPH;
  all.push_back(with(By_tree_cotree{-1, 0}));
  all.push_back(with(By_tree_cotree()));
  all.back().links.bifurcations = true;
  all.push_back(with(By_removing_faces()));
  all.back().link_domain = Link_domain::PLANE;
  all.push_back(with(By_flow_lines()));
  all.back().links.source = 3;
  all.back().on_edges = true;
  all.push_back(with(Harmonic_field{Weights::POSITIVE, Extrema::CURVED}, {0}, {1}));
  all.push_back(with(Harmonic_field{Weights::MEAN_VALUE, Extrema::CURVED}));
  all.push_back(with(Eigenfunction_field{1, Weights::MEAN_VALUE}));
  all.push_back(with(Eigenfunction_field{-1}));
  return all;
}

} // namespace

BOOST_AUTO_TEST_CASE(choices_that_do_not_go_together_are_refused)
{
  const auto s = sample::torus(10, 10);
  std::set<std::string> messages;
  for (const Cut_options& o : wrong_choices())
  {
    const std::string message = refusal([&] { check(o); });
    BOOST_TEST(!message.empty());
    BOOST_TEST(refusal([&] { pipeline::cut(s, o); }) == message);
    messages.insert(message);
  }
  BOOST_TEST(messages.size() == 11u); // each rule has its own; two choices break that about eigenfunctions
}

// Theorem: what is left of any choices goes together with the method that they are taken to, if it did before.
BOOST_DATA_TEST_CASE(choices_are_taken_to_another_method, data::xrange(number_of<Cut_method>), to)
{
  const auto s = sample::torus(10, 10);
  for (const Cut_method& from : all<Cut_method>())
    for (const bool on_edges : {false, true})
    {
      Cut_options o;
      o.method = from;
      o.on_edges = on_edges;
      if (!cuts_edges(from)) { o.links.bifurcations = true; }
      std::visit(
        [](auto& m) {
          using Method = std::decay_t<decltype(m)>;
          if constexpr (std::is_base_of_v<Chosen_extrema, Method>) { static_cast<Chosen_extrema&>(m) = {{0}, {55}}; }
          if constexpr (std::is_base_of_v<Meridian_options, Method>) { m.levels = Levels::TIGHT; }
          if constexpr (std::is_base_of_v<Field_options, Method>)
          {
            m.field = Given_field{std::vector<double>(100, 0)};
          }
          if constexpr (std::is_same_v<By_tree_cotree, Method>) { m.source = 4; }
          if constexpr (std::is_same_v<By_distance, Method>) { m.source = 4; }
          if constexpr (std::is_same_v<By_generators, Method>) { m.join = Generator_join::SADDLES; }
        },
        o.method);
      if (std::holds_alternative<By_contours>(from) || (!cuts_edges(from) && !on_edges)) { o.links.source = 7; }
      BOOST_TEST(refusal([&] { check(s, o); }) == "");
      const Cut_options taken = with_method(o, all<Cut_method>()[to]);
      BOOST_TEST(refusal([&] { check(s, taken); }) == "");
      BOOST_TEST(taken.method.index() == all<Cut_method>()[to].index());
      BOOST_TEST(taken.on_edges == on_edges);
      BOOST_TEST(taken.links.bifurcations == (o.links.bifurcations && !cuts_edges(taken.method)));
      std::visit(
        [&](const auto& m) {
          using Method = std::decay_t<decltype(m)>;
          if constexpr (std::is_base_of_v<Chosen_extrema, Method>)
          {
            BOOST_TEST(m.minima.size() == (cuts_edges(from) ? 0u : 1u));
          }
          if constexpr (std::is_base_of_v<Meridian_options, Method>)
          {
            const bool had_levels = !cuts_edges(from) && !std::holds_alternative<By_flow_lines>(from);
            BOOST_TEST((m.levels == (had_levels ? Levels::TIGHT : Levels::SADDLE)));
          }
          if constexpr (std::is_same_v<By_generators, Method>)
          {
            BOOST_TEST((m.join == Generator_join::SADDLES) == std::holds_alternative<By_generators>(from));
          }
          if constexpr (std::is_same_v<By_tree_cotree, Method>)
          {
            const bool had_source =
              std::holds_alternative<By_tree_cotree>(from) || std::holds_alternative<By_distance>(from);
            BOOST_TEST(m.source == (had_source ? 4 : -1));
          }
        },
        taken.method);
    }
}

// What is no surface, or not of it, is refused by each search, with the number of what is wrong.
BOOST_AUTO_TEST_CASE(surfaces_and_vertices_that_are_not_there_are_refused)
{
  const auto says = [](const std::string& message, const char* part) {
    BOOST_TEST(message.find(part) != std::string::npos, message);
  };
  const Triangle_surface none, s = sample::torus(10, 10);
  Triangle_surface two = s;
  for (const Point& p : s.points) { two.points.push_back({p[0] + 20, p[1], p[2]}); }
  for (const auto& t : s.triangles) { two.triangles.push_back({t[0] + 100, t[1] + 100, t[2] + 100}); }
  two = sample::connected(std::move(two));
  for (const auto& run : std::vector<std::function<void(const Triangle_surface&)>>{
         [](const Triangle_surface& t) { pipeline::cut(t); },
         [](const Triangle_surface& t) { pipeline::generators(t); },
         [](const Triangle_surface& t) { pipeline::basis(t); }})
  {
    says(refusal([&] { run(none); }), "no faces");
    const std::string message = refusal([&] { run(two); });
    says(message, "2 pieces");
    says(message, "200");
  }
  const auto refused = [&](const Cut_options& o) { return refusal([&] { pipeline::cut(s, o); }); };
  for (const Index v : {-2, 100, 1000000000})
  {
    const std::string number = "no vertex " + std::to_string(v);
    says(refused(with(Harmonic_field(), {v}, {5})), number.c_str());
    says(refused(with(Harmonic_field(), {5}, {v})), number.c_str());
    Cut_options through;
    through.links.source = v;
    says(refused(through), number.c_str());
    says(refused(with(Distance_field{v})), number.c_str());
    By_distance distance;
    distance.source = v;
    says(refused(with(distance)), number.c_str());
    says(refused(with(By_tree_cotree{v})), number.c_str());
  }
  says(refused(with(Harmonic_field(), {1})), "go together");
  for (const std::size_t n : {99u, 101u})
  {
    says(refused(with(Given_field{std::vector<double>(n, 1)})), "100 vertices");
    By_contours contours;
    contours.preference = preference::low_weight(std::vector<double>(n, 1));
    says(refused(with(contours)), "100 vertices");
  }
  says(refused(with(Given_field{std::vector<double>(100, std::nan(""))})), "not finite at vertex 0");
  const auto open = sample::punctured(s, {0, 90}); // the weights of an open surface are those of its own vertices
  Generator_options g;
  g.is_open = true;
  g.preference = preference::low_weight(std::vector<double>(static_cast<std::size_t>(open.number_of_vertices()), 1));
  BOOST_TEST(refusal([&] { pipeline::generators(open, g); }) == "");
  g.preference =
    preference::low_weight(std::vector<double>(static_cast<std::size_t>(open.number_of_vertices()) + 2, 1));
  says(refusal([&] { pipeline::generators(open, g); }), "needs one a vertex");
}
