// Surfaces divided into charts.
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

#include "support/pipeline.h"
#include "support/sample_surfaces.h"

#include <meridian/base/Progress_observer.h>
#include <meridian/base/exceptions.h>
#include <meridian/base/vectors.h>
#include <meridian/cut/Cut.h>
#include <meridian/map/planar_map.h>
#include <meridian/proof/verify_unwrapping.h>
#include <meridian/result/assemble_result.h>
#include <meridian/result/recount.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/measures.h>
#include <meridian/surface/pieces.h>
#include <meridian/unwrap/Unwrapping.h>
#include <meridian/unwrap/pack_unwrappings.h>

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
  BOOST_TEST(recount.failures.size() == 0u, recount.failures.front());
  BOOST_TEST_REQUIRE(recount.components.size() == 1u);
  BOOST_TEST(static_cast<std::size_t>(recount.components[0].discs) == u.charts);
  BOOST_TEST((number_pieces(u.disc) == u.chart_of));
  BOOST_TEST(static_cast<std::size_t>(sample::euler_characteristic(u.disc)) == u.charts);
  BOOST_TEST(u.map.flipped.empty());
  BOOST_TEST(u.map.is_one_to_one);

  std::vector<Unwrapping> all{u};
  const double stretch = u.map.distortion.stretch_l2, filled = pack_unwrappings(all, {1.});
  BOOST_TEST(all[0].map.distortion.stretch_l2 == stretch, boost::test_tools::tolerance(1e-9));
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
  BOOST_TEST(layout.failures.size() == 0u, layout.failures.front());
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
