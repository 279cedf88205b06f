// Discs with fewer and fewer vertices, and maps that are made from coarse to fine.
#include "support/pipeline.h"
#include "support/sample_surfaces.h"

#include <meridian/base/vectors.h>
#include <meridian/cut/Cut.h>
#include <meridian/map/internal/disc_hierarchy.h>
#include <meridian/map/internal/distortion_energy.h>
#include <meridian/map/internal/map_by_levels.h>
#include <meridian/map/internal/relax_locally.h>
#include <meridian/map/is_one_to_one.h>
#include <meridian/map/map_into_polygon.h>
#include <meridian/map/map_with_low_stretch.h>
#include <meridian/map/minimize_distortion.h>
#include <meridian/map/planar_map.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/open_along.h>

#include <CGAL/Gmpq.h>

#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>

#include <numeric>
#include <set>

using namespace meridian;

namespace {

Triangle_surface disc_of(const Triangle_surface& s)
{
  const Cut cut = pipeline::cut(s);
  return surface_of(cut.surface, cut.opened);
}

// A square of n x n vertices in the plane, or bent.
Triangle_surface square(Index n, double bend = 0)
{
  Triangle_surface s;
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i)
    {
      const double x = static_cast<double>(i) / (n - 1), y = static_cast<double>(j) / (n - 1);
      s.points.push_back({x, y, bend * (x * x + std::sin(3 * y))});
    }
  for (Index j = 0; j + 1 < n; ++j)
    for (Index i = 0; i + 1 < n; ++i)
    {
      const Index a = j * n + i;
      s.triangles.push_back({a, a + 1, a + n + 1});
      s.triangles.push_back({a, a + n + 1, a + n});
    }
  return sample::connected(std::move(s));
}

std::vector<Plane_point> flat(const Triangle_surface& s)
{
  std::vector<Plane_point> at;
  for (const Point& p : s.points) { at.push_back({p[0], p[1]}); }
  return at;
}

// The number of faces that are not upright, counted with rational numbers.
int count_turned(const Triangle_surface& s, const std::vector<Plane_point>& at)
{
  int turned = 0;
  const auto r = [](double x) { return CGAL::Gmpq(x); };
  for (const auto& t : s.triangles)
  {
    const Plane_point &a = at[t[0]], &b = at[t[1]], &c = at[t[2]];
    turned += (r(b[0]) - r(a[0])) * (r(c[1]) - r(a[1])) <= (r(b[1]) - r(a[1])) * (r(c[0]) - r(a[0]));
  }
  return turned;
}

// The mean energy of a map, of the surface scaled to its area.
double energy_of(const Triangle_surface& s, const std::vector<Plane_point>& at)
{
  auto rest = internal::rest_triangles(s);
  double area = 0, sum = 0;
  for (const auto& t : rest) { area += t.weight; }
  const double scale = std::sqrt(area / area_of(s.triangles, at));
  for (auto& t : rest)
  {
    for (Plane_point& g : t.gradients) { g = scale * g; }
    sum += t.weight * internal::symmetric_dirichlet_energy(internal::gradient_of(t, at));
  }
  return sum / area;
}

Triangle_surface level_of(const Triangle_surface& disc, const internal::Disc_hierarchy& levels, std::size_t l,
                          std::vector<Index>& vertex)
{
  std::set<Index> used;
  for (const auto& t : levels.triangles(l)) { used.insert(t.begin(), t.end()); }
  vertex.assign(used.begin(), used.end());
  Triangle_surface s;
  for (Index v : vertex) { s.points.push_back(disc.points[v]); }
  const auto number = [&](Index v) {
    return static_cast<Index>(std::lower_bound(vertex.begin(), vertex.end(), v) - vertex.begin());
  };
  for (const auto& t : levels.triangles(l)) { s.triangles.push_back({number(t[0]), number(t[1]), number(t[2])}); }
  return sample::connected(std::move(s)); // throws if an edge has two faces on one side
}

} // namespace

