// Methods that the library does not have: what it takes to add one.
#include "support/pipeline.h"
#include "support/sample_surfaces.h"

#include <meridian/base/Union_find.h>
#include <meridian/base/Verification.h>
#include <meridian/base/exceptions.h>
#include <meridian/base/names.h>
#include <meridian/base/vectors.h>
#include <meridian/cut/Cut.h>
#include <meridian/cut/Cut_job.h>
#include <meridian/cut/Cut_method.h>
#include <meridian/cut/Cut_options.h>
#include <meridian/cut/cut_traits.h>
#include <meridian/cut/edge_cuts.h>
#include <meridian/proof/verify_cut.h>
#include <meridian/result/recount.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/seam_paths.h>
#include <meridian/surface/seams.h>

#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace meridian;
namespace data = boost::unit_test::data;

namespace {

// Cuts all edges that a spanning tree of the faces does not cross; the tree is drawn by lot.
struct By_lot
{
  static constexpr Choice_name names{"lot", "edges that a random tree of faces does not cross"};
  static constexpr bool cuts_edges = true, moves_onto_edges = false;
  unsigned seed = 1;

  void cut_handles(Cut_job& job) const
  {
    const Triangle_surface& s = job.root;
    std::vector<Index> edges, cut;
    for (Index h = 0; h < s.number_of_halfedges(); ++h)
    {
      if (s.opposite[h] > h) { edges.push_back(h); }
    }
    std::shuffle(edges.begin(), edges.end(), std::mt19937(seed));
    Union_find pieces(s.number_of_faces());
    for (Index h : edges)
    {
      if (!pieces.unite(s.face(h), s.face(s.opposite[h]))) { cut.push_back(h); }
    }
    flag_seam(job.cut.surface, cut);
    add_curves(job.cut, Curve_kind::PATH, seam_paths(job.cut.surface));
  }
};

// Cuts loops of edges that somebody drew, and leaves it to the links to join them.
struct By_drawn_loops
{
  static constexpr Choice_name names{"drawn", "loops of edges that are given"};
  static constexpr bool cuts_edges = false, moves_onto_edges = true;
  std::vector<std::vector<Index>> loops; // halfedges

  void cut_handles(Cut_job& job) const
  {
    job.run(Stage::MERIDIANS, [&] {
      for (const auto& loop : loops)
      {
        std::vector<Index> vertices;
        for (Index h : loop) { vertices.push_back(job.root.source(h)); }
        flag_seam(job.cut.surface, loop);
        add_curves(job.cut, Curve_kind::MERIDIAN, {vertices});
      }
    });
  }
};

// Does not keep its contract.
struct By_nothing
{
  static constexpr Choice_name names{"nothing", "nothing at all"};
  static constexpr bool cuts_edges = true, moves_onto_edges = false;
  void cut_handles(Cut_job&) const {}
};

// The loop of edges from a vertex straight on, through vertices of degree six, until it is back.
std::vector<Index> straight_loop(const Triangle_surface& s, Index h)
{
  std::vector<Index> loop;
  do {
    loop.push_back(h);
    for (int i = 0; i < 3; ++i) { h = s.next(i == 0 ? h : s.opposite[h]); }
  } while (h != loop.front());
  return loop;
}

Cut_options with(Cut_method method)
{
  Cut_options o;
  o.method = std::move(method);
  return o;
}

} // namespace

BOOST_DATA_TEST_CASE(a_method_of_ones_own_cuts_edges_into_a_disc, data::xrange(4) * data::xrange(number_of<Tightening>),
                     genus, tightening)
{
  for (const auto& s : {sample::plate(genus, 2), sample::punctured(sample::plate(genus, 3), {30})})
  {
    Cut_options o = with(By_own_method(By_lot{7}));
    o.tightening = all<Tightening>()[tightening];
    const Cut cut = pipeline::cut(s, o);
    const Verification v = verify_cut(s, cut);
    for (const auto& failure : v.failures) { BOOST_ERROR(failure); }
    if (o.tightening != Tightening::GRAPH) { BOOST_TEST(cut.surface.origins.empty()); }
    else if (genus > 0) { BOOST_TEST(cut.length < cut.length_found); }
  }
}

