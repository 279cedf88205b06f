// The surfaces of the paper's figures, and what it says of them.
#include "support/implicit_surfaces.h"
#include "support/pipeline.h"

#include <meridian/base/vectors.h>
#include <meridian/curves/contours.h>
#include <meridian/field/Ordered_surface.h>
#include <meridian/field/critical_points.h>
#include <meridian/handles/Generators.h>
#include <meridian/handles/find_meridians.h>
#include <meridian/proof/verify_generators.h>
#include <meridian/result/recount.h>
#include <meridian/surface/Triangle_surface.h>

using namespace meridian;

namespace {

Generators check(const Triangle_surface& s, int genus, int loops)
{
  BOOST_TEST(static_cast<int>(boundary_loops(s).size()) == loops);
  const Generators g = pipeline::classified(s);
  BOOST_TEST(g.genus == genus);
  const auto v = verify_generators(s, g);
  for (const auto& failure : v.failures) { BOOST_TEST_MESSAGE(failure); }
  BOOST_TEST(v.failures.size() == 0u);
  return g;
}

double shortest_pair(const Generators& g)
{
  double shortest = 1e300;
  for (const auto& pair : g.pairs) { shortest = std::min(shortest, pair.meridian.length + pair.longitude.length); }
  return shortest;
}

} // namespace

BOOST_AUTO_TEST_CASE(figures_8_to_10_the_bitorus_at_three_levels_of_detail)
{
  for (int cells : {20, 32, 48})
  {
    const Generators g = check(sample::bitorus(cells), 2, 0);
    for (const auto& pair : g.pairs)
    {
      BOOST_TEST(pair.meridian.length == 2 * sample::pi * 0.3, boost::test_tools::tolerance(0.06));  // around the tube
      BOOST_TEST(pair.longitude.length == 2 * sample::pi * 0.5, boost::test_tools::tolerance(0.06)); // the inner circle
      BOOST_TEST((pair.meridian.loop_class == Loop_class::HANDLE && pair.longitude.loop_class == Loop_class::TUNNEL));
    }
  }
}

BOOST_AUTO_TEST_CASE(figure_11_a_tiny_handle_is_found_however_the_surface_is_sampled)
{
  const Triangle_surface s = sample::bitorus_with_tiny_handle(72);
  double edge = 0;
  for (Index h = 0; h < s.number_of_halfedges(); ++h) { edge += s.length(h) / s.number_of_halfedges(); }
  for (const Triangle_surface& t : {s, sample::subdivided(s), sample::noisy(s, 0.1 * edge, 3), sample::renumbered(s, 3),
                                    sample::bitorus_with_tiny_handle(72, true)})
  {
    const Generators g = check(t, 3, 0);
    BOOST_TEST(shortest_pair(g) < 1.);
    BOOST_TEST(shortest_pair(g) > 0.5);
  }
}

BOOST_AUTO_TEST_CASE(figure_7_an_irregularly_sampled_surface)
{
  const Generators g = check(sample::irregular_torus(32), 1, 0);
  BOOST_TEST(g.pairs.front().meridian.length == 2 * sample::pi * 0.55, boost::test_tools::tolerance(0.06));
  BOOST_TEST(g.pairs.front().longitude.length == 2 * sample::pi * 0.95, boost::test_tools::tolerance(0.06));
}

BOOST_AUTO_TEST_CASE(figure_12_a_pot_with_a_handle_and_two_openings)
{
  const Generators open = check(sample::teapot(40), 1, 2), closed = check(sample::teapot(40, false), 1, 0);
  BOOST_TEST(open.counts.saddles == 2);
  BOOST_TEST(open.pairs.front().meridian.length == closed.pairs.front().meridian.length,
             boost::test_tools::tolerance(0.1));
  Generator_options options;
  options.is_open = true;
  BOOST_TEST(verify_generators(sample::teapot(40), pipeline::generators(sample::teapot(40), options)).failures.size()
             == 0u);
  // A field with many extrema on the boundary, as one without conditions there has: contours still cut the handle.
  const Triangle_surface s = sample::teapot(40);
  std::vector<double> height;
  for (const Point& p : s.points) { height.push_back(std::sin(5 * p[0]) + std::cos(7 * p[1]) + p[2]); }
  const Ordered_surface m = pipeline::order(s, height, false);
  const Critical_counts counts = count(m.critical);
  BOOST_TEST(counts.saddles == 2 + counts.minima + counts.maxima - 2); // 2g more than extrema, on the closed model
  Meridian_search search;
  search.loops = trace_saddle_loops(m);
  find_meridians(s, m, 1, preference::short_length, search);
  BOOST_TEST(search.choices.size() == 1u);
}

BOOST_AUTO_TEST_CASE(figures_13_to_15_three_rings)
{
  const Generators g = check(sample::three_rings(40), 3, 0);
  BOOST_TEST(g.counts.saddles == 6);
  for (const auto& pair : g.pairs)
  {
    BOOST_TEST(pair.meridian.length == 2 * sample::pi * 0.28, boost::test_tools::tolerance(0.1));
  }
}
