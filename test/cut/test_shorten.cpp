#include "support/pipeline.h"
#include "support/sample_surfaces.h"

#include <meridian/base/Verification.h>
#include <meridian/base/exceptions.h>
#include <meridian/base/vectors.h>
#include <meridian/curves/Normal_curves.h>
#include <meridian/curves/chords.h>
#include <meridian/curves/tighten_curves.h>
#include <meridian/cut/Cut.h>
#include <meridian/cut/edge_cuts.h>
#include <meridian/cut/edge_cuts_near.h>
#include <meridian/cut/shorten_cut_graph.h>
#include <meridian/proof/verify_cut.h>
#include <meridian/result/recount.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/Surface_curve.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/insert_curves.h>
#include <meridian/surface/open_along.h>
#include <meridian/surface/seam_paths.h>
#include <meridian/surface/seams.h>

namespace data = boost::unit_test::data;
using namespace meridian;

namespace {

std::vector<std::vector<Index>> paths_of(const Triangle_surface& s, const std::vector<Index>& edges)
{
  Refined_surface r(s);
  flag_seam(r, edges);
  return seam_paths(r);
}

double length_of(const Triangle_surface& s, const std::vector<Surface_curve>& curves)
{
  double sum = 0;
  for (const auto& c : curves) { sum += length(s, c); }
  return sum;
}

// Cuts along curves and recounts the disc with nothing of what found them.
Verification verify(const Triangle_surface& s, const std::vector<Surface_curve>& curves)
{
  Cut cut;
  cut.surface = Refined_surface(s);
  insert_curves(s, cut.surface, curves);
  cut.opened = open_along(cut.surface);
  return verify_cut(s, cut);
}

void check_disc(const Triangle_surface& s, const std::vector<Surface_curve>& curves)
{
  const auto v = verify(s, curves);
  BOOST_TEST(static_cast<bool>(v));
  for (const auto& failure : v.failures) { BOOST_ERROR(failure); }
}

Triangle_surface holed_plate(int genus, int seed)
{
  const auto s = sample::noisy(sample::plate(genus, 4), 0.1, seed);
  return seed % 2 == 0 ? s : sample::punctured(s, {30, s.number_of_vertices() / 2, s.number_of_vertices() - 9});
}

// Two equilateral triangles of side 1, divided `n` times along each side and glued along their sides, without `hole`
// rows of faces at each corner.
Triangle_surface pillow(int n, int hole)
{
  std::map<std::array<int, 3>, Index> number; // barycentric coordinates, and the side for what is inside
  Triangle_surface s;
  const auto vertex = [&](int i, int j, int side) {
    const bool rim = i == 0 || j == 0 || i + j == n;
    const auto [at, is_new] = number.try_emplace({i, j, rim ? 0 : side}, s.number_of_vertices());
    if (is_new) { s.points.push_back({(i + 0.5 * j) / n, std::sqrt(3.) / 2 * j / n, rim ? 0 : side * 1e-3}); }
    return at->second;
  };
  for (int side = 0; side < 2; ++side)
    for (int i = 0; i < n; ++i)
      for (int j = 0; i + j < n; ++j)
        for (const bool up : {true, false})
        {
          if (!up && i + j + 2 > n) { continue; }
          // its row, counted towards each corner
          if (std::max({i, j, n - i - j - (up ? 1 : 2)}) >= n - hole) { continue; }
          std::array<Index, 3> t =
            up ? std::array<Index, 3>{vertex(i, j, side), vertex(i + 1, j, side), vertex(i, j + 1, side)}
               : std::array<Index, 3>{vertex(i + 1, j, side), vertex(i + 1, j + 1, side), vertex(i, j + 1, side)};
          if (side == 1) { std::swap(t[1], t[2]); }
          s.triangles.push_back(t);
        }
  connect(s);
  return s;
}

// All that the orders say.
std::vector<std::vector<Index>> orders_of(const Normal_curves& curves)
{
  std::vector<std::vector<Index>> all;
  for (Index e = 0; e < curves.surface().number_of_halfedges(); ++e)
  {
    auto& here = all.emplace_back();
    for (Index x : curves.on(e))
    {
      here.insert(here.end(),
                  {x, curves[x].halfedge, curves[x].curve, curves[x].prev, curves[x].next, curves[x].place});
    }
    here.push_back(curves.along(e));
  }
  for (Index c = 0; c < curves.number_of_curves(); ++c)
    all.push_back(
      {curves.nearest({c, false}), curves.nearest({c, true}), curves.vertex({c, false}), curves.vertex({c, true})});
  return all;
}

} // namespace

// Theorem: whatever the cut graph was, what is left is a disc, and the graph is not longer.
BOOST_DATA_TEST_CASE(a_shortened_cut_graph_leaves_a_disc, data::xrange(0, 5) * data::xrange(6), genus, seed)
{
  const auto s = holed_plate(genus, seed);
  if (genus == 0 && seed % 2 == 0) { return; } // a sphere has no graph
  for (const auto& edges : {cut_by_tree_cotree(s, seed), cut_by_removing_faces(s, seed)})
  {
    const auto curves = shorten_cut_graph(s, paths_of(s, edges));
    check_disc(s, curves);
    BOOST_TEST(length_of(s, curves) <= length_of_edges(s, edges) * (1 + 1e-12));
    // Shortening what is short gains little.
    Refined_surface r(s);
    insert_curves(s, r, curves);
    const auto again = shorten_cut_graph(s, paths_of(s, cut_of_edges_near(s, r)));
    check_disc(s, again);
    BOOST_TEST(length_of(s, again) < length_of(s, curves) * 1.1);
  }
}

