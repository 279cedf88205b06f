// The names that the paths of a shorter cut graph keep.
#include "support/pipeline.h"
#include "support/sample_surfaces.h"

#include <meridian/base/Verification.h>
#include <meridian/base/vectors.h>
#include <meridian/cut/Cut.h>
#include <meridian/cut/Cut_options.h>
#include <meridian/handles/internal/tree_cotree.h>
#include <meridian/handles/preference.h>
#include <meridian/proof/verify_cut.h>
#include <meridian/result/recount.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/fill_boundary.h>
#include <meridian/surface/open_along.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace data = boost::unit_test::data;
using namespace meridian;

namespace {

Cut_options whole_graph(Cut_options o = Cut_options())
{
  o.tightening = Tightening::GRAPH;
  return o;
}

// The class in homology of a curve on a refinement of a surface, with the holes of that filled.
std::vector<int> class_of(const internal::Tree_cotree& basis, const Triangle_surface& filled, const Refined_surface& s,
                          const std::vector<Index>& curve)
{
  std::vector<Index> walk; // along vertices of the root: the first that each lies on an edge of
  for (Index v : curve) { walk.push_back(s.origin(v).index[0]); }
  std::vector<std::pair<Index, int>> flow;
  for (std::size_t i = 0; i < walk.size(); ++i)
  {
    const Index from = walk[i], to = walk[(i + 1) % walk.size()];
    if (from == to) { continue; }
    const Index e = filled.edge(filled.find_halfedge(from, to));
    flow.emplace_back(e, filled.source(e) == from ? 1 : -1);
  }
  return basis.integrate(flow);
}

// Theorem: the curves of a cut are its seam, each edge once; meridians are disjoint circles, other curves are not.
void check_curves(const Cut& cut)
{
  std::set<std::pair<Index, Index>> edges;
  std::set<Index> on_meridians;
  for (const Named_curve& c : cut.curves)
  {
    const bool is_meridian = c.kind == Curve_kind::MERIDIAN;
    BOOST_TEST(c.is_closed == is_meridian);
    for (std::size_t i = 0; i + (c.is_closed ? 0 : 1) < c.vertices.size(); ++i)
    {
      const auto edge = std::minmax(c.vertices[i], c.vertices[(i + 1) % c.vertices.size()]);
      BOOST_TEST(edges.insert(edge).second);
      const Index h = cut.surface.find_halfedge(c.vertices[i], c.vertices[(i + 1) % c.vertices.size()]);
      BOOST_REQUIRE(h >= 0);
      BOOST_TEST(cut.surface.seam[h] == 1);
      if (is_meridian) { BOOST_TEST(on_meridians.insert(c.vertices[i]).second); }
    }
  }
  BOOST_TEST(edges.size() == cut.opened.seams.size());
}

// Cut along its meridians alone, a surface is still connected and its genus is less by their number.
void check_meridians_alone(const Cut& cut)
{
  Refined_surface s = cut.surface;
  std::fill(s.seam.begin(), s.seam.end(), char(0));
  const auto meridians = curves_of(cut, Curve_kind::MERIDIAN);
  for (const Named_curve& c : meridians)
    for (std::size_t i = 0; i < c.vertices.size(); ++i)
    {
      const Index h = s.find_halfedge(c.vertices[i], c.vertices[(i + 1) % c.vertices.size()]);
      s.seam[h] = s.seam[s.opposite[h]] = 1;
    }
  const Triangle_surface o = surface_of(s, open_along(s));
  std::vector<Index> reached{0};
  std::vector<char> is_reached(o.number_of_faces(), 0);
  is_reached[0] = 1;
  for (std::size_t i = 0; i < reached.size(); ++i)
    for (Index h = 3 * reached[i]; h < 3 * reached[i] + 3; ++h)
    {
      if (o.opposite[h] < 0 || is_reached[o.face(o.opposite[h])]) { continue; }
      is_reached[o.face(o.opposite[h])] = 1;
      reached.push_back(o.face(o.opposite[h]));
    }
  BOOST_TEST(static_cast<Index>(reached.size()) == o.number_of_faces());
  const int loops = cut.boundary_loops + 2 * static_cast<int>(meridians.size());
  BOOST_TEST(static_cast<int>(boundary_loops(o).size()) == loops);
  BOOST_TEST(sample::euler_characteristic(o) == 2 - 2 * cut.genus - cut.boundary_loops);
}

// All of this, and that each meridian is homologous to the one that only was tightened. Returns how many there are.
std::size_t check_names(const Triangle_surface& s, const Cut_options& options = Cut_options())
{
  const Cut whole = pipeline::cut(s, whole_graph(options)), curves = pipeline::cut(s, pipeline::tight_curves(options));
  for (const auto& failure : verify_cut(s, whole).failures) { BOOST_ERROR(failure); }
  check_curves(whole);
  check_meridians_alone(whole);
  const Triangle_surface filled = fill_boundary(s).surface;
  const internal::Tree_cotree basis(filled);
  std::map<Index, std::vector<int>> classes;
  for (const Named_curve& c : curves_of(curves, Curve_kind::MERIDIAN))
  {
    classes[c.saddle] = class_of(basis, filled, curves.surface, c.vertices);
  }
  const auto meridians = curves_of(whole, Curve_kind::MERIDIAN);
  for (const Named_curve& c : meridians)
  {
    BOOST_TEST((class_of(basis, filled, whole.surface, c.vertices) == classes.at(c.saddle)));
  }
  const bool has_all = static_cast<int>(meridians.size()) == whole.genus;
  BOOST_TEST(curves_of(whole, has_all ? Curve_kind::PATH : Curve_kind::LINK).empty());
  return meridians.size();
}

} // namespace

