// Cuts that are extended, and maps that go on.
#include "support/pipeline.h"
#include "support/sample_surfaces.h"

#include <meridian/base/vectors.h>
#include <meridian/cut/Cut.h>
#include <meridian/map/distortion.h>
#include <meridian/map/is_one_to_one.h>
#include <meridian/map/parameterize_disc.h>
#include <meridian/proof/verify_cut.h>
#include <meridian/result/recount.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/open_along.h>
#include <meridian/unwrap/Unwrapping.h>
#include <meridian/unwrap/carry_map.h>
#include <meridian/unwrap/extend_cut.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace data = boost::unit_test::data;
using namespace meridian;

namespace {

Index original(const Cut& cut, Index v)
{
  const Index n = cut.surface.number_of_vertices();
  return v < n ? v : cut.opened.copy_of[v - n];
}

bool is_at_seam(const Cut& cut, Index v)
{
  bool is_at = cut.surface.is_boundary_vertex(v);
  cut.surface.for_each_outgoing(v, [&](Index h) { is_at = is_at || cut.surface.seam[h]; });
  return is_at;
}

// At most one vertex that only a face from `first` on parts from the seam.
std::vector<Index> beyond_new_faces(const Cut& cut, Index first)
{
  for (Index h = 3 * first; h < cut.surface.number_of_halfedges(); ++h)
  {
    const Index o = cut.surface.opposite[h];
    if (o >= 0 && !cut.surface.seam[h] && !is_at_seam(cut, cut.surface.apex(o))) { return {cut.surface.apex(o)}; }
  }
  return {};
}

} // namespace

// Theorem: the carried map is one-to-one; away from the new paths nothing moves, and on them hardly anything does.
BOOST_DATA_TEST_CASE(a_map_is_carried_over_to_an_extended_cut,
                     data::make({false, true}) * data::xrange(1, 4) * data::xrange(3), on_edges, paths, which)
{
  const auto s = which == 0   ? sample::noisy(sample::torus(40, 20), 0.03, 5)
                 : which == 1 ? sample::punctured(sample::noisy(sample::plate(2, 5), 0.05, 2), {40, 300})
                              : sample::thorny_torus();
  Cut before = pipeline::cut(s, pipeline::tight_curves());
  const Triangle_surface disc = surface_of(before.surface, before.opened);
  const Parameterization map = pipeline::map(disc);
  BOOST_REQUIRE(map.is_one_to_one);
  Cut after = before;
  std::vector<Index> parents;
  std::set<Index> on_paths;
  std::vector<Index> goals = find_stretched_vertices(disc, map, paths);
  for (std::size_t i = 0; i < goals.size(); ++i)
  {
    const Index v = goals[i];
    if (on_paths.count(v) > 0) { continue; }
    const auto more = extend_cut(s, after, {v}, on_edges);
    if (on_edges) { BOOST_TEST(more.empty()); }
    parents.insert(parents.end(), more.begin(), more.end());
    on_paths.insert(after.curves.back().vertices.begin(), after.curves.back().vertices.end());
    if (i == 0) // and across faces that the first path left
    {
      const auto more_goals = beyond_new_faces(after, disc.number_of_faces());
      goals.insert(goals.end(), more_goals.begin(), more_goals.end());
    }
  }
  BOOST_REQUIRE(after.curves.size() > before.curves.size());
  const Triangle_surface opened = surface_of(after.surface, after.opened);
  const auto at = carry_map(before, map.at, after, opened, parents);
  BOOST_REQUIRE(at.size() == opened.points.size());
  BOOST_TEST(is_one_to_one(opened, at));
  // the images of each vertex of the cut surface, before and after
  std::vector<std::vector<Plane_point>> was(after.surface.number_of_vertices());
  for (std::size_t v = 0; v < map.at.size(); ++v) { was[original(before, static_cast<Index>(v))].push_back(map.at[v]); }
  double longest = 0;
  for (Index h = 0; h < opened.number_of_halfedges(); ++h)
  {
    longest = std::max(longest, norm(at[opened.source(h)] - at[opened.target(h)]));
  }
  for (Index v = 0; v < opened.number_of_vertices(); ++v)
  {
    const Index w = original(after, v);
    if (was[w].empty()) { continue; } // a new vertex
    double nearest = 1;
    for (const Plane_point& p : was[w]) { nearest = std::min(nearest, norm(at[v] - p)); }
    BOOST_TEST(nearest <= (on_paths.count(w) > 0 ? longest : 0));
  }
  // no face is worse but for what the sides were moved
  const Distortion carried =
    measure_distortion(opened.points, opened.triangles, at, measure_faces(opened.points, opened.triangles, at));
  BOOST_TEST(carried.stretch_l2 < 1.02 * map.distortion.stretch_l2);
  const Parameterization better = improve_map(opened, at);
  BOOST_TEST(better.is_one_to_one);
  BOOST_TEST(better.attempts.size() == 1u);
  BOOST_TEST(better.distortion.stretch_l2 < map.distortion.stretch_l2);
}

// Without an option, a map that stretches its faces to more than twice has its cut extended until it does not.
BOOST_AUTO_TEST_CASE(what_stretches_too_much_is_extended)
{
  const auto thorny = sample::thorny_torus();
  const Triangle_surface disc = [&] {
    const Cut cut = pipeline::cut(thorny, pipeline::tight_curves());
    return surface_of(cut.surface, cut.opened);
  }();
  BOOST_TEST(pipeline::map(disc).distortion.stretch_l2 > 2);
  const Unwrapping u = pipeline::unwrap(thorny);
  for (const auto& failure : verify_cut(thorny, u.cut).failures) { BOOST_ERROR(failure); }
  BOOST_TEST(u.map.is_one_to_one);
  BOOST_TEST(u.map.distortion.stretch_l2 <= 2);
  BOOST_TEST(!u.extensions.empty());
  BOOST_TEST(pipeline::unwrap(sample::torus(40, 20)).extensions.empty());
}
