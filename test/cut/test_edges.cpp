// Cut graphs, loops and links of existing edges: no vertex is added.
#include "support/implicit_surfaces.h"
#include "support/pipeline.h"
#include "support/sample_surfaces.h"

#include <meridian/base/Union_find.h>
#include <meridian/base/exceptions.h>
#include <meridian/base/vectors.h>
#include <meridian/curves/contours.h>
#include <meridian/curves/project_contours.h>
#include <meridian/curves/snap_to_edges.h>
#include <meridian/cut/Cut.h>
#include <meridian/cut/edge_cuts.h>
#include <meridian/cut/edge_cuts_near.h>
#include <meridian/cut/internal/edge_trees.h>
#include <meridian/cut/link_on_edges.h>
#include <meridian/field/geodesic_distance.h>
#include <meridian/handles/find_meridians.h>
#include <meridian/handles/select_meridians.h>
#include <meridian/proof/verify_cut.h>
#include <meridian/result/recount.h>
#include <meridian/surface/Closed_model.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/Surface_curve.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/insert_curves.h>
#include <meridian/surface/measures.h>
#include <meridian/surface/open_along.h>
#include <meridian/surface/seam_paths.h>
#include <meridian/surface/seams.h>

#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

#include <set>

namespace data = boost::unit_test::data;
using namespace meridian;