BOOST_AUTO_TEST_CASE(every_level_is_a_disc_and_every_removal_a_polygon_of_it)
{
  for (const auto& disc :
       {disc_of(sample::noisy(sample::torus(60, 40), 0.01, 1)), disc_of(sample::plate(3, 6)), square(50, 0.3)})
  {
    const internal::Disc_hierarchy levels(disc, 200);
    BOOST_REQUIRE(levels.number_of_levels() > 2);
    BOOST_TEST((levels.triangles(0) == disc.triangles));
    std::vector<Index> vertex, finer;
    for (std::size_t l = 0; l < levels.number_of_levels(); ++l, finer = vertex)
    {
      const Triangle_surface s = level_of(disc, levels, l, vertex);
      BOOST_TEST(sample::euler_characteristic(s) == 1);
      BOOST_TEST(boundary_loops(s).size() == 1);
      if (l == 0) { continue; }
      BOOST_TEST(vertex.size() <= finer.size() / 4);
      // what is put back makes the finer level of this one, its border from this border
      std::set<Index> present(vertex.begin(), vertex.end()), border;
      const auto loops = boundary_loops(s);
      for (Index h : loops.front()) { border.insert(vertex[s.source(h)]); }
      Index faces = s.number_of_faces();
      levels.for_each_removal(l - 1, [&](const internal::Disc_hierarchy::Removal& r) {
        std::set<Index> ring;
        for (std::size_t i = r.begin; i < r.end; ++i)
        {
          ring.insert(levels.ring(i));
          BOOST_REQUIRE(present.count(levels.ring(i)) == 1);
        }
        BOOST_TEST(ring.size() == r.end - r.begin);
        BOOST_TEST(ring.count(r.into) == 1U);
        BOOST_TEST(present.insert(r.vertex).second);
        faces += r.is_border ? 1 : 2;
        if (!r.is_border) { return; }
        BOOST_TEST(border.count(levels.ring(r.begin)) == 1U);
        BOOST_TEST(border.count(levels.ring(r.end - 1)) == 1U);
        BOOST_TEST(border.count(r.into) == 1U);
        border.insert(r.vertex);
      });
      BOOST_TEST((std::vector<Index>(present.begin(), present.end()) == finer));
      BOOST_TEST(faces == static_cast<Index>(levels.triangles(l - 1).size()));
    }
    BOOST_TEST(vertex.size() <= 200U);
  }
}

BOOST_AUTO_TEST_CASE(a_disc_of_four_vertices_has_one_level)
{
  const internal::Disc_hierarchy levels(square(2), 1);
  BOOST_TEST(levels.number_of_levels() == 1U);
  BOOST_TEST(internal::map_by_levels(square(2), Distortion_options(), {}).empty());
}

// Edges without length, or some that are a hundred powers of ten longer than others, once led to sweeps without end.
BOOST_AUTO_TEST_CASE(levels_do_not_wait_for_lengths)
{
  for (double longest : {0., 1e-200, 1e100})
  {
    Triangle_surface disc = square(30);
    for (std::size_t i = 0; i < disc.points.size(); ++i) { disc.points[i] = {i % 7 == 0 ? longest : 0., 0, 0}; }
    const internal::Disc_hierarchy levels(disc, 20);
    BOOST_TEST(levels.number_of_levels() >= 1U);
  }
}

BOOST_DATA_TEST_CASE(from_coarse_to_fine_is_as_good_as_from_a_circle, boost::unit_test::data::xrange(3), which)
{
  const Triangle_surface disc = disc_of(which == 0   ? sample::noisy(sample::torus(150, 110), 0.002, 2)
                                        : which == 1 ? sample::noisy(sample::torus(150, 110), 0.03, 2)
                                                     : sample::noisy(sample::plate(9, 12), 0.02, 3));
  BOOST_REQUIRE(disc.number_of_vertices() > 15000);
  double last = 0;
  const auto at = internal::map_by_levels(disc, Distortion_options(), [&](double done) {
    BOOST_TEST(done >= last);
    last = done;
  });
  BOOST_TEST(last > 0);
  BOOST_REQUIRE(at.size() == disc.points.size());
  BOOST_TEST(count_turned(disc, at) == 0);
  BOOST_TEST(is_one_to_one(disc, at));
  const auto loop = boundary_loops(disc).front();
  auto other = map_with_low_stretch(disc, loop, place_on_circle(places_along(disc, loop)), 3);
  minimize_distortion(disc, other);
  BOOST_TEST(energy_of(disc, at) < 1.005 * energy_of(disc, other));
  BOOST_TEST((internal::map_by_levels(disc, Distortion_options(), {}) == at)); // the same bits again
}