// Known answer: the shortest graph with one vertex that joins the corners of an equilateral triangle has it in the
// middle (Fermat, Torricelli), wherever it begins.
BOOST_DATA_TEST_CASE(the_graph_of_a_pillow_is_steiners_tree, data::xrange(4), start)
{
  constexpr int n = 24, hole = 3;
  const auto s = pillow(n, hole);
  BOOST_REQUIRE(boundary_loops(s).size() == 3u);
  BOOST_REQUIRE(sample::euler_characteristic(s) == -1);
  // The shortest paths along edges from some vertex to the three holes.
  const Point from = std::array<Point, 4>{{{0.3, 0.1, 0}, {0.7, 0.1, 0}, {0.5, 0.6, 0}, {0.55, 0.3, 0}}}[start];
  Index center = 0;
  for (Index v = 0; v < s.number_of_vertices(); ++v)
  {
    if (distance(s.points[v], from) < distance(s.points[center], from)) { center = v; }
  }
  std::vector<Index> by(s.number_of_vertices(), -1), queue{center}, edges;
  std::vector<char> seen(s.number_of_vertices(), 0);
  seen[center] = 1;
  for (std::size_t i = 0; i < queue.size(); ++i)
    s.for_each_outgoing(queue[i], [&](Index h) {
      if (s.opposite[h] < 0 || seen[s.target(h)]) { return; }
      seen[s.target(h)] = 1;
      by[s.target(h)] = h;
      queue.push_back(s.target(h));
    });
  for (const auto& loop : boundary_loops(s))
    for (Index v : queue)
    {
      if (std::none_of(loop.begin(), loop.end(), [&](Index h) { return s.source(h) == v; })) { continue; }
      for (; v != center; v = s.source(by[v])) { edges.push_back(s.edge(by[v])); }
      break;
    }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  const auto curves = shorten_cut_graph(s, paths_of(s, edges));
  check_disc(s, curves);
  const double expected = std::sqrt(3.) - 3 * hole * std::sqrt(3.) / 2 / n, along_sides = 2 - 4. * hole / n;
  BOOST_TEST(length_of(s, curves) < 1.01 * expected);
  BOOST_TEST(length_of(s, curves) > 0.99 * expected);
  BOOST_TEST(expected < along_sides); // the best without a vertex
  BOOST_TEST(curves.size() == 3u);
}

// Known answer: the cut graph of a torus of revolution that no move shortens is not longer than a tube and an inner
// circle.
BOOST_AUTO_TEST_CASE(the_graph_of_a_torus_is_a_meridian_and_the_inner_circle)
{
  const auto s = sample::torus(60, 24, 3, 1);
  for (Index base : {0, 700, 1100})
  {
    const auto curves = shorten_cut_graph(s, paths_of(s, cut_by_tree_cotree(s, base)));
    check_disc(s, curves);
    BOOST_TEST(length_of(s, curves) < (2 * sample::pi + 2 * sample::pi * 2) * 1.02);
  }
}

// Metamorphic: numbers of vertices and faces change where the search goes, units nothing at all.
BOOST_AUTO_TEST_CASE(shortening_does_not_depend_on_units_and_little_on_numbers)
{
  const auto s = sample::noisy(sample::plate(3, 5), 0.1, 4);
  const auto edges = cut_by_tree_cotree(s, 0);
  const auto curves = shorten_cut_graph(s, paths_of(s, edges));
  const auto large = sample::scaled(s, 1024);
  const auto same = shorten_cut_graph(large, paths_of(large, edges));
  BOOST_REQUIRE(same.size() == curves.size());
  for (std::size_t i = 0; i < same.size(); ++i)
  {
    BOOST_REQUIRE(same[i].points.size() == curves[i].points.size());
    for (std::size_t k = 0; k < same[i].points.size(); ++k)
    {
      BOOST_TEST(same[i].points[k].vertex == curves[i].points[k].vertex);
      BOOST_TEST(same[i].points[k].halfedge == curves[i].points[k].halfedge);
    }
  }
  for (unsigned seed : {1u, 2u, 3u})
  {
    const auto other = sample::renumbered(s, seed);
    const double l = length_of(other, shorten_cut_graph(other, paths_of(other, cut_by_tree_cotree(other, 0))));
    BOOST_TEST(l < 1.15 * length_of(s, curves));
    BOOST_TEST(l > length_of(s, curves) / 1.15);
  }
}

