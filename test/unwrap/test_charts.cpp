// Surfaces divided into charts.
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

#include "support/pipeline.h"
#include "support/sample_surfaces.h"

#include <meridian/base/Progress_observer.h>
#include <meridian/base/exceptions.h>
#include <meridian/base/vectors.h>
#include <meridian/cut/Cut.h>
#include <meridian/map/pack_charts.h>
#include <meridian/map/planar_map.h>
#include <meridian/proof/verify_packing.h>
#include <meridian/proof/verify_unwrapping.h>
#include <meridian/result/assemble_result.h>
#include <meridian/result/recount.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/measures.h>
#include <meridian/surface/pieces.h>
#include <meridian/unwrap/Unwrapping.h>
#include <meridian/unwrap/pack_unwrappings.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

namespace data = boost::unit_test::data;
using namespace meridian;

namespace {

// A frame of bars along the edges of so many cubes in a row: many handles, and flat everywhere else.
Triangle_surface lattice(int cubes)
{
  constexpr int room = 4;
  return sample::skin({room * cubes + 1, room + 1, room + 1},
                      [](int x, int y, int z) { return (x % room == 0) + (y % room == 0) + (z % room == 0) >= 2; });
}

Unwrapping divided(const Triangle_surface& s, int charts, bool on_edges = false)
{
  Unwrap_options options;
  options.charts = charts;
  options.cut.on_edges = on_edges;
  return pipeline::unwrap(s, options);
}

// All that is claimed of charts, recounted.
void check(const Triangle_surface& s, const Unwrapping& u)
{
  const Verification recount = verify_charts(s, u.cut);
  BOOST_TEST(recount.failures.size() == 0u, pipeline::first_failure(recount));
  BOOST_TEST_REQUIRE(recount.components.size() == 1u);
  BOOST_TEST(static_cast<std::size_t>(recount.components[0].discs) == u.charts);
  BOOST_TEST((number_pieces(u.disc) == u.chart_of));
  BOOST_TEST(static_cast<std::size_t>(sample::euler_characteristic(u.disc)) == u.charts);
  BOOST_TEST(u.map.flipped.empty());
  BOOST_TEST(u.map.is_one_to_one);

  std::vector<Unwrapping> all{u}, as_it_is{u};
  Pack_options touching;
  touching.padding = 0;
  pack_unwrappings(as_it_is, {1.}, touching);
  const double stretch = u.map.distortion.stretch_l2, filled = pack_unwrappings(all, {1.});
  BOOST_TEST(as_it_is[0].map.distortion.stretch_l2 == stretch, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(all[0].map.distortion.stretch_l2 < 1.02 * stretch); // with its slits opened
  const auto near = [&](const Unwrapping& packed) {
    return find_near_themselves(u.disc.triangles, packed.map.at, 2. / 2048).size();
  };
  BOOST_TEST(4 * near(all[0]) <= near(as_it_is[0])); // large faces give way less
  BOOST_TEST(filled > 0.1);
  BOOST_TEST(filled == area_of(u.disc.triangles, all[0].map.at), boost::test_tools::tolerance(1e-9));
  const Polygon_soup soup = internal::soup_of(s);
  const auto assembled = assemble_result(soup, internal::examination_of(s), std::vector<Cut>{u.cut});
  Result_mesh mesh = assembled.mesh;
  std::vector<Plane_point> texture(mesh.points.size());
  for (std::size_t v = 0; v < texture.size(); ++v) { texture[assembled.place[0][v]] = all[0].map.at[v]; }
  Triangle_surface opened;
  opened.points = mesh.points;
  opened.triangles = mesh.faces;
  connect(opened);
  mesh.chart_of = number_pieces(opened);
  const Verification layout = verify_unwrapping(soup, mesh, texture, 2. / 2048);
  BOOST_TEST(layout.failures.size() == 0u, pipeline::first_failure(layout));
}

} // namespace

BOOST_DATA_TEST_CASE(a_surface_becomes_as_many_charts_as_are_asked_for,
                     data::make({2, 3, 7}) * data::make({false, true}), charts, on_edges)
{
  for (const Triangle_surface& s :
       {sample::torus(24, 12), sample::sphere(3), sample::punctured(sample::plate(2, 3), {30})})
  {
    const Unwrapping u = divided(s, charts, on_edges);
    BOOST_TEST(u.charts == static_cast<std::size_t>(charts));
    BOOST_TEST(curves_of(u.cut, Curve_kind::ARC).size() == static_cast<std::size_t>(charts) - 1);
    BOOST_TEST((!on_edges || u.cut.surface.number_of_vertices() == s.number_of_vertices()));
    check(s, u);
  }
}

BOOST_AUTO_TEST_CASE(charts_are_divided_until_the_stretch_is_low_enough)
{
  Unwrap_options options;
  options.charts = 0;
  for (const Triangle_surface& s : {lattice(4), sample::torus(40, 20), sample::dumbbell(6, 32)})
  {
    std::size_t last = 0;
    for (const double wanted : {1.2, 1.02, 1.01})
    {
      options.max_stretch = wanted;
      const Unwrapping u = pipeline::unwrap(s, options);
      BOOST_TEST(u.map.distortion.stretch_l2 <= wanted);
      BOOST_TEST(u.charts + u.extended >= last);
      last = u.charts + u.extended;
      check(s, u);
    }
  }
}

// What unfolds as it is stays one chart.
BOOST_AUTO_TEST_CASE(a_surface_that_needs_no_charts_is_one)
{
  const Unwrapping flat = divided(sample::sheet(20, 5, [](double x, double y) { return Point{4 * x, y, 0}; }), 0);
  BOOST_TEST(flat.charts == 1u);
  BOOST_TEST(flat.cut.opened.seams.empty());
  BOOST_TEST(flat.map.distortion.stretch_l2 < 1.0001);
  // a lattice with room for itself in one chart, at twice the price
  const Unwrapping lax = divided(lattice(1), 1), strict = divided(lattice(6), 0);
  BOOST_TEST(lax.charts == 1u);
  BOOST_TEST(lax.chart_of.empty());
  BOOST_TEST(strict.charts > 1u);
}

BOOST_AUTO_TEST_CASE(no_more_charts_than_faces)
{
  const Triangle_surface s = sample::connected(
    {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}, {}, {}});
  const Unwrapping u = divided(s, 100, true);
  BOOST_TEST(u.charts == 4u);
  check(s, u);
}

