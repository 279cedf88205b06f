// Methods that the library does not have: what it takes to add one.
#include "support/pipeline.h"
#include "support/sample_surfaces.h"

#include <meridian/base/Union_find.h>
#include <meridian/base/Verification.h>
#include <meridian/base/names.h>
#include <meridian/base/vectors.h>
#include <meridian/cut/Cut.h>
#include <meridian/cut/Cut_job.h>
#include <meridian/cut/Cut_method.h>
#include <meridian/cut/Cut_options.h>
#include <meridian/proof/verify_cut.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/seam_paths.h>
#include <meridian/surface/seams.h>

#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <numeric>
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
