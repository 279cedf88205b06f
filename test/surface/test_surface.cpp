#include "support/pipeline.h"
#include "support/sample_surfaces.h"

#include <meridian/base/Euler_tour.h>
#include <meridian/base/exceptions.h>
#include <meridian/base/vectors.h>
#include <meridian/field/geodesic_distance.h>
#include <meridian/surface/Closed_model.h>
#include <meridian/surface/Face_tree.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/Surface_curve.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/distance_rings.h>
#include <meridian/surface/insert_curves.h>
#include <meridian/surface/measures.h>
#include <meridian/surface/open_along.h>
#include <meridian/surface/shortest_ways.h>

#include <algorithm>
#include <limits>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace data = boost::unit_test::data;
using namespace meridian;

// Known answers: what the samples of all other tests are.
BOOST_AUTO_TEST_CASE(the_sample_surfaces_have_the_topology_that_they_claim)
{
  for (int genus = 0; genus <= 5; ++genus)
  {
    BOOST_TEST(sample::euler_characteristic(sample::plate(genus)) == 2 - 2 * genus);
    BOOST_TEST(boundary_loops(sample::plate(genus)).empty());
  }
  BOOST_TEST(sample::euler_characteristic(sample::torus(7, 5)) == 0);
  BOOST_TEST(sample::euler_characteristic(sample::sphere(2)) == 2);
  const auto dumbbell = sample::dumbbell(60);
  BOOST_TEST(sample::euler_characteristic(dumbbell) == -2);
  BOOST_TEST(boundary_loops(dumbbell).empty());
  const auto open = sample::punctured(sample::torus(12, 9), {0, 40});
  BOOST_TEST(boundary_loops(open).size() == 2u);
  BOOST_TEST(sample::euler_characteristic(open) == -2);
}