namespace {

int number_of_loops(const Triangle_surface& s) { return static_cast<int>(boundary_loops(s).size()); }

void check_is_disc(const Triangle_surface& root, Refined_surface refined)
{
  Cut cut;
  cut.boundary_loops = number_of_loops(root);
  cut.genus = (2 - sample::euler_characteristic(root) - cut.boundary_loops) / 2;
  cut.surface = std::move(refined);
  cut.opened = open_along(cut.surface);
  for (const auto& failure : verify_cut(root, cut).failures) { BOOST_ERROR(failure); }
}

void check_is_disc(const Triangle_surface& root, const std::vector<Index>& edges)
{
  BOOST_REQUIRE(std::is_sorted(edges.begin(), edges.end()));
  BOOST_REQUIRE((std::adjacent_find(edges.begin(), edges.end()) == edges.end()));
  for (Index h : edges) { BOOST_REQUIRE(root.opposite[h] > h); }
  Refined_surface refined(root);
  flag_seam(refined, edges);
  check_is_disc(root, refined);
  // Nothing dangles, but the two ends of a path over a sphere.
  std::map<Index, int> degree;
  for (Index h : edges)
  {
    ++degree[root.source(h)];
    ++degree[root.target(h)];
  }
  int dangling = 0;
  for (const auto& [v, count] : degree) { dangling += count == 1 && !root.is_boundary_vertex(v); }
  const bool is_sphere = sample::euler_characteristic(root) == 2;
  BOOST_TEST(dangling == (is_sphere ? 2 : 0));
  BOOST_TEST((edges.size() >= 2 || !is_sphere));
}

Triangle_surface annulus(int n, int m)
{
  const auto whole = sample::torus(n, m);
  return sample::without(whole, [&](Index f) { return f / 2 / m == 0; });
}

// Vertices no two of which have neighbours in common, at random.
std::vector<Index> scattered(const Triangle_surface& s, std::size_t wanted, unsigned seed)
{
  std::mt19937 random(seed);
  std::vector<char> taken(s.number_of_vertices(), 0);
  std::vector<Index> chosen;
  for (int tries = 0; tries < 1000 && chosen.size() < wanted; ++tries)
  {
    const Index v = static_cast<Index>(random() % s.number_of_vertices());
    std::set<Index> around{v};
    for (int rings = 0; rings < 2; ++rings)
      for (Index u : std::set<Index>(around))
      {
        s.for_each_outgoing(u, [&](Index h) { around.insert(s.target(h)); });
      }
    if (std::any_of(around.begin(), around.end(), [&](Index u) { return taken[u] || s.is_boundary_vertex(u); }))
    {
      continue;
    }
    for (Index u : around) { taken[u] = 1; }
    chosen.push_back(v);
  }
  return chosen;
}

Triangle_surface with_holes(const Triangle_surface& s, std::size_t holes, unsigned seed)
{
  return sample::punctured(s, scattered(s, holes, seed));
}

Triangle_surface tetrahedron()
{
  Triangle_surface s;
  s.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  s.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  return sample::connected(s);
}

Triangle_surface moebius_torus() // seven vertices, every two of them joined
{
  Triangle_surface s;
  for (int i = 0; i < 7; ++i) { s.points.push_back({std::cos(i), std::sin(2. * i), 0.3 * i}); }
  for (Index i = 0; i < 7; ++i)
  {
    s.triangles.push_back({i, (i + 1) % 7, (i + 3) % 7});
    s.triangles.push_back({i, (i + 3) % 7, (i + 2) % 7});
  }
  return sample::connected(s);
}

std::vector<Triangle_surface> all_surfaces()
{
  Triangle_surface pillow; // two faces that share all three edges
  pillow.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  pillow.triangles = {{0, 1, 2}, {0, 2, 1}};
  Triangle_surface triangle;
  triangle.points = pillow.points;
  triangle.triangles = {{0, 1, 2}};
  const auto coarse = sample::torus(4, 4);
  std::vector<Triangle_surface> all{
    tetrahedron(), sample::connected(pillow), sample::connected(triangle), moebius_torus(), sample::sphere(0),
    sample::sphere(3), with_holes(sample::sphere(2), 1, 1), with_holes(sample::sphere(3), 12, 2), annulus(9, 7),
    annulus(3, 3), coarse, sample::torus(3, 3),
    sample::without(sample::torus(3, 3), [](Index f) { return f == 4; }), // all vertices on one boundary loop,
    // or on that of two bands that cross
    sample::without(coarse, [](Index f) { return f / 2 / 4 != 0 && f / 2 % 4 != 0; }), sample::torus(30, 12),
    sample::noisy(sample::torus(30, 12), 0.3, 5), sample::bitorus(24), sample::three_rings(28), sample::teapot(24),
    sample::dumbbell(8, 24)};
  for (int genus = 0; genus < 5; ++genus)
  {
    all.push_back(sample::plate(genus, 1));
    all.push_back(sample::noisy(sample::plate(genus, 3), 0.1, genus));
    for (std::size_t holes : {1u, 2u, 5u})
    {
      all.push_back(with_holes(sample::noisy(sample::plate(genus, 4), 0.05, genus), holes, genus));
    }
  }
  const std::size_t n = all.size();
  for (std::size_t i = 0; i < n; ++i) { all.push_back(sample::renumbered(all[i], static_cast<unsigned>(i))); }
  return all;
}

const std::vector<Triangle_surface>& surfaces()
{
  static const std::vector<Triangle_surface> all = all_surfaces();
  return all;
}

// The contours that cut all handles, as curves.
std::vector<Surface_curve> find_meridians(const Triangle_surface& s, const Point& direction)
{
  std::vector<double> f;
  for (const Point& p : s.points) { f.push_back(dot(p, direction)); }
  const auto m = pipeline::order(s, f, true);
  const auto loops = trace_saddle_loops(m);
  std::vector<std::size_t> order(loops.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::vector<const Contour*> chosen;
  for (const auto& choice : select_meridians(m, loops, order)) { chosen.push_back(&loops[choice.loop]); }
  return project_contours(s, m, chosen);
}

// The genus of what curves leave, and the number of its pieces.
std::pair<int, int> recount(const Triangle_surface& root, const std::vector<Surface_curve>& curves)
{
  Refined_surface s(root);
  insert_curves(root, s, curves);
  const Triangle_surface o = surface_of(s, open_along(s));
  std::vector<Index> piece(o.number_of_faces());
  std::iota(piece.begin(), piece.end(), Index(0));
  const auto find = [&](Index f) {
    while (piece[f] != f) { f = piece[f] = piece[piece[f]]; }
    return f;
  };
  for (Index h = 0; h < o.number_of_halfedges(); ++h)
  {
    if (o.opposite[h] >= 0) { piece[find(o.face(h))] = find(o.face(o.opposite[h])); }
  }
  int pieces = 0;
  for (Index f = 0; f < o.number_of_faces(); ++f) { pieces += piece[f] == f; }
  return {(2 * pieces - sample::euler_characteristic(o) - number_of_loops(o)) / 2, pieces};
}

std::size_t crossings_left(const std::vector<Surface_curve>& curves)
{
  std::size_t count = 0;
  for (const auto& c : curves)
  {
    count += std::count_if(c.points.begin(), c.points.end(), [](const Curve_point& p) { return !p.is_vertex(); });
  }
  return count;
}

void check_are_loops_of_edges(const Triangle_surface& s, const std::vector<Surface_curve>& curves)
{
  std::set<Index> seen;
  for (const Surface_curve& c : curves)
  {
    BOOST_REQUIRE(c.points.size() >= 3u);
    for (std::size_t i = 0; i < c.points.size(); ++i)
    {
      BOOST_REQUIRE(c.points[i].is_vertex());
      BOOST_REQUIRE(seen.insert(c.points[i].vertex).second);
      BOOST_REQUIRE(!s.is_boundary_vertex(c.points[i].vertex));
      BOOST_REQUIRE(s.find_halfedge(c.points[i].vertex, c.points[(i + 1) % c.points.size()].vertex) >= 0);
    }
  }
}

// On a torus of n x m quadrilaterals, a meridian between the rings i and i + 1.
Surface_curve meridian_of_torus(const Triangle_surface& s, int n, int m, int i, double t)
{
  Surface_curve c{{}, true};
  for (int j = 0; j < m; ++j)
  {
    const Index p = i * m + j, far = (i + 1) % n * m + (j + 1) % m, near = i * m + (j + 1) % m;
    c.points.push_back(Curve_point::on_edge(s.find_halfedge(far, p), 1 - t));
    c.points.push_back(Curve_point::on_edge(s.find_halfedge(far, near), 1 - t));
  }
  return c;
}

std::set<Index> vertices_of(const Surface_curve& c)
{
  std::set<Index> all;
  for (const Curve_point& p : c.points) { all.insert(p.vertex); }
  return all;
}

std::set<Index> ring(int m, int i)
{
  std::set<Index> all;
  for (int j = 0; j < m; ++j) { all.insert(i * m + j); }
  return all;
}

} // namespace

BOOST_AUTO_TEST_CASE(loops_at_a_base_point_open_every_surface_to_a_disc)
{
  for (const Triangle_surface& s : surfaces())
    for (Index base : {Index(0), s.number_of_vertices() / 2, s.number_of_vertices() - 1})
    {
      check_is_disc(s, cut_by_tree_cotree(s, base));
    }
}

BOOST_AUTO_TEST_CASE(several_base_points_give_a_disc_and_are_never_worse_than_one)
{
  for (const Triangle_surface& s : surfaces())
  {
    double last = std::numeric_limits<double>::infinity();
    for (int bases : {1, 4, 16})
    {
      const auto cut = find_short_tree_cotree_cut(s, bases);
      check_is_disc(s, cut);
      BOOST_TEST((length_of_edges(s, cut) <= last || bases >= s.number_of_vertices()));
      last = length_of_edges(s, cut);
    }
  }
  std::vector<double> told;
  find_short_tree_cotree_cut(sample::torus(5, 5), 4, [&](double done) { told.push_back(done); });
  BOOST_TEST((told == std::vector<double>{0.25, 0.5, 0.75, 1}));
}

BOOST_AUTO_TEST_CASE(removing_faces_opens_every_surface_to_a_disc)
{
  for (const Triangle_surface& s : surfaces())
    for (Index seed : {Index(-1), Index(0), s.number_of_faces() - 1})
      for (Path_ends ends : {Path_ends::FIXED, Path_ends::SLIDE})
      {
        check_is_disc(s, cut_by_removing_faces(s, seed, ends));
      }
}

BOOST_AUTO_TEST_CASE(straightening_keeps_a_cut_graph_and_never_lengthens_it)
{
  double fixed = 0, sliding = 0, before = 0;
  for (const Triangle_surface& s : surfaces())
    for (const auto& cut :
         {cut_by_removing_faces(s, 0, Path_ends::FIXED, 0), cut_by_tree_cotree(s, s.number_of_vertices() / 2)})
    {
      const double length = length_of_edges(s, cut);
      before += length;
      for (Path_ends ends : {Path_ends::FIXED, Path_ends::SLIDE})
      {
        double last = length;
        for (int rounds : {0, 1, 50})
        {
          const auto shorter = straighten_edge_cut(s, cut, ends, rounds);
          check_is_disc(s, shorter);
          BOOST_TEST(length_of_edges(s, shorter) <= last);
          last = length_of_edges(s, shorter);
          if (rounds == 0) { BOOST_TEST((shorter == cut)); }
        }
        (ends == Path_ends::FIXED ? fixed : sliding) += last;
      }
    }
  BOOST_TEST_MESSAGE("lengths together: " << before << ", straightened between nodes " << fixed
                                          << ", between any places " << sliding);
  BOOST_TEST(fixed < 0.95 * before);
  BOOST_TEST(sliding < 0.95 * fixed);
}

// A cut graph that winds about: what a random tree of faces does not cross, without what dangles.
std::vector<Index> winding_cut(const Triangle_surface& s, unsigned seed)
{
  std::vector<Index> edges;
  for (Index h = 0; h < s.number_of_halfedges(); ++h)
  {
    if (s.opposite[h] > h) { edges.push_back(h); }
  }
  std::shuffle(edges.begin(), edges.end(), std::mt19937(seed));
  Union_find pieces(s.number_of_faces());
  std::vector<char> is_cut(s.number_of_halfedges(), 0);
  for (Index h : edges)
  {
    if (!pieces.unite(s.face(h), s.face(s.opposite[h]))) { is_cut[h] = is_cut[s.opposite[h]] = 1; }
  }
  internal::prune(s, is_cut);
  const auto cut = internal::flagged_edges(s, is_cut);
  return cut.empty() ? cut_by_tree_cotree(s, 0) : cut; // a sphere is opened along a path
}

BOOST_AUTO_TEST_CASE(exchanging_keeps_a_cut_graph_and_never_lengthens_it)
{
  double before = 0, straightened = 0, exchanged = 0, again = 0;
  for (const Triangle_surface& s : surfaces())
    for (unsigned seed : {1, 2})
    {
      const auto cut = winding_cut(s, seed);
      double last = length_of_edges(s, cut);
      before += last;
      straightened += length_of_edges(s, straighten_edge_cut(s, cut, Path_ends::SLIDE, 5));
      BOOST_TEST((exchange_in_edge_cut(s, cut, 0) == cut));
      for (int rounds : {1, 2, 50})
      {
        const auto shorter = exchange_in_edge_cut(s, cut, rounds);
        check_is_disc(s, shorter);
        BOOST_TEST(length_of_edges(s, shorter) <= last);
        last = length_of_edges(s, shorter);
        if (rounds < 50) { continue; }
        // cells that grow only where something changed miss little that all of them anew find
        const double once_more = length_of_edges(s, exchange_in_edge_cut(s, shorter, 1));
        BOOST_TEST(once_more >= 0.975 * last);
        again += once_more;
      }
      exchanged += last;
    }
  BOOST_TEST_MESSAGE("lengths together: " << before << ", straightened " << straightened << ", exchanged " << exchanged
                                          << ", exchanged again " << again);
  BOOST_TEST(again > 0.995 * exchanged);
  BOOST_TEST(exchanged < 0.7 * before);
  BOOST_TEST(exchanged < 1.05 * straightened);
}

// A scale or a reflection changes no order of lengths, so the same edges are exchanged.
BOOST_AUTO_TEST_CASE(exchanging_commutes_with_scaling)
{
  for (const Triangle_surface& s : surfaces())
  {
    const auto cut = winding_cut(s, 4);
    BOOST_TEST((exchange_in_edge_cut(s, cut) == exchange_in_edge_cut(sample::scaled(s, 4), cut)));
  }
}

// Known answer: a meridian and the inner circle, which meet once.
BOOST_AUTO_TEST_CASE(of_all_base_points_of_a_torus_the_best_is_on_the_inner_circle)
{
  constexpr int n = 24, m = 12;
  const auto s = sample::torus(n, m);
  const double meridian = m * s.length(s.find_halfedge(0, 1)), inner = n * s.length(s.find_halfedge(m / 2, m + m / 2));
  double least = std::numeric_limits<double>::infinity();
  for (Index base = 0; base < s.number_of_vertices(); ++base)
  {
    const auto cut = cut_by_tree_cotree(s, base);
    const double length = length_of_edges(s, cut);
    least = std::min(least, length);
    if (base % m == m / 2) { BOOST_TEST(length == meridian + inner, boost::test_tools::tolerance(1e-9)); }
    else { BOOST_TEST(length > (meridian + inner) * 1.0001); }
  }
  const auto best = find_short_tree_cotree_cut(s, s.number_of_vertices());
  BOOST_TEST(length_of_edges(s, best) == least);
  BOOST_TEST(best.size() == static_cast<std::size_t>(n + m));
  std::map<Index, int> degree;
  for (Index h : best)
  {
    ++degree[s.source(h)];
    ++degree[s.target(h)];
  }
  BOOST_TEST(std::count_if(degree.begin(), degree.end(), [](const auto& d) { return d.second == 4; }) == 1);
  BOOST_TEST(degree.size() == static_cast<std::size_t>(n + m - 1)); // all others are passed once
}

// Known answer: between the two boundaries the shortest way.
BOOST_DATA_TEST_CASE(an_annulus_is_cut_across_along_the_shortest_way, data::xrange(5), seed)
{
  const auto s = sample::renumbered(sample::noisy(annulus(11, 8), 0.4, seed), seed);
  const Closed_model g = make_closed_model(s);
  BOOST_REQUIRE(g.number_of_nodes == g.first_loop_node + 2);
  const double across = edge_distances(g, edge_lengths(s, g), g.first_loop_node)[g.first_loop_node + 1];
  const auto close = boost::test_tools::tolerance(1e-9);
  BOOST_TEST(length_of_edges(s, find_short_tree_cotree_cut(s, s.number_of_vertices())) == across, close);
  // Going along the boundary costs nothing: from each vertex on it the shortest way across is found.
  for (Index v = 0; v < s.number_of_vertices(); ++v)
    if (s.is_boundary_vertex(v)) { BOOST_TEST(length_of_edges(s, cut_by_tree_cotree(s, v)) == across, close); }
  BOOST_TEST(length_of_edges(s, cut_by_removing_faces(s, -1, Path_ends::SLIDE)) == across, close);
  Refined_surface linked(s);
  const auto links = link_boundaries_on_edges(linked);
  BOOST_REQUIRE(links.size() == 1u);
  BOOST_TEST(length_of_edges(s, internal::flagged_edges(s, linked.seam)) == across, close);
}

BOOST_AUTO_TEST_CASE(discs_stay_whole)
{
  Triangle_surface triangle;
  triangle.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  triangle.triangles = {{0, 1, 2}};
  for (const auto& s : {sample::connected(triangle), with_holes(sample::sphere(2), 1, 4)})
  {
    BOOST_TEST(cut_by_tree_cotree(s, 1).empty());
    BOOST_TEST(find_short_tree_cotree_cut(s, 3).empty());
    BOOST_TEST(cut_by_removing_faces(s).empty());
    BOOST_TEST(cut_of_edges_near(s, Refined_surface(s)).empty());
    Refined_surface refined(s);
    BOOST_TEST(link_boundaries_on_edges(refined).empty());
  }
}

BOOST_AUTO_TEST_CASE(a_cut_of_edges_is_the_nearest_to_itself)
{
  for (const Triangle_surface& s : surfaces())
  {
    if (sample::euler_characteristic(s) == 2) { continue; }
    for (const auto& cut : {cut_by_removing_faces(s, 0), cut_by_tree_cotree(s, s.number_of_vertices() / 3)})
    {
      Refined_surface refined(s);
      flag_seam(refined, cut);
      BOOST_TEST((cut_of_edges_near(s, refined, 0) == cut));
    }
  }
}

// What is near a seam that is no cut graph yet does not depend on numbers either.
BOOST_DATA_TEST_CASE(renumbering_keeps_the_edges_near_a_part_of_a_cut, data::xrange(1, 4), genus)
{
  const auto s = sample::noisy(sample::plate(genus, 4), 0.1, genus), other = sample::renumbered(s, 5);
  const auto near_first_path = [](const Triangle_surface& t, const std::set<std::pair<Point, Point>>& seam) {
    Refined_surface refined(t);
    std::vector<Index> edges;
    for (Index h = 0; h < t.number_of_halfedges(); ++h)
    {
      if (seam.count({t.points[t.source(h)], t.points[t.target(h)]}) > 0) { edges.push_back(h); }
    }
    flag_seam(refined, edges);
    const auto cut = cut_of_edges_near(t, refined, 0);
    check_is_disc(t, cut);
    return length_of_edges(t, cut);
  };
  Refined_surface whole(s);
  flag_seam(whole, cut_by_tree_cotree(s, 0));
  const auto path = seam_paths(whole).front();
  std::set<std::pair<Point, Point>> seam;
  for (std::size_t i = 1; i < path.size(); ++i) { seam.emplace(s.points[path[i - 1]], s.points[path[i]]); }
  BOOST_TEST(near_first_path(s, seam) == near_first_path(other, seam),
             boost::test_tools::tolerance(0.02)); // edges with both ends on it tie
}

BOOST_AUTO_TEST_CASE(edges_near_a_smooth_cut_open_every_surface_to_a_disc)
{
  for (const Triangle_surface& s : surfaces())
  {
    const Cut cut = pipeline::cut(s);
    for (int rounds : {0, 50}) { check_is_disc(s, cut_of_edges_near(s, cut.surface, rounds)); }
  }
}

BOOST_DATA_TEST_CASE(edges_near_a_smooth_cut_are_near_it, data::xrange(4), seed)
{
  for (const auto& s : {sample::noisy(sample::torus(60, 24), 0.05, seed), sample::noisy(sample::sphere(4), 0.01, seed),
                        sample::teapot(40 + seed)})
  {
    const Cut cut = pipeline::cut(s);
    double longest = 0;
    for (Index h = 0; h < s.number_of_halfedges(); ++h) { longest = std::max(longest, s.length(h)); }
    const auto edges = cut_of_edges_near(s, cut.surface);
    // Before it is straightened, all of it zigzags across the seam.
    const internal::Seam_trace trace = internal::trace_seam(s, cut.surface);
    Index away = 0;
    if (sample::euler_characteristic(s) != 2)
      for (Index e : cut_of_edges_near(s, cut.surface, 0))
        away += !trace.crosses[e] && !trace.follows[e] && !trace.is_on[s.source(e)] && !trace.is_on[s.target(e)];
    BOOST_TEST(away == 0);
    double farthest = 0;
    for (Index e : edges)
    {
      double nearest = std::numeric_limits<double>::infinity();
      for (Index h = 0; h < cut.surface.number_of_halfedges(); ++h)
        if (cut.surface.seam[h])
        {
          nearest = std::min(nearest, distance(s.points[s.source(e)], cut.surface.points[cut.surface.source(h)]));
        }
      farthest = std::max(farthest, nearest);
    }
    BOOST_TEST(farthest < 1.01 * longest);
    BOOST_TEST(length_of_edges(s, edges) < 1.7 * cut.length);
  }
}

BOOST_AUTO_TEST_CASE(links_of_edges_leave_a_disc_of_genus_0)
{
  std::vector<Triangle_surface> all{tetrahedron(), sample::sphere(0), sample::sphere(2), annulus(3, 3)};
  for (unsigned seed = 0; seed < 8; ++seed)
    for (std::size_t holes : {2u, 6u, 30u})
    {
      all.push_back(with_holes(sample::noisy(sample::sphere(seed % 2 ? 3 : 4), 0.02, seed), holes, seed));
    }
  for (const auto& s : all)
    for (Index source : {Index(-1), Index(0), s.number_of_vertices() - 1})
    {
      Refined_surface refined(s);
      const auto links =
        link_boundaries_on_edges(refined, source < 0 ? std::vector<Index>{} : std::vector<Index>{source});
      BOOST_TEST(refined.number_of_vertices() == s.number_of_vertices());
      check_is_disc(s, refined);
      bool passes = source < 0 || s.is_boundary_vertex(source);
      for (const auto& link : links) { passes = passes || std::count(link.begin(), link.end(), source) > 0; }
      BOOST_TEST(passes);
      if (source >= 0) { continue; }
      // No longer than a minimum spanning tree of the boundaries, whose distances go along edges and never along a
      // boundary.
      const Closed_model g = make_closed_model(s);
      const Index loops = g.number_of_nodes - g.first_loop_node;
      if (loops < 2) { continue; }
      auto lengths = edge_lengths(s, g);
      std::vector<std::vector<double>> far;
      for (Index l = 0; l < loops; ++l) { far.push_back(edge_distances(g, lengths, g.first_loop_node + l)); }
      std::vector<double> nearest(loops, std::numeric_limits<double>::infinity());
      std::vector<char> done(loops, 0);
      double tree = 0;
      for (Index l = 0, last = 0; l + 1 < loops; ++l)
      {
        done[last] = 1;
        Index next = -1;
        for (Index k = 0; k < loops; ++k)
        {
          nearest[k] = std::min(nearest[k], far[last][g.first_loop_node + k]);
          if (!done[k] && (next < 0 || nearest[k] < nearest[next])) { next = k; }
        }
        tree += nearest[next];
        last = next;
      }
      const double length = length_of_edges(s, internal::flagged_edges(s, refined.seam));
      BOOST_TEST(length <= tree * (1 + 1e-9));
      BOOST_TEST(length >= tree / 2); // a Steiner tree is at least that
    }
}

// Known answer: two loops are joined by a straight link, the third by one from the middle of that, which is shorter
// than one from a loop.
BOOST_AUTO_TEST_CASE(links_begin_on_earlier_links)
{
  const auto whole = sample::skin({20, 24, 1}, [](int, int, int) { return true; });
  std::vector<Index> centers;
  for (Index v = 0; v < whole.number_of_vertices(); ++v)
    for (const Point& p : {Point{3, 8, 1}, Point{15, 8, 1}, Point{9, 19, 1}})
    {
      if (whole.points[v] == p) { centers.push_back(v); }
    }
  const auto s = sample::punctured(whole, centers);
  Refined_surface linked(s);
  const auto links = link_boundaries_on_edges(linked);
  BOOST_REQUIRE(links.size() == 2u);
  BOOST_TEST(links[0].size() == 11u);
  BOOST_TEST(links[1].size() == 11u);
  BOOST_TEST(std::count(links[0].begin(), links[0].end(), links[1].front()) == 1);
  BOOST_TEST(length_of_edges(s, internal::flagged_edges(s, linked.seam)) == 20, boost::test_tools::tolerance(1e-9));
  check_is_disc(s, linked);
}

// Known answer: one curve, or two side by side, go to the rings of vertices beside them.
BOOST_AUTO_TEST_CASE(meridians_of_a_grid_go_to_its_rings)
{
  constexpr int n = 6, m = 5;
  const auto s = sample::torus(n, m);
  const auto one = snap_to_edges(s, {meridian_of_torus(s, n, m, 2, 0.3)}, false);
  check_are_loops_of_edges(s, one);
  BOOST_TEST((vertices_of(one[0]) == ring(m, 2) || vertices_of(one[0]) == ring(m, 3)));
  const auto two = snap_to_edges(s, {meridian_of_torus(s, n, m, 2, 0.7), meridian_of_torus(s, n, m, 2, 0.3)}, false);
  check_are_loops_of_edges(s, two);
  BOOST_TEST((vertices_of(two[0]) == ring(m, 3)));
  BOOST_TEST((vertices_of(two[1]) == ring(m, 2)));
  // The last ring is also the first.
  const auto between = [&](int i, double t) { return meridian_of_torus(s, n, m, i, t); };
  const auto last = snap_to_edges(s, {between(n - 1, 0.7), between(n - 1, 0.3), between(2, 0.5)}, true);
  BOOST_TEST((vertices_of(last[0]) == ring(m, 0)));
  BOOST_TEST((vertices_of(last[1]) == ring(m, n - 1)));
  BOOST_TEST(crossings_left(last) == 0u);
}

// The first curve would take the ring that is the second one's only place; it goes to its other ring in a second try.
BOOST_AUTO_TEST_CASE(a_curve_that_is_stuck_goes_before_the_others)
{
  constexpr int n = 7, m = 5;
  const auto s = sample::torus(n, m);
  const auto between = [&](int i, double t) { return meridian_of_torus(s, n, m, i, t); };
  const auto alone = snap_to_edges(s, {between(2, 0.5)}, false);
  BOOST_REQUIRE((vertices_of(alone[0]) == ring(m, 3)));
  const auto snapped = snap_to_edges(s, {between(2, 0.5), between(3, 0.3), between(3, 0.7)}, false);
  check_are_loops_of_edges(s, snapped);
  BOOST_TEST((vertices_of(snapped[0]) == ring(m, 2)));
  BOOST_TEST((vertices_of(snapped[1]) == ring(m, 3)));
  BOOST_TEST((vertices_of(snapped[2]) == ring(m, 4)));
}

BOOST_AUTO_TEST_CASE(three_curves_across_one_edge_are_refused_or_refined)
{
  constexpr int n = 6, m = 5;
  const auto s = sample::torus(n, m);
  std::vector<Surface_curve> curves;
  for (double t : {0.25, 0.5, 0.75}) { curves.push_back(meridian_of_torus(s, n, m, 2, t)); }
  BOOST_CHECK_EXCEPTION(snap_to_edges(s, curves, false), Invalid_input_error, [](const auto& e) {
    const std::string text = e.what();
    return text.find("curve 1 ") != std::string::npos && text.find("10 edges") != std::string::npos
           && text.find("10-16") != std::string::npos && text.find("--refine-where-needed") != std::string::npos;
  });
  const auto refined = snap_to_edges(s, curves, true);
  BOOST_TEST((vertices_of(refined[0]) == ring(m, 2)));
  BOOST_TEST(crossings_left(refined) == 10u); // of the middle curve only
  BOOST_TEST(refined[1].points.size() == 10u);
  BOOST_TEST((vertices_of(refined[2]) == ring(m, 3)));
  BOOST_TEST((recount(s, refined) == recount(s, curves)));
  BOOST_TEST((recount(s, refined) == std::pair(0, 3)));
}

BOOST_AUTO_TEST_CASE(curves_keep_off_the_boundary)
{
  constexpr int n = 6, m = 5;
  for (int width : {1, 2, 3}) // quadrilaterals from one boundary loop to the other
  {
    auto s = sample::torus(n, m);
    s.points.resize((width + 1) * m);
    s.triangles.resize(2 * width * m);
    connect(s);
    const std::vector<Surface_curve> curve{meridian_of_torus(s, n, m, 0, 0.4)};
    if (width == 1)
    {
      BOOST_CHECK_EXCEPTION(snap_to_edges(s, curve, false), Invalid_input_error,
                            [](const auto& e) { return std::string(e.what()).find("boundary") != std::string::npos; });
      BOOST_TEST(crossings_left(snap_to_edges(s, curve, true)) == 10u);
      continue;
    }
    const auto snapped = snap_to_edges(s, curve, false);
    check_are_loops_of_edges(s, snapped);
    BOOST_TEST((vertices_of(snapped[0]) == ring(m, 1)));
  }
}

// A curve passes twice by one vertex, on its two sides: it may not visit it twice.
BOOST_AUTO_TEST_CASE(a_curve_that_meets_a_vertex_twice_stays_simple)
{
  // On a torus of three by three the circle of slope 1 and its neighbours fill the surface; every strip meets vertices
  // again.
  for (int n : {3, 4, 5})
    for (int m : {3, 4})
    {
      const auto s = sample::torus(n, m);
      for (int i = 0; i < n; ++i)
      {
        const std::vector<Surface_curve> curve{meridian_of_torus(s, n, m, i, 0.5)};
        const auto snapped = snap_to_edges(s, curve, true);
        BOOST_TEST((recount(s, snapped) == recount(s, curve)));
      }
    }
  const auto s = moebius_torus();
  for (Point direction : {Point{1, 0.1, 0.2}, Point{0.1, 1, 0.3}, Point{0.2, 0.1, 1}})
  {
    const auto curves = find_meridians(s, direction);
    BOOST_TEST((recount(s, snap_to_edges(s, curves, true)) == std::pair(0, 1)));
  }
}

// Theorem: moving curves onto edges keeps what they cut off; each meridian takes a handle.
BOOST_DATA_TEST_CASE(snapped_meridians_cut_the_same_handles, data::xrange(6), genus)
{
  for (unsigned seed = 0; seed < 6; ++seed)
    for (const int k : {1, 2, 6})
    {
      auto s = sample::renumbered(sample::noisy(sample::plate(genus, k), 0.1, seed), seed);
      if (seed % 2) { s = with_holes(s, seed, seed); }
      const auto curves = find_meridians(s, {1, 0.1 * seed, 0.3});
      BOOST_REQUIRE(curves.size() == static_cast<std::size_t>(genus));
      std::vector<Surface_curve> snapped;
      try
      {
        snapped = snap_to_edges(s, curves, false);
        check_are_loops_of_edges(s, snapped);
      }
      catch (const Invalid_input_error&)
      {
        BOOST_TEST(k <= 2); // fine enough otherwise
      }
      const auto refined = snap_to_edges(s, curves, true);
      BOOST_TEST((snapped.empty() || crossings_left(refined) == 0));
      for (std::size_t i = 0; i <= refined.size(); ++i)
      {
        const std::vector<Surface_curve> some(refined.begin(), refined.begin() + static_cast<std::ptrdiff_t>(i));
        BOOST_TEST((recount(s, some) == std::pair(genus - static_cast<int>(i), 1)));
      }
      Refined_surface cut(s);
      insert_curves(s, cut, refined);
      const Index vertices = cut.number_of_vertices();
      BOOST_TEST(vertices == s.number_of_vertices() + static_cast<Index>(crossings_left(refined)));
      link_boundaries_on_edges(cut);
      BOOST_TEST(cut.number_of_vertices() == vertices);
      check_is_disc(s, cut);
    }
}

// All contours of saddles, separating ones too: what they leave, one by one and all together, is what their loops of
// edges leave.
BOOST_DATA_TEST_CASE(snapped_contours_leave_what_the_contours_leave, data::xrange(20), seed)
{
  const auto s = sample::noisy(sample::plate(1 + seed % 3, 3), 0.2, seed);
  std::vector<double> f;
  std::mt19937 random(seed);
  for (const Point& p : s.points) { f.push_back(p[0] + 0.7 * p[1] + static_cast<double>(random() % 1000) / 700.); }
  const auto m = pipeline::order(s, f, false);
  const auto loops = trace_saddle_loops(m);
  std::vector<const Contour*> all;
  for (const Contour& c : loops)
  {
    all.push_back(&c);
    try
    {
      project_contours(s, m, all);
    }
    catch (const Internal_error&)
    {
      all.pop_back();
    } // can be pulled to a point on the root
  }
  const auto curves = project_contours(s, m, all);
  const auto snapped = snap_to_edges(s, curves, true);
  BOOST_TEST((recount(s, snapped) == recount(s, curves)));
  for (std::size_t i = 0; i < curves.size(); ++i)
  {
    BOOST_TEST((recount(s, {snapped[i]}) == recount(s, {curves[i]})));
    for (std::size_t j = i + 1; j < curves.size(); j += 41)
      BOOST_TEST((recount(s, {snapped[i], snapped[j]}) == recount(s, {curves[i], curves[j]})));
  }
}

BOOST_AUTO_TEST_CASE(a_thick_torus_is_cut_without_a_new_vertex)
{
  for (const auto& s : {sample::torus(60, 24), sample::noisy(sample::torus(40, 20), 0.05, 1), sample::three_rings(40),
                        sample::teapot(40)})
  {
    const auto curves = find_meridians(s, {1, 0.2, 0.1});
    const auto snapped = snap_to_edges(s, curves, false);
    check_are_loops_of_edges(s, snapped);
    Refined_surface cut(s);
    insert_curves(s, cut, snapped);
    link_boundaries_on_edges(cut);
    BOOST_TEST(cut.number_of_vertices() == s.number_of_vertices());
    BOOST_TEST((cut.triangles == s.triangles));
    check_is_disc(s, cut);
  }
}

BOOST_AUTO_TEST_CASE(edge_cuts_are_the_same_each_time)
{
  const auto s = with_holes(sample::noisy(sample::plate(3, 4), 0.05, 3), 3, 3);
  BOOST_TEST((find_short_tree_cotree_cut(s, 8) == find_short_tree_cotree_cut(s, 8)));
  BOOST_TEST((cut_by_removing_faces(s) == cut_by_removing_faces(s)));
  const auto scaled = sample::scaled(s, 1e6);
  BOOST_TEST((find_short_tree_cotree_cut(s, 8) == find_short_tree_cotree_cut(sample::scaled(s, 0x1p-20), 8)));
  BOOST_TEST(length_of_edges(scaled, cut_by_removing_faces(scaled))
               == 1e6 * length_of_edges(s, cut_by_removing_faces(s)),
             boost::test_tools::tolerance(1e-6));
}

BOOST_AUTO_TEST_CASE(what_does_not_exist_is_refused_by_name)
{
  const auto s = sample::torus(4, 4);
  const auto names = [](const char* what) {
    return [=](const auto& e) { return std::string(e.what()).find(what) != std::string::npos; };
  };
  BOOST_CHECK_EXCEPTION(cut_by_tree_cotree(s, 16), Invalid_input_error, names("vertex 16"));
  BOOST_CHECK_EXCEPTION(cut_by_tree_cotree(s, -1), Invalid_input_error, names("vertex -1"));
  BOOST_CHECK_EXCEPTION(cut_by_removing_faces(s, 32), Invalid_input_error, names("face 32"));
  BOOST_CHECK_EXCEPTION(find_short_tree_cotree_cut(s, 0), Invalid_input_error, names("0 base points"));
  BOOST_CHECK_EXCEPTION(snap_to_edges(s, {Surface_curve{{Curve_point::on_vertex(0)}, false}}, false),
                        Invalid_input_error, names("curve 0"));
  std::vector<Index> loop; // a meridian alone leaves an annulus
  for (Index j = 0; j < 4; ++j) { loop.push_back(s.edge(s.find_halfedge(j, (j + 1) % 4))); }
  BOOST_CHECK_EXCEPTION(straighten_edge_cut(s, loop), Invalid_input_error, names("no cut graph"));
  BOOST_CHECK_EXCEPTION(exchange_in_edge_cut(s, loop), Invalid_input_error, names("no cut graph"));
}

// Whatever edges they are given, both end, and say so if these are no cut graph where they find that.
BOOST_DATA_TEST_CASE(straightening_ends_for_any_edges, data::xrange(200), seed)
{
  const auto s = seed % 2 ? sample::torus(5, 4) : annulus(5, 4);
  std::mt19937 random(seed);
  const unsigned part = 1 + random() % 9;
  std::vector<char> flags(s.number_of_halfedges(), 0);
  for (Index h = 0; h < s.number_of_halfedges(); ++h)
  {
    if (s.opposite[h] > h && random() % 10 < part) { flags[h] = flags[s.opposite[h]] = 1; }
  }
  if (seed % 3) { internal::prune(s, flags); }
  const auto edges = internal::flagged_edges(s, flags);
  try
  {
    BOOST_TEST(length_of_edges(s, exchange_in_edge_cut(s, edges)) <= length_of_edges(s, edges));
    BOOST_TEST(length_of_edges(s, straighten_edge_cut(s, edges)) <= length_of_edges(s, edges));
  }
  catch (const Invalid_input_error& e)
  {
    BOOST_TEST(std::string(e.what()).find("no cut graph") != std::string::npos);
  }
}