BOOST_AUTO_TEST_CASE(knobs_of_ones_own_method_are_heard)
{
  const auto s = sample::plate(2, 3);
  const auto seams = [&](unsigned seed) { return pipeline::cut(s, with(By_own_method(By_lot{seed}))).opened.seams; };
  BOOST_TEST((seams(1) == seams(1)));
  BOOST_TEST((seams(1) != seams(2)));
}

// Known answer: a torus that is cut along one loop is joined by one link, and is a disc.
BOOST_DATA_TEST_CASE(links_join_the_loops_of_ones_own_method, data::xrange(2), on_edges)
{
  const auto s = sample::torus(20, 12);
  for (Index h = 0; h < 6; ++h)
  {
    Cut_options o = with(By_own_method(By_drawn_loops{{straight_loop(s, h)}}));
    o.on_edges = on_edges == 1;
    const Cut cut = pipeline::cut(s, o);
    const Verification v = verify_cut(s, cut);
    for (const auto& failure : v.failures) { BOOST_ERROR(failure); }
    BOOST_TEST(curves_of(cut, Curve_kind::MERIDIAN).size() == 1u);
    BOOST_TEST(curves_of(cut, Curve_kind::LINK).size() == 1u);
    BOOST_TEST((cut.seconds.front().first == Stage::MERIDIANS));
  }
}

// A method that does not keep the contract is found out by the recount.
BOOST_AUTO_TEST_CASE(a_method_that_cuts_too_little_is_not_verified)
{
  const auto s = sample::torus(12, 8);
  const Cut_options o = with(By_own_method(By_nothing{}));
  BOOST_TEST(name_of(o.method) == "nothing");
  BOOST_TEST(!verify_cut(s, pipeline::cut(s, o)).failures.empty());
}

// A method of one's own has no name on the command line, and choices are not carried to it.
BOOST_AUTO_TEST_CASE(ones_own_method_is_none_of_the_listed)
{
  BOOST_TEST(all<Cut_method>().size() == std::variant_size_v<Cut_method> - 1);
  BOOST_TEST(!from_name<Cut_method>("lot").has_value());
  const Cut_options o = with_method(with(By_tree_cotree{3}), By_own_method(By_lot()));
  BOOST_TEST(name_of(o.method) == "lot");
  BOOST_TEST(cuts_edges(o.method));
}

namespace {

// The weakest model of CutTraits: nothing can be done with it but copy it and call its functions.
class Traits_archetype
{
public:
  explicit Traits_archetype(int& calls) : m_calls(calls) {}
  Traits_archetype(const Traits_archetype&) = default;
  Traits_archetype& operator=(const Traits_archetype&) = delete;
  double preference(const Loop_candidate& loop) const { return ++m_calls, -loop.length; }
  double edge_length(const Triangle_surface& s, Index h) const { return ++m_calls, s.length(h); }
  double crossing(double low, double high, double level) const { return ++m_calls, (level - low) / (high - low); }

private:
  int& m_calls;
};

double length_by(const Edge_metric& metric, const Triangle_surface& s, const std::vector<Index>& edges)
{
  double sum = 0;
  for (Index h : edges) { sum += metric(s, h); }
  return sum;
}

} // namespace

// Theorem: ways along edges are shortest by the metric that is given; its unit does not matter.
BOOST_DATA_TEST_CASE(edges_are_measured_by_a_metric_of_ones_own, data::xrange(1, 4), genus)
{
  const auto s = sample::noisy(sample::plate(genus, 3), 0.1, 3);
  const Edge_metric top = [](const Triangle_surface& t, Index h) {
    const double z = (t.points[t.source(h)][2] + t.points[t.target(h)][2]) / 2;
    return t.length(h) * (z > 0 ? 20 : 1);
  };
  const Edge_metric scaled = [&](const Triangle_surface& t, Index h) { return 4 * top(t, h); };
  const auto own = cut_by_tree_cotree(s, 5, top), plain = cut_by_tree_cotree(s, 5);
  BOOST_TEST(length_by(top, s, own) < length_by(top, s, plain));
  BOOST_TEST((cut_by_tree_cotree(s, 5, scaled) == own));
  By_tree_cotree method{5};
  method.metric = top;
  const Cut cut = pipeline::cut(s, with(method));
  BOOST_TEST(verify_cut(s, cut).failures.empty());
  BOOST_TEST(cut.opened.seams.size() == own.size());
  for (const double wrong : {-1., std::nan(""), std::numeric_limits<double>::infinity()})
  {
    method.metric = [wrong](const Triangle_surface&, Index) { return wrong; };
    BOOST_CHECK_THROW(pipeline::cut(s, with(method)), Invalid_input_error);
  }
}