BOOST_AUTO_TEST_CASE(a_map_does_not_depend_on_size)
{
  const Triangle_surface disc = disc_of(sample::torus(150, 110));
  const auto at = internal::map_by_levels(disc, Distortion_options(), {});
  BOOST_TEST(energy_of(disc, internal::map_by_levels(sample::scaled(disc, 8), Distortion_options(), {}))
               == energy_of(disc, at),
             boost::test_tools::tolerance(1e-6));
}

BOOST_AUTO_TEST_CASE(what_is_flat_is_mapped_as_it_is)
{
  const Triangle_surface disc = square(130);
  const auto at = internal::map_by_levels(disc, Distortion_options(), {});
  BOOST_REQUIRE(!at.empty());
  BOOST_TEST(energy_of(disc, at) == 4, boost::test_tools::tolerance(1e-3));
  BOOST_TEST(count_turned(disc, at) == 0);
}

BOOST_AUTO_TEST_CASE(squeezed_vertices_are_moved_and_no_others)
{
  const Index n = 21, squeezed = 10 * n + 10, fixed = 5 * n + 5;
  const Triangle_surface disc = square(n);
  const auto rest = internal::rest_triangles(disc);
  auto at = flat(disc);
  std::vector<char> may_move(at.size(), 1);
  may_move[fixed] = 0;
  const auto before = at;
  internal::relax_locally(rest, {}, may_move, at);
  BOOST_TEST((at == before)); // nothing is squeezed
  at[squeezed] = at[squeezed + 1] + 1e-6 * (at[squeezed] - at[squeezed + 1]);
  at[fixed] = at[fixed + 1] + 1e-6 * (at[fixed] - at[fixed + 1]);
  const auto stays = at[fixed];
  BOOST_TEST(energy_of(disc, at) > 1e6);
  internal::relax_locally(rest, {}, may_move, at);
  BOOST_TEST(count_turned(disc, at) == 0);
  BOOST_TEST((at[fixed] == stays));
  for (Index v : {Index(0), Index(2 * n + 15), Index(n * n - 1)}) { BOOST_TEST((at[v] == before[v])); }
  double around = 0, weight = 0;
  for (const auto& t : rest)
  {
    if (std::find(t.corners.begin(), t.corners.end(), squeezed) == t.corners.end()) { continue; }
    around += t.weight * internal::symmetric_dirichlet_energy(internal::gradient_of(t, at));
    weight += t.weight;
  }
  BOOST_TEST(around < 20 * weight);
}

BOOST_AUTO_TEST_CASE(the_direction_for_one_vertex_is_newtons)
{
  // Where the energy bends upwards in all directions, the step solves H d = -g, by differences.
  const Triangle_surface disc = square(3, 0.2);
  const auto rest = internal::rest_triangles(disc);
  auto at = flat(disc);
  const Index v = 4;
  at[v] = {0.53, 0.46};
  const auto for_each = [&](const auto& f) {
    for (const auto& t : rest)
      for (int k = 0; k < 3; ++k)
        if (t.corners[k] == v) { f(t, k); }
  };
  const auto energy = [&](double x, double y) {
    auto there = at;
    there[v] = {at[v][0] + x, at[v][1] + y};
    double sum = 0;
    for_each([&](const auto& t, int) {
      sum += t.weight * internal::symmetric_dirichlet_energy(internal::gradient_of(t, there));
    });
    return sum;
  };
  Plane_point d;
  BOOST_REQUIRE(internal::find_local_direction(for_each, at, d));
  const double h = 1e-4;
  const double gx = (energy(h, 0) - energy(-h, 0)) / (2 * h), gy = (energy(0, h) - energy(0, -h)) / (2 * h);
  BOOST_TEST(gx * d[0] + gy * d[1] < 0);
  const double xx = (energy(h, 0) - 2 * energy(0, 0) + energy(-h, 0)) / (h * h),
               yy = (energy(0, h) - 2 * energy(0, 0) + energy(0, -h)) / (h * h),
               xy = (energy(h, h) - energy(h, -h) - energy(-h, h) + energy(-h, -h)) / (4 * h * h);
  BOOST_TEST(xx * d[0] + xy * d[1] == -gx, boost::test_tools::tolerance(0.05));
  BOOST_TEST(xy * d[0] + yy * d[1] == -gy, boost::test_tools::tolerance(0.05));
}