// So rough that it overlaps itself where it is unfolded, in faces side by side, which no arc parts.
BOOST_AUTO_TEST_CASE(an_overlap_that_cannot_be_parted_is_no_hindrance)
{
  const Triangle_surface s = sample::noisy(sample::sphere(3), 0.35, 7);
  Unwrap_options options;
  options.charts = 4;
  options.max_stretch = 100; // so that the cut stays as it is
  const Unwrapping u = pipeline::unwrap(s, options);
  BOOST_TEST(u.charts == 4u);
  check(s, u);
}

// The same charts whatever the scale, the same numbers of them however faces are numbered.
BOOST_AUTO_TEST_CASE(charts_do_not_depend_on_scale)
{
  const Triangle_surface s = lattice(3);
  const Unwrapping a = divided(s, 5), b = divided(sample::scaled(s, 1024), 5);
  BOOST_TEST(b.cut.length == 1024 * a.cut.length, boost::test_tools::tolerance(1e-9));
  BOOST_TEST((a.chart_of == b.chart_of));
  check(sample::renumbered(s, 4), divided(sample::renumbered(s, 4), 5));
}

namespace {

// Ends a run when so many parts of it were told of.
struct Impatient : Progress_observer
{
  int left;
  double last = 0;
  bool grows = true;
  explicit Impatient(int told) : left(told) {}
  void stage_progressed(Stage stage, double done) override
  {
    if (stage != Stage::PARAMETERIZE) { return; }
    grows = grows && done >= last && done <= 1;
    last = done;
    --left;
  }
  bool go_further() override { return left > 0; }
};

} // namespace

BOOST_AUTO_TEST_CASE(dividing_can_be_stopped)
{
  Unwrap_options options;
  options.charts = 0;
  Impatient patient(1000000), impatient(5);
  options.cut.observer = &patient;
  pipeline::unwrap(lattice(3), options);
  BOOST_TEST(patient.grows);
  BOOST_TEST(patient.last == 1);
  BOOST_TEST(patient.left < 1000000 - 5);
  options.cut.observer = &impatient;
  BOOST_CHECK_THROW(pipeline::unwrap(lattice(3), options), Cancelled);
}

BOOST_AUTO_TEST_CASE(what_is_for_one_chart_is_refused)
{
  const Triangle_surface s = sample::torus(12, 6);
  Unwrap_options options;
  options.charts = 3;
  options.image_size = 33;
  BOOST_CHECK_THROW(pipeline::unwrap(s, options), Invalid_input_error);
  options.image_size = 0;
  options.family = 3;
  BOOST_CHECK_THROW(pipeline::unwrap(s, options), Invalid_input_error);
  options.family = 1;
  options.stretch_weight = 0.5;
  BOOST_CHECK_THROW(pipeline::unwrap(s, options), Invalid_input_error);
  options.stretch_weight = 0;
  options.charts = -1;
  BOOST_CHECK_THROW(pipeline::unwrap(s, options), Invalid_input_error);
}