// Faces without area, points in one place, needles: distances tie, and still nothing crosses.
BOOST_DATA_TEST_CASE(shortening_stands_bad_shapes, data::xrange(8) * data::xrange(5), base, shape)
{
  for (auto s :
       {sample::plate(1, 3), sample::plate(2, 2), sample::punctured(sample::plate(1, 2), {12}), sample::torus(5, 4)})
  {
    for (Point& p : s.points)
      for (double& x : p) switch (shape)
        {
        case 0: x = std::floor(x + 0.5); break;
        case 1: x = 0; break;
        case 2: x = &x == &p[0] ? 1e7 * x : x; break;
        case 3: x = &x == &p[1] ? 0 : x; break;
        default: x = std::floor(x / 2); break;
        }
    const auto edges = cut_by_tree_cotree(s, base);
    Normal_curves curves(s, 0);
    internal::add_paths(curves, paths_of(s, edges));
    tighten_curves(curves);
    internal::move_vertices(curves, Tighten_options());
    count_crossings(curves);
    const auto shorter = shorten_cut_graph(s, paths_of(s, edges));
    check_disc(s, shorter);
    BOOST_TEST(length_of(s, shorter) <= length_of_edges(s, edges) * (1 + 1e-12));
  }
}

// What is no cut graph is told so.
BOOST_AUTO_TEST_CASE(paths_that_leave_no_disc_are_refused)
{
  const auto s = sample::torus(20, 12);
  auto paths = paths_of(s, cut_by_tree_cotree(s, 7));
  paths.pop_back();
  BOOST_CHECK_THROW(shorten_cut_graph(s, paths), Invalid_input_error);
  BOOST_CHECK_THROW(shorten_cut_graph(s, {{0, s.number_of_vertices() / 2}}), Invalid_input_error);
  BOOST_TEST(shorten_cut_graph(s, {}).empty());
}

// Open curves: an order that makes two chords cross is seen, at edges and at corners.
BOOST_AUTO_TEST_CASE(crossing_open_curves_are_counted)
{
  const auto s = sample::torus(12, 8);
  Normal_curves curves(s, 0);
  const Index f = 30, h = 3 * f, o = s.opposite[h]; // across the side `h` of a face, from corner to corner
  const Index a = curves.add(s.apex(h), s.apex(o), {{h, 0, 0.5}});
  count_crossings(curves);
  BOOST_TEST(curves.vertex({a, true}) == s.apex(o));
  // Another curve that cuts off a corner at one end of the side: it must pass on that side of the first.
  const Index in = s.opposite[s.next(h)];
  const Index out = s.prev(o);
  const auto add = [&](Index place) {
    return curves.add(s.apex(in), s.apex(s.opposite[out]), {{in, 0, 0.5}, {h, place, 0.5}, {out, 0, 0.5}});
  };
  const bool target_is_end = s.edge(h) == h;
  {
    Normal_curves::Trial trial(curves);
    add(target_is_end ? 1 : 0);
    count_crossings(curves);
  }
  {
    Normal_curves::Trial trial(curves);
    add(target_is_end ? 0 : 1);
    BOOST_CHECK_THROW(count_crossings(curves), Internal_error);
  }
}

// Every change can be taken back.
BOOST_DATA_TEST_CASE(trials_leave_no_trace, data::xrange(8), seed)
{
  const auto s = holed_plate(2, seed);
  Normal_curves curves(s, 0);
  internal::add_paths(curves, paths_of(s, cut_by_tree_cotree(s, seed)));
  tighten_curves(curves);
  const auto before = orders_of(curves);
  const double length = internal::network_length(curves);
  {
    Normal_curves::Trial trial(curves);
    internal::move_vertices(curves, Tighten_options());
    Normal_curves::Trial inner(curves);
    internal::move_vertices(curves, Tighten_options());
    inner.keep();
    BOOST_TEST(internal::network_length(curves) < length);
  }
  BOOST_TEST((orders_of(curves) == before));
  BOOST_TEST(internal::network_length(curves) == length);
}

// All vertices of a seam graph end up in paths, each edge once.
BOOST_AUTO_TEST_CASE(seam_paths_hold_every_edge_once)
{
  const auto s = holed_plate(3, 1);
  const auto edges = cut_by_removing_faces(s, 3);
  std::vector<std::array<Index, 2>> expected, found;
  for (Index e : edges)
  {
    expected.push_back({std::min(s.source(e), s.target(e)), std::max(s.source(e), s.target(e))});
  }
  for (const auto& path : paths_of(s, edges))
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
    {
      found.push_back({std::min(path[i], path[i + 1]), std::max(path[i], path[i + 1])});
    }
  std::sort(expected.begin(), expected.end());
  std::sort(found.begin(), found.end());
  BOOST_TEST((expected == found));
  // A circle alone.
  const auto torus = sample::torus(9, 7);
  std::vector<Index> circle;
  for (Index h = 0; h < torus.number_of_halfedges(); ++h)
    if (torus.edge(h) == h && torus.source(h) < 7 && torus.target(h) < 7) { circle.push_back(h); }
  const auto paths = paths_of(torus, circle);
  BOOST_REQUIRE(paths.size() == 1u);
  BOOST_TEST(paths[0].size() == circle.size() + 1);
  BOOST_TEST(paths[0].front() == paths[0].back());
}