// Theorem (Erickson, Whittlesey 2005): beside the tree of shortest ways, a cut has the edges whose loops are shortest
// together: those that a spanning tree of faces over the longest leaves. Recounted by Bellman and Ford, and Kruskal.
BOOST_DATA_TEST_CASE(loops_at_a_base_are_shortest_by_the_metric, data::xrange(8), seed)
{
  const auto s = sample::plate(2, 2);
  const Edge_metric metric = [&](const Triangle_surface& t, Index h) {
    std::mt19937 random(static_cast<unsigned>(1000 * seed + t.edge(h)));
    return 1 + random() % 1000003 / 10000.;
  };
  std::vector<double> distance(s.number_of_vertices(), std::numeric_limits<double>::infinity());
  std::vector<Index> by(s.number_of_vertices(), -1);
  distance[3] = 0;
  for (Index round = 0; round < s.number_of_vertices(); ++round)
    for (Index h = 0; h < s.number_of_halfedges(); ++h)
    {
      const double d = distance[s.source(h)] + metric(s, h);
      if (!(d < distance[s.target(h)])) { continue; }
      distance[s.target(h)] = d;
      by[s.target(h)] = s.edge(h);
    }
  const auto loop = [&](Index h) { return distance[s.source(h)] + distance[s.target(h)] + metric(s, h); };
  std::vector<Index> closing;
  for (Index h = 0; h < s.number_of_halfedges(); ++h)
  {
    if (s.edge(h) == h && std::find(by.begin(), by.end(), h) == by.end()) { closing.push_back(h); }
  }
  std::sort(closing.begin(), closing.end(), [&](Index a, Index b) { return loop(a) > loop(b); });
  Union_find pieces(s.number_of_faces());
  double shortest = 0;
  for (Index h : closing)
  {
    if (!pieces.unite(s.face(h), s.face(s.opposite[h]))) { shortest += loop(h); }
  }
  double found = 0;
  for (Index h : cut_by_tree_cotree(s, 3, metric))
  {
    if (std::find(by.begin(), by.end(), h) == by.end()) { found += loop(h); }
  }
  BOOST_TEST(found == shortest, boost::test_tools::tolerance(1e-12));
}

// Level lines cross edges where one wants, and stay what they are by topology wherever that is.
BOOST_DATA_TEST_CASE(crossings_are_placed_where_one_wants, data::make({0.25, 0.5, 0.75, -3., std::nan("")}), place)
{
  const auto s = sample::torus(24, 12);
  By_contours method;
  method.placement = [place](double low, double high, double level) {
    BOOST_REQUIRE((low < high && low < level && level < high));
    return place;
  };
  Cut_options o = with(method);
  o.tightening = Tightening::NONE;
  const Cut cut = pipeline::cut(s, o);
  BOOST_TEST(verify_cut(s, cut).failures.empty());
  const double wanted = place > 0 ? place : 0.5;
  int on_edges = 0;
  const Named_curve meridian = curves_of(cut, Curve_kind::MERIDIAN).front();
  for (Index v : meridian.vertices)
  {
    const Origin at = cut.surface.origin(v);
    if (at.kind != Origin::EDGE) { continue; }
    ++on_edges;
    BOOST_TEST(std::min(std::abs(at.weight[0] - wanted), std::abs(1 - at.weight[0] - wanted)) < 1e-12);
  }
  BOOST_TEST(on_edges > 0);
}

BOOST_AUTO_TEST_CASE(traits_are_asked_by_the_methods_that_they_concern)
{
  const auto s = sample::torus(16, 8);
  for (const Cut_method& method : all<Cut_method>())
  {
    int calls = 0;
    const Cut_options o = with_traits(with(method), Traits_archetype(calls));
    const Cut cut = pipeline::cut(s, o), by_default = pipeline::cut(s, with_traits(with(method), Default_cut_traits()));
    BOOST_TEST(verify_cut(s, cut).failures.empty());
    const bool is_asked =
      !std::holds_alternative<By_flow_lines>(method) && !std::holds_alternative<By_removing_faces>(method);
    BOOST_TEST((calls > 0) == is_asked);
    BOOST_TEST((by_default.opened.seams == pipeline::cut(s, with(method)).opened.seams)); // the default changes nothing
  }
}