// A tight network on a torus has two vertices and three paths, and two of these make a shortest loop.
BOOST_DATA_TEST_CASE(the_meridian_of_a_torus_keeps_its_name, data::xrange(4), seed)
{
  const auto torus = sample::noisy(sample::torus(40, 16), 0.03, seed);
  BOOST_TEST(check_names(torus) == 1u);
  const Cut cut = pipeline::cut(torus);
  BOOST_TEST((cut.tightening == Tightening::GRAPH));
  BOOST_TEST(curves_of(cut, Curve_kind::LINK).size() == 1u);
  // once round the tube, and never along it
  const auto meridian = curves_of(cut, Curve_kind::MERIDIAN).front().vertices;
  double along = 0, around = 0;
  const auto turn = [](double from, double to) { return std::remainder(to - from, 2 * std::acos(-1.)); };
  for (std::size_t i = 0; i < meridian.size(); ++i)
  {
    const Point &p = cut.surface.points[meridian[i]], &q = cut.surface.points[meridian[(i + 1) % meridian.size()]];
    along += turn(std::atan2(p[1], p[0]), std::atan2(q[1], q[0]));
    around += turn(std::atan2(p[2], std::hypot(p[0], p[1]) - 3), std::atan2(q[2], std::hypot(q[0], q[1]) - 3));
  }
  BOOST_TEST(std::abs(along) < 1e-9);
  BOOST_TEST(std::abs(around) == 2 * std::acos(-1.), boost::test_tools::tolerance(1e-9));
}

// Any surface, any field, on edges and off them: what is named is what it was.
BOOST_DATA_TEST_CASE(names_are_kept_by_what_is_homologous, data::xrange(1, 5) * data::xrange(4), genus, which)
{
  auto s = sample::noisy(sample::plate(genus, 5), 0.1, which);
  if (which % 2 == 1) { s = sample::punctured(s, {30, s.number_of_vertices() / 2}); }
  Cut_options o;
  o.on_edges = which == 2;
  if (which == 3) { pipeline::contours(o).preference = preference::short_length; }
  const std::size_t kept = check_names(s, o);
  if (which == 0) { BOOST_TEST(kept > 0u); }
}

BOOST_AUTO_TEST_CASE(all_paths_between_boundaries_are_links)
{
  const auto s = sample::punctured(sample::sphere(4), {20, 300, 600, 900});
  const Cut cut = pipeline::cut(s);
  BOOST_TEST((cut.tightening == Tightening::GRAPH));
  check_curves(cut);
  BOOST_TEST(curves_of(cut, Curve_kind::LINK).size() >= 3u);
  BOOST_TEST(curves_of(cut, Curve_kind::PATH).empty());
}

// What no meridian was asked of has none.
BOOST_AUTO_TEST_CASE(paths_of_edge_cuts_have_no_other_name)
{
  Cut_options o;
  o.method = By_tree_cotree();
  const Cut cut = pipeline::cut(sample::torus(30, 12), whole_graph(o));
  check_curves(cut);
  BOOST_TEST(curves_of(cut, Curve_kind::PATH).size() == cut.curves.size());
}

// The whole graph is tightened unless it would move away from what was chosen.
BOOST_AUTO_TEST_CASE(what_is_tightened_follows_the_other_choices)
{
  BOOST_TEST((tightening_of(Cut_options()) == Tightening::GRAPH));
  std::vector<Cut_options> others(6);
  pipeline::contours(others[0]).preference = preference::short_length;
  pipeline::contours(others[1]).levels = Levels::TIGHT;
  others[2].links.bifurcations = true;
  others[3].links.source = 7;
  others[4].link_domain = Link_domain::PLANE;
  others[5].on_edges = others[5].refine_where_needed = true;
  for (const Cut_method& method : all<Cut_method>())
  {
    if (std::holds_alternative<By_contours>(method)) { continue; }
    others.emplace_back();
    others.back().method = method;
  }
  for (Cut_options o : others)
  {
    BOOST_TEST((tightening_of(o) == Tightening::CURVES));
    for (const Tightening t : all<Tightening>())
    {
      o.tightening = t;
      BOOST_TEST((tightening_of(o) == t));
    }
  }
  const auto s = sample::torus(20, 10);
  BOOST_TEST((pipeline::cut(s, others[0]).tightening == Tightening::CURVES));
  BOOST_TEST((pipeline::unwrap(s).cut.tightening == Tightening::CURVES));
}