namespace {

Unwrapping with_seams(const Triangle_surface& s, const std::vector<Index>& seams, bool on_edges = false, int charts = 1)
{
  Unwrap_options options;
  options.seams = seams;
  options.cut.on_edges = on_edges;
  options.charts = charts;
  return pipeline::unwrap(s, options);
}

// The edges between faces of which one is of the kind and one is not.
template <class Kind> std::vector<Index> edges_between(const Triangle_surface& s, const Kind& is_inside)
{
  std::vector<Index> edges;
  for (Index h = 0; h < s.number_of_halfedges(); ++h)
  {
    if (s.opposite[h] >= 0 && is_inside(s.face(h)) && !is_inside(s.face(s.opposite[h]))) { edges.push_back(h); }
  }
  return edges;
}

Point centre(const Triangle_surface& s, Index f)
{
  const auto& t = s.triangles[f];
  return (1. / 3) * (s.points[t[0]] + s.points[t[1]] + s.points[t[2]]);
}

// How much of the length of edges of the root is seam, on the refined surface; and how much of other edges is.
std::array<double, 2> seams_on_edges(const Triangle_surface& s, const Cut& cut, const std::vector<Index>& edges)
{
  std::set<std::array<Index, 2>> given;
  for (Index h : edges) { given.insert({std::min(s.source(h), s.target(h)), std::max(s.source(h), s.target(h))}); }
  std::array<double, 2> sum{0, 0};
  for (const auto& seam : cut.opened.seams)
  {
    const Index h = seam[0];
    std::array<Index, 2> ends;
    std::array<double, 2> t;
    const bool is_on_edge = on_common_root_edge(cut.surface.origin(cut.surface.source(h)),
                                                cut.surface.origin(cut.surface.target(h)), ends, t);
    sum[is_on_edge && given.count(ends) > 0 ? 0 : 1] += cut.surface.length(h);
  }
  return sum;
}

double length_of(const Triangle_surface& s, const std::vector<Index>& edges)
{
  double sum = 0;
  for (Index h : edges) { sum += s.length(h); }
  return sum;
}

} // namespace

// Seams stay where they are, whatever is needed to complete them, and everything comes out as discs.
BOOST_DATA_TEST_CASE(seams_that_are_given_stay, data::make({false, true}), on_edges)
{
  const Triangle_surface torus = sample::torus(24, 12), sphere = sample::sphere(3), plate = sample::plate(3, 3),
                         open = sample::punctured(sample::plate(2, 3), {30});
  struct Case
  {
    const Triangle_surface* surface;
    std::vector<Index> seams;
    std::size_t charts;
    std::size_t handles; // that the seams leave
  };
  const auto right_of = [](const Triangle_surface& s, double x) {
    return edges_between(s, [&s, x](Index f) { return centre(s, f)[0] > x; });
  };
  const auto inside_of = [](const Triangle_surface& s, Index first) { // a star
    const std::set<Index> star{first, s.face(s.opposite[3 * first]), s.face(s.opposite[3 * first + 1])};
    return edges_between(s, [star](Index f) { return star.count(f) > 0; });
  };
  const std::vector<Case> cases{{&sphere, right_of(sphere, 0.1), 2, 0},
                                {&sphere, {5}, 1, 0},
                                {&sphere, {0, 40, 200}, 1, 0},
                                {&torus, right_of(torus, 0.01), 2, 0},
                                {&torus, {7}, 1, 1},
                                {&torus, inside_of(torus, 11), 2, 1},
                                {&plate, inside_of(plate, 20), 2, 3},
                                {&plate, {3, 100, 300, 301}, 1, 3},
                                {&open, inside_of(open, 200), 2, 2}};
  for (const Case& c : cases)
  {
    const Triangle_surface& s = *c.surface;
    const Unwrapping u = with_seams(s, c.seams, on_edges);
    const auto sum = seams_on_edges(s, u.cut, c.seams);
    BOOST_TEST_CONTEXT(&c - cases.data())
    {
      BOOST_TEST(sum[0] == length_of(s, c.seams), boost::test_tools::tolerance(1e-9));
      BOOST_TEST(u.charts == c.charts);
      BOOST_TEST((!on_edges || u.cut.surface.number_of_vertices() == s.number_of_vertices()));
      const auto meridians = curves_of(u.cut, Curve_kind::MERIDIAN), paths = curves_of(u.cut, Curve_kind::PATH);
      BOOST_TEST(meridians.size() == (on_edges ? 0 : c.handles));
      BOOST_TEST(paths.empty() == (!on_edges || c.handles == 0));
      BOOST_TEST(!curves_of(u.cut, Curve_kind::SEAM).empty());
      BOOST_TEST(u.extended == 0u);
      check(s, u);
    }
  }
}

