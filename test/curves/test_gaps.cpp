// Ways through the gaps between normal curves.
#include "support/pipeline.h"
#include "support/sample_surfaces.h"

#include <meridian/base/vectors.h>
#include <meridian/curves/Gap_graph.h>
#include <meridian/curves/Normal_curves.h>
#include <meridian/curves/add_contours.h>
#include <meridian/curves/chords.h>
#include <meridian/curves/find_crossing_loop.h>
#include <meridian/curves/project_contours.h>
#include <meridian/field/order_surface.h>
#include <meridian/handles/find_meridians.h>
#include <meridian/handles/preference.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/measures.h>
#include <meridian/surface/shortest_ways.h>

#include <boost/test/unit_test.hpp>

#include <limits>
#include <map>
#include <vector>

using namespace meridian;
using namespace meridian::internal;

namespace {

// The meridians of a surface, as every second curve.
Normal_curves meridians(const Triangle_surface& s)
{
  const int g = genus(s);
  const Ordered_surface m = order_surface(s, {}, run_unwatched);
  Meridian_search search;
  search.loops = trace_saddle_loops(m);
  find_meridians(s, m, g, preference::short_length, search);
  Normal_curves curves(s, 2 * g);
  add_contours(project_crossings(s, m, search.chosen()), curves);
  return curves;
}

// How far every gap is from the left side of a curve.
std::map<Gap, double> distances_from(const Normal_curves& curves, Index curve)
{
  const Triangle_surface& s = curves.surface();
  const auto point = [&](const Gap& g) { return s.point_on(g.edge, middle_of(curves, g)); };
  std::map<Gap, double> distance_to;
  Nearest_first<Gap> queue;
  for (Index x : curves.crossings(curve))
  {
    distance_to[gap_beside(curves, x, true)] = 0;
    queue.reach(0, gap_beside(curves, x, true));
  }
  queue.search([&](double at, const Gap& g) {
    if (at > distance_to[g]) { return false; }
    for (Index h : {g.edge, s.opposite[g.edge]})
    {
      if (h < 0) { continue; }
      for_each_gap_around(curves, g, s.face(h), [&](const Gap& to, Index) {
        const double d = at + distance(point(g), point(to));
        const auto [known, is_new] = distance_to.emplace(to, d);
        if (!is_new && !(d < known->second)) { return; }
        known->second = d;
        queue.reach(d, to);
      });
    }
    return false;
  });
  return distance_to;
}

double shortest_across(const Normal_curves& curves, Index curve)
{
  const std::map<Gap, double> distance_to = distances_from(curves, curve);
  double least = std::numeric_limits<double>::infinity();
  for (Index x : curves.crossings(curve))
  {
    const auto found = distance_to.find(gap_beside(curves, x, false));
    if (found != distance_to.end()) { least = std::min(least, found->second); }
  }
  return least;
}

std::vector<Triangle_surface> surfaces()
{
  return {sample::torus(16, 8), sample::plate(3), sample::noisy(sample::plate(5, 3), 0.1, 1),
          sample::noisy(sample::plate(8, 2), 0.1, 2)};
}

} // namespace

BOOST_AUTO_TEST_CASE(the_shortest_way_across_a_curve_is_found_among_more_and_more_curves)
{
  for (const Triangle_surface& s : surfaces())
  {
    Normal_curves curves = meridians(s);
    Crossing_loop_search search(curves);
    for (Index i = 0; i < curves.number_of_pairs(); ++i)
    {
      for (Index k = i; k < curves.number_of_pairs(); ++k)
      {
        BOOST_TEST(search.find(2 * k).across == shortest_across(curves, 2 * k), boost::test_tools::tolerance(1e-12));
      }
      const Crossing_loop loop = search.find(2 * i);
      BOOST_TEST(loop.across <= loop.length);
      curves.add(2 * i + 1, loop.steps);
      search.note_added(2 * i + 1);
      BOOST_TEST(crosses_partner_once(curves, 2 * i + 1));
      BOOST_TEST(runs_from_right(curves, 2 * i + 1));
    }
    for (Index n : count_crossings(curves)) { BOOST_TEST(n == 1); }
  }
}

// Every gap is a node, and is reached by its shortest way, also when curves were added since gaps were first seen.
BOOST_AUTO_TEST_CASE(cells_that_grow_come_to_every_gap_by_its_shortest_way)
{
  for (const Triangle_surface& s : surfaces())
  {
    Normal_curves curves = meridians(s);
    Gap_graph graph(curves);
    for (Index i = 0; i < curves.number_of_pairs(); ++i)
    {
      const auto side = i % 2 == 0 ? Gap_graph::LEFT : Gap_graph::RIGHT;
      graph.clear();
      for (Index x : curves.crossings(0)) { graph.start(side, graph.node(gap_beside(curves, x, true))); }
      double farthest = std::numeric_limits<double>::infinity();
      graph.grow(farthest, [](Index, double) { BOOST_ERROR("one cell meets no other"); });
      const auto distances = distances_from(curves, 0);
      BOOST_TEST(distances.size() > static_cast<std::size_t>(s.number_of_halfedges()) / 2);
      for (const auto& [gap, distance] : distances)
      {
        BOOST_TEST(graph.distance_from(side, graph.node(gap)) == distance, boost::test_tools::tolerance(1e-12));
      }
      Crossing_loop_search search(curves);
      curves.add(2 * i + 1, search.find(2 * i).steps);
      graph.forget_around(2 * i + 1);
    }
  }
}

// What is noted to be tight is so until something changes on the edges that it crosses, or its partner does.
BOOST_AUTO_TEST_CASE(a_tight_curve_is_known_until_something_changes_beside_it)
{
  const Triangle_surface s = sample::torus(16, 8);
  const Normal_curves given = meridians(s);
  std::vector<Crossing> steps;
  for (Index x : given.crossings(0)) { steps.push_back(given[x]); }
  Normal_curves curves(s, 4);
  curves.add(0, steps);
  BOOST_TEST(!curves.tight_length(0).has_value());
  curves.set_tight(0, 7);
  BOOST_TEST(curves.tight_length(0).value_or(0) == 7);
  {
    Normal_curves::Trial trial(curves);
    curves.add(2, steps); // side by side
    BOOST_TEST(!curves.tight_length(0).has_value());
  }
  BOOST_TEST(!curves.tight_length(0).has_value()); // taken back is a change as well
  curves.set_tight(0, 8);
  BOOST_TEST(curves.tight_length(0).value_or(0) == 8);
  const Crossing_loop loop = Crossing_loop_search(curves).find(0);
  curves.add(1, loop.steps);
  curves.set_tight(0, 9);
  curves.remove(1);
  BOOST_TEST(!curves.tight_length(0).has_value());
}