BOOST_AUTO_TEST_CASE(twins_run_in_opposite_directions_and_fans_are_whole)
{
  const auto s = sample::punctured(sample::plate(2), {17});
  std::vector<int> faces_around(s.number_of_vertices(), 0), counted(s.number_of_vertices(), 0);
  for (const auto& t : s.triangles)
  {
    for (Index v : t) { ++counted[v]; }
  }
  for (Index h = 0; h < s.number_of_halfedges(); ++h)
  {
    if (s.opposite[h] < 0) { continue; }
    BOOST_REQUIRE(s.opposite[s.opposite[h]] == h);
    BOOST_REQUIRE(s.source(h) == s.target(s.opposite[h]));
  }
  for (Index v = 0; v < s.number_of_vertices(); ++v)
  {
    s.for_each_outgoing(v, [&](Index) { ++faces_around[v]; });
  }
  BOOST_TEST(faces_around == counted, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(an_edge_with_two_faces_on_one_side_is_refused)
{
  Triangle_surface s;
  s.points.resize(4);
  s.triangles = {{0, 1, 2}, {0, 1, 3}};
  BOOST_CHECK_THROW(connect(s), Internal_error);
}

// Gauss and Bonnet: the angle defects of a closed surface add up to 2 pi chi.
BOOST_AUTO_TEST_CASE(gaussian_curvature_adds_up_to_two_pi_times_the_euler_characteristic)
{
  for (int genus : {0, 1, 3})
  {
    const auto s = sample::plate(genus);
    double sum = 0;
    for (Index v = 0; v < s.number_of_vertices(); ++v)
    {
      double around = 0;
      s.for_each_outgoing(v, [&](Index h) {
        around += norm(cross(s.points[s.target(h)] - s.points[v], s.points[s.apex(h)] - s.points[v])) / 6;
      });
      sum += curvature(s, v).gaussian * around;
    }
    BOOST_TEST(sum == 2 * sample::pi * (2 - 2 * genus), boost::test_tools::tolerance(1e-9));
  }
}

BOOST_AUTO_TEST_CASE(mean_curvature_of_a_sphere_is_one_over_the_radius)
{
  const auto s = sample::scaled(sample::sphere(4), 2);
  double sum = 0;
  for (Index v = 0; v < s.number_of_vertices(); ++v) { sum += curvature(s, v).mean; }
  BOOST_TEST(sum / s.number_of_vertices() == 0.5, boost::test_tools::tolerance(0.02));
}

BOOST_AUTO_TEST_CASE(an_inserted_curve_becomes_seam_edges_and_the_surface_keeps_its_topology_and_area)
{
  const auto root = sample::noisy(sample::torus(9, 8), 0.1, 1);
  Refined_surface s(root);
  const auto inserted =
    insert_curves(root, s, {sample::ring(root, 20, 0.4), sample::ring(root, 21, 0.3), sample::ring(root, 20, 0.6)});
  BOOST_TEST(sample::euler_characteristic(s) == 0);
  BOOST_TEST(area(s) == area(root), boost::test_tools::tolerance(1e-12));
  Index seams = 0;
  for (Index h = 0; h < s.number_of_halfedges(); ++h)
  {
    seams += s.seam[h];
    BOOST_REQUIRE(s.seam[h] == s.seam[s.opposite[h]]);
  }
  BOOST_TEST(
    seams
    == 2 * static_cast<Index>(inserted.vertices[0].size() + inserted.vertices[1].size() + inserted.vertices[2].size()));
  Triangle_surface again;
  again.points = s.points;
  again.triangles = s.triangles;
  connect(again);
  BOOST_TEST(again.opposite == s.opposite, boost::test_tools::per_element());
  BOOST_TEST(smallest_angle(s) > 0.01);
}

BOOST_AUTO_TEST_CASE(origins_lead_back_to_the_root_through_two_refinements)
{
  const auto root = sample::noisy(sample::sphere(2), 0.05, 2);
  Refined_surface s(root);
  insert_curves(root, s, {sample::ring(root, 3, 0.5)}, false);
  const Index fresh = root.number_of_vertices(); // a vertex of the first ring
  insert_curves(root, s, {sample::ring(s, fresh, 0.5)}, false);
  std::set<int> kinds;
  for (Index v = 0; v < s.number_of_vertices(); ++v)
  {
    const Origin o = s.origin(v);
    kinds.insert(o.kind);
    BOOST_TEST(distance(position(root, o), s.points[v]) < 1e-12);
  }
  BOOST_TEST(kinds.size() == 3u);
}

BOOST_AUTO_TEST_CASE(curves_that_cross_in_a_face_are_refused)
{
  const auto root = sample::sphere(1);
  const Index v = 0;
  Surface_curve a = sample::ring(root, v, 0.5), b = a;
  // The same ring, but two neighbouring points changed places along their edges relative to `a`.
  b.points[0].t += 0.1;
  for (std::size_t i = 1; i < b.points.size(); ++i) { b.points[i].t -= 0.1; }
  Refined_surface s(root);
  BOOST_CHECK_THROW(insert_curves(root, s, {a, b}), Internal_error);
}

BOOST_AUTO_TEST_CASE(opening_along_a_ring_gives_a_disc_and_the_rest)
{
  const auto root = sample::torus(9, 8);
  Refined_surface s(root);
  insert_curves(root, s, {sample::ring(root, 20, 0.4)});
  const auto opened = open_along(s);
  const Triangle_surface o = surface_of(s, opened);
  BOOST_TEST(boundary_loops(o).size() == 2u);
  BOOST_TEST(opened.copy_of.size() == opened.seams.size());
  BOOST_TEST(sample::euler_characteristic(o) == 0); // a disc and a torus with a hole
}

// Known answer, and the angle of every corner one by one.
BOOST_AUTO_TEST_CASE(the_smallest_angle_is_the_smallest_of_all_corners)
{
  const auto s = sample::noisy(sample::torus(20, 9), 0.3, 5);
  double smallest = 10;
  for (Index h = 0; h < s.number_of_halfedges(); ++h) { smallest = std::min(smallest, corner_angle(s, h)); }
  BOOST_TEST(smallest_angle(s) == smallest, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(smallest_angle(sample::plate(0, 1)) == sample::pi / 4, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(distant_nodes_lie_on_different_boundary_loops)
{
  const auto tube = sample::punctured(sample::sphere(3), {4, 5});
  const auto g = make_closed_model(tube);
  BOOST_TEST(g.number_of_nodes == g.first_loop_node + 2);
  const auto [a, b] = find_distant_nodes(tube, g);
  BOOST_TEST(a != b);
  const auto d = edge_distances(g, edge_lengths(tube, g), a);
  BOOST_TEST(d[b] > 2.5); // a half circle is pi
}

// Definition: the nearest come first, and those that are equally far in their order, whatever order they came in.
BOOST_AUTO_TEST_CASE(places_come_nearest_first_and_in_order_where_they_are_equally_far)
{
  std::mt19937 random(5);
  std::vector<std::pair<double, Index>> places;
  internal::Nearest_first<Index> queue;
  for (Index i = 0; i < 200; ++i)
  {
    places.emplace_back(random() % 7, static_cast<Index>(random() % 50));
    queue.reach(places.back().first, places.back().second);
  }
  std::sort(places.begin(), places.end());
  std::size_t left = 0;
  BOOST_TEST(queue.search([&](double d, Index place) {
    BOOST_TEST((places[left] == std::pair<double, Index>(d, place)));
    return ++left == 150;
  }));
  BOOST_TEST(!queue.search([&](double, Index) { return ++left > 200; }));
  BOOST_TEST(left == 200u);
}

// Theorem (Bellman 1958): lengths are those of shortest ways if no edge makes one shorter, and each has its last edge.
BOOST_AUTO_TEST_CASE(ways_through_faces_and_along_edges_cannot_be_shortened)
{
  const Triangle_surface s = sample::noisy(sample::punctured(sample::plate(2), {17}), 0.05, 3);
  const internal::Face_tree tree = internal::grow_face_tree(s, 40);
  for (Index f = 0; f < s.number_of_faces(); ++f)
  {
    BOOST_TEST((tree.by[f] < 0) == (f == 40));
    if (f == 40) { BOOST_TEST(tree.distance[f] == 0); }
    const auto& t = s.triangles[f];
    const Point from = f == 40 ? (1. / 3) * (s.points[t[0]] + s.points[t[1]] + s.points[t[2]])
                               : 0.5 * (s.points[s.source(tree.by[f])] + s.points[s.target(tree.by[f])]);
    BOOST_TEST(distance(tree.entry(s, f), from) < 1e-14);
    for (Index h = 3 * f; h < 3 * f + 3; ++h)
    {
      if (s.opposite[h] < 0) { continue; }
      const Index g = s.face(s.opposite[h]);
      const double reached = tree.distance[f] + distance(tree.entry(s, f), s.point_on(h, 0.5));
      BOOST_TEST(tree.distance[g] <= reached);
      if (tree.by[g] == h) { BOOST_TEST(tree.distance[g] == reached); }
    }
    if (f != 40) { BOOST_TEST(s.face(s.opposite[tree.by[f]]) == f); }
  }
  const Closed_model g = make_closed_model(s);
  const std::vector<double> lengths = edge_lengths(s, g), at = edge_distances(g, lengths, 3);
  for (Index a = 0; a < g.number_of_nodes; ++a)
  {
    double least = a == 3 ? 0 : std::numeric_limits<double>::infinity();
    for (Index i = g.begin[a]; i < g.begin[a + 1]; ++i) { least = std::min(least, at[g.neighbor[i]] + lengths[i]); }
    BOOST_TEST(at[a] == least);
  }
}

// Definition: distances are the same to the last bit whether a heap or rings find them, also where the way round is
// longer than all rings that are near together, or edges are as different as 1 and 10^8 and many lie in one ring.
BOOST_AUTO_TEST_CASE(distances_by_rings_are_those_of_a_heap)
{
  std::mt19937 random(11);
  for (const Triangle_surface& s : {sample::torus(40, 25), sample::torus(1500, 3)})
  {
    const Closed_model g = make_closed_model(s);
    for (double spread : {0., 1., 4.})
    {
      std::vector<double> of_edge(s.number_of_halfedges()), lengths;
      for (double& x : of_edge) { x = std::pow(10, spread * (2. * random() / std::mt19937::max() - 1)); }
      for (Index h : g.halfedge) { lengths.push_back(of_edge[s.edge(h)]); }
      for (Index source : {0, 17, 900})
      {
        const auto at_heap =
          internal::find_shortest_ways(g.number_of_nodes, {{0., source}}, [&](Index a, const auto& reach) {
            for (Index i = g.begin[a]; i < g.begin[a + 1]; ++i) { reach(g.neighbor[i], lengths[i]); }
          });
        BOOST_TEST((edge_distances(g, lengths, source) == at_heap));
      }
    }
  }
}

// A search leaves nothing behind: places come in the same order again, near and far.
BOOST_AUTO_TEST_CASE(rings_of_distance_can_be_searched_again)
{
  internal::Distance_rings rings(1);
  const std::vector<double> at{0.5, 3.5, 300.5, 2000.5};
  for (const Index first : {3, 0, 2, 1})
  {
    std::vector<Index> come;
    for (Index i = first; i < 4; ++i) { rings.reach(at[i], i); }
    rings.search([&](Index place) { return at[place]; }, [&](Index place) { come.push_back(place); });
    BOOST_TEST(come.size() == static_cast<std::size_t>(4 - first));
    BOOST_TEST(std::is_sorted(come.begin(), come.end()));
  }
}

// Theorem (Tarjan, Vishkin 1985): what hangs below a node of a tree is what is entered while the walk is below it.
BOOST_AUTO_TEST_CASE(a_walk_round_a_tree_is_below_a_node_while_it_has_entered_it)
{
  constexpr Index n = 80;
  std::mt19937 random(7);
  std::vector<Index> parent(n, -1);
  std::vector<std::vector<Index>> steps(n); // 2i leads from the parent of i to i, 2i + 1 back
  for (Index i = 1; i < n; ++i)
  {
    parent[i] = static_cast<Index>(random() % i);
    steps[parent[i]].push_back(2 * i);
    steps[i].insert(steps[i].begin(), 2 * i + 1);
  }
  const internal::Euler_tour tour =
    internal::walk_tree(steps, 0, 2 * n, [&](Index step) { return step % 2 ? parent[step / 2] : step / 2; });
  for (Index step = 2; step < 2 * n; ++step) { BOOST_TEST(tour.is_down[step] == (step % 2 == 0)); }
  for (Index a = 0; a < n; ++a)
    for (Index b = 0; b < n; ++b)
    {
      bool is_below = false;
      for (Index c = b; c >= 0 && !is_below; c = parent[c]) { is_below = c == a; }
      BOOST_TEST((tour.enter[a] <= tour.enter[b] && tour.enter[b] < tour.leave[a]) == is_below);
    }
}