BOOST_AUTO_TEST_CASE(seams_that_suffice_are_all_that_is_cut)
{
  const Triangle_surface sphere = sample::sphere(3);
  const auto equator = edges_between(sphere, [&](Index f) { return centre(sphere, f)[2] > 0; });
  const Unwrapping halves = with_seams(sphere, equator);
  BOOST_TEST(halves.cut.curves.size() == 1u); // one curve, that was given
  BOOST_TEST(seams_on_edges(sphere, halves.cut, equator)[1] == 0);
  BOOST_TEST(halves.cut.surface.number_of_vertices() == sphere.number_of_vertices());

  std::vector<Index> all; // each face a chart
  for (Index h = 0; h < sphere.number_of_halfedges(); ++h) { all.push_back(h); }
  const Unwrapping faces = with_seams(sphere, all);
  BOOST_TEST(faces.charts == static_cast<std::size_t>(sphere.number_of_faces()));
  BOOST_TEST(faces.map.distortion.stretch_l2 < 1 + 1e-6);
  check(sphere, faces);
}

BOOST_AUTO_TEST_CASE(charts_between_seams_are_divided_further_if_that_is_asked_for)
{
  const Triangle_surface s = sample::dumbbell(6, 32);
  const auto seams = edges_between(s, [&](Index f) { return centre(s, f)[0] > 0.1; });
  BOOST_TEST_REQUIRE(!seams.empty());
  const Unwrapping few = with_seams(s, seams), five = with_seams(s, seams, false, 5),
                   automatic = with_seams(s, seams, false, 0);
  BOOST_TEST(five.charts == 5u);
  BOOST_TEST(automatic.map.distortion.stretch_l2 <= default_max_stretch_of_charts);
  for (const Unwrapping* u : {&few, &five, &automatic})
  {
    BOOST_TEST(seams_on_edges(s, u->cut, seams)[0] == length_of(s, seams), boost::test_tools::tolerance(1e-9));
    check(s, *u);
  }
}

// A string of beads, closed: its six narrow places are creases, and shorter than the way around.
BOOST_AUTO_TEST_CASE(charts_end_at_sharp_edges_where_those_are_short)
{
  Triangle_surface beads = sample::torus(120, 16);
  for (Point& p : beads.points)
  {
    const double phi = std::atan2(p[1], p[0]), big = 3;
    const Point middle{big * std::cos(phi), big * std::sin(phi), 0};
    p = middle + (0.2 + std::abs(std::sin(3 * phi))) * (p - middle);
  }
  Unwrap_options options;
  options.charts = 0;
  const Unwrapping u = pipeline::unwrap(beads, options);
  BOOST_TEST(curves_of(u.cut, Curve_kind::SEAM).size() >= 6u);
  BOOST_TEST(u.charts >= 6u);
  check(beads, u);
  BOOST_TEST(curves_of(pipeline::unwrap(sample::torus(40, 20), options).cut, Curve_kind::SEAM).empty());
}

BOOST_AUTO_TEST_CASE(seams_that_cannot_be_are_refused)
{
  const Triangle_surface s = sample::punctured(sample::torus(24, 12), {30});
  const Index border = boundary_loops(s).front().front(), inside = s.number_of_halfedges() - 1;
  BOOST_TEST_REQUIRE(s.opposite[inside] >= 0);
  for (const Index wrong : {Index(-1), s.number_of_halfedges(), border})
  {
    BOOST_CHECK_THROW(with_seams(s, {inside, wrong}), Invalid_input_error);
  }
  Unwrap_options options;
  options.seams = {inside};
  options.cut.method = By_tree_cotree();
  BOOST_CHECK_THROW(pipeline::unwrap(s, options), Invalid_input_error);
  options.cut = {};
  options.cut.tightening = Tightening::GRAPH;
  BOOST_CHECK_THROW(pipeline::unwrap(s, options), Invalid_input_error);
  options.cut = {};
  options.image_size = 33;
  BOOST_CHECK_THROW(pipeline::unwrap(s, options), Invalid_input_error);
}
