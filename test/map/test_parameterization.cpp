#include "support/implicit_surfaces.h"
#include "support/pipeline.h"
#include "support/sample_surfaces.h"

#include <meridian/base/Bounding_box.h>
#include <meridian/base/Polygon_soup.h>
#include <meridian/base/Result_mesh.h>
#include <meridian/base/Verification.h>
#include <meridian/base/exceptions.h>
#include <meridian/base/vectors.h>
#include <meridian/cut/Cut.h>
#include <meridian/field/edge_weights.h>
#include <meridian/map/Parameterization.h>
#include <meridian/map/distortion.h>
#include <meridian/map/internal/distortion_energy.h>
#include <meridian/map/is_one_to_one.h>
#include <meridian/map/map_into_polygon.h>
#include <meridian/map/minimize_distortion.h>
#include <meridian/map/pack_charts.h>
#include <meridian/map/planar_map.h>
#include <meridian/proof/verify_cut.h>
#include <meridian/proof/verify_unwrapping.h>
#include <meridian/result/recount.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/open_along.h>
#include <meridian/unwrap/Unwrapping.h>
#include <meridian/unwrap/internal/Unwrapper.h>

#include <CGAL/Gmpq.h>

#include <numeric>
#include <random>
#include <set>

namespace data = boost::unit_test::data;
using namespace meridian;

namespace {

// The sign of a triangle's area in rational numbers.
int exact_sign(const Plane_point& a, const Plane_point& b, const Plane_point& c)
{
  const auto r = [](double x) { return CGAL::Gmpq(x); };
  const CGAL::Gmpq area = (r(b[0]) - r(a[0])) * (r(c[1]) - r(a[1])) - (r(b[1]) - r(a[1])) * (r(c[0]) - r(a[0]));
  return CGAL::sign(area);
}

Index recount_flips(const std::vector<std::array<Index, 3>>& triangles, const std::vector<Plane_point>& at)
{
  Index flips = 0;
  for (const auto& t : triangles) { flips += exact_sign(at[t[0]], at[t[1]], at[t[2]]) <= 0; }
  return flips;
}

// A disc of it.
Triangle_surface disc_of(const Triangle_surface& s)
{
  const Cut cut = pipeline::cut(s);
  return surface_of(cut.surface, cut.opened);
}

const std::vector<std::pair<const char*, Triangle_surface>>& samples()
{
  static const std::vector<std::pair<const char*, Triangle_surface>> all{
    {"torus", sample::torus(20, 12)},
    {"coarse torus", sample::torus(3, 3)},
    {"bitorus", sample::bitorus(14)},
    {"sphere", sample::sphere(3)},
    {"plate", sample::plate(5, 2)},
    {"teapot", sample::teapot(16)},
    {"noisy torus", sample::noisy(sample::torus(20, 14), 0.2, 3)},
    {"disc", sample::punctured(sample::sphere(3), {0})},
    {"triangle", sample::connected({{{0, 0, 0}, {3, 0, 0}, {0, 4, 1}}, {{0, 1, 2}}, {}, {}})}};
  return all;
}

double total_energy(const std::vector<internal::Rest_triangle>& rest, const std::vector<Plane_point>& at)
{
  double sum = 0;
  for (const auto& t : rest) { sum += t.weight * internal::symmetric_dirichlet_energy(internal::gradient_of(t, at)); }
  return sum;
}

} // namespace

BOOST_AUTO_TEST_CASE(the_sign_of_an_area_is_exact)
{
  // Points on a line, one moved by the last bit.
  const Plane_point a{0.1, 0.1}, b{0.3, 0.3}, c{0.7, 0.7};
  BOOST_TEST(orientation_of(a, b, c) == exact_sign(a, b, c));
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  int zero = 0;
  for (int i = 0; i < 20000; ++i)
  {
    const double t = unit(random), u = unit(random);
    Plane_point p{t, t}, q{u, u}, r{0.5, i % 3 == 0 ? 0.5 : std::nextafter(0.5, i % 3)};
    if (i % 2)
    {
      for (Plane_point* x : {&p, &q, &r}) { *x = std::ldexp(1., -500) * *x; }
    } // products underflow
    BOOST_REQUIRE(orientation_of(p, q, r) == exact_sign(p, q, r));
    zero += exact_sign(p, q, r) == 0;
  }
  BOOST_TEST(zero > 6000);
}

BOOST_DATA_TEST_CASE(the_derivatives_of_an_energy_are_those_of_differences, data::make({false, true}), is_conformal)
{
  const auto kind = is_conformal ? Distortion_energy::CONFORMAL : Distortion_energy::SYMMETRIC_DIRICHLET;
  int compared = 0; // directions
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int i = 0; i < 500; ++i)
  {
    const double b = 1 + 0.5 * unit(random), x0 = unit(random), y0 = 0.6 + 0.5 * unit(random);
    const auto t = internal::make_rest_triangle({0, 1, 2}, b, x0, y0);
    const std::array<Plane_point, 3> rest{Plane_point{0, 0}, Plane_point{b, 0}, Plane_point{x0, y0}};
    std::vector<Plane_point> at(3);
    do {
      for (int k = 0; k < 3; ++k)
      {
        const Plane_point p{unit(random), unit(random)};
        at[k] = i % 2 ? p : rest[k] + 0.1 * p; // far from the shape that it should have, or near
      }
    } while (internal::gradient_of(t, at).determinant() < 0.3);
    const auto energy = [&] { return internal::energy_of(kind, internal::gradient_of(t, at)); };
    const auto d = internal::derive_energy(t, internal::gradient_of(t, at), kind);
    std::vector<std::array<double, 6>> left_out; // directions in which it bends downwards
    for (const auto& mode : d.modes)
    {
      BOOST_REQUIRE(mode.lambda >= 0);
      if (mode.lambda == 0) { left_out.push_back(mode.q); }
    }
    std::array<std::array<double, 6>, 6> second;
    for (int k = 0; k < 6; ++k)
    {
      double& x = at[k / 2][k % 2];
      const double step = 1e-5, kept = x;
      x = kept + step;
      const double up = energy();
      const auto d_up = internal::derive_energy(t, internal::gradient_of(t, at), kind);
      x = kept - step;
      const double down = energy();
      const auto d_down = internal::derive_energy(t, internal::gradient_of(t, at), kind);
      x = kept;
      const double size = 1 + std::abs(d.gradient[k]);
      BOOST_REQUIRE(std::abs((up - down) / (2 * step) - d.gradient[k]) < 1e-4 * size * size);
      for (int l = 0; l < 6; ++l) { second[k][l] = (d_up.gradient[l] - d_down.gradient[l]) / (2 * step); }
    }
    if (left_out.size() > 1) { continue; }
    for (int k = 0; k < 6; ++k)
    {
      std::array<double, 6> z{}; // a direction in which nothing was left out
      z[k] = 1;
      for (const auto& q : left_out)
      {
        const double part = q[k] / std::inner_product(q.begin(), q.end(), q.begin(), 0.);
        for (int l = 0; l < 6; ++l) { z[l] -= part * q[l]; }
      }
      double by_differences = 0, by_modes = 0, size = 1;
      for (int l = 0; l < 6; ++l)
      {
        by_differences += z[l] * std::inner_product(z.begin(), z.end(), second[l].begin(), 0.);
        for (double x : second[l]) { size = std::max(size, std::abs(x)); }
      }
      for (const auto& mode : d.modes)
      {
        const double along = std::inner_product(z.begin(), z.end(), mode.q.begin(), 0.);
        by_modes += mode.lambda * along * along;
      }
      BOOST_REQUIRE(std::abs(by_differences - by_modes) < 1e-4 * size);
      ++compared;
    }
  }
  BOOST_TEST(compared > 600);
}

BOOST_AUTO_TEST_CASE(a_step_ends_where_a_triangle_collapses)
{
  const auto t = internal::make_rest_triangle({0, 1, 2}, 1, 0, 1);
  const std::vector<Plane_point> at{{0, 0}, {1, 0}, {0, 1}};
  BOOST_TEST(internal::step_to_collapse(t, at, {{0, 0}, {0, 0}, {0, -2}}) == 0.5, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(internal::step_to_collapse(t, at, {{0, 0}, {0, 0}, {0, 5}}) == 1.);
  // the first of two
  BOOST_TEST(internal::step_to_collapse(t, at, {{0, 0}, {-4, 0}, {0, -2}}) == 0.25,
             boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(distortion_of_a_linear_map_is_known)
{
  // (x, y) -> (2 x, y / 2) keeps area; the map to the surface has the singular values 2 and 1/2.
  const Triangle_surface s = sample::sheet(4, 3, [](double x, double y) { return Point{3 * x, 2 * y, 0}; });
  std::vector<Plane_point> at;
  for (const Point& p : s.points) { at.push_back({2 * p[0], p[1] / 2}); }
  const auto check = [](const Distortion& d) {
    BOOST_TEST(d.stretch_l2 == std::sqrt((4 + 0.25) / 2), boost::test_tools::tolerance(1e-12));
    BOOST_TEST(d.stretch_linf == 2., boost::test_tools::tolerance(1e-12));
    BOOST_TEST(d.conformal == 4., boost::test_tools::tolerance(1e-12));
    BOOST_TEST(d.areal == 1., boost::test_tools::tolerance(1e-12));
    BOOST_TEST(d.area < 1e-12);
    BOOST_TEST(d.angle > 0.3);
  };
  const auto measure = [](const Triangle_surface& t, const std::vector<Plane_point>& x) {
    return measure_distortion(t.points, t.triangles, x, measure_faces(t.points, t.triangles, x));
  };
  check(measure(s, at));
  std::vector<Plane_point> larger = at; // it depends on no scale, and on no motion
  for (Plane_point& p : larger) { p = {7 - 100 * p[1], 100 * p[0]}; }
  check(measure(s, larger));
  check(measure(sample::scaled(s, 1e-6), at));

  // Twice the share of area on one half: Gamma gamma is 3/4 there and 3/2 on the other.
  const Triangle_surface two = sample::sheet(2, 1, [](double x, double y) { return Point{2 * x, y, 0}; });
  std::vector<Plane_point> uneven;
  for (const Point& p : two.points) { uneven.push_back({p[0] < 1.5 ? 2 * p[0] : p[0] + 1, p[1]}); }
  const Distortion d = measure(two, uneven);
  BOOST_TEST(d.area == 1. / 3, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(d.areal == (4. / 3 + 3. / 2) / 2, boost::test_tools::tolerance(1e-12));

  for (Plane_point& p : at) { p[0] = -p[0]; }
  BOOST_TEST(find_flipped_faces(s.triangles, at).size() == s.triangles.size());
  BOOST_TEST(std::isinf(measure(s, at).stretch_l2));
}

// What can be unrolled is unrolled.
BOOST_AUTO_TEST_CASE(developable_surfaces_are_mapped_without_distortion)
{
  const auto cylinder = sample::sheet(24, 10, [](double x, double y) {
    return Point{std::cos(5 * x), std::sin(5 * x), 2 * y};
  });
  const auto cone = sample::sheet(24, 8, [](double x, double y) {
    return Point{(1 + y) * std::cos(3 * x), (1 + y) * std::sin(3 * x), 2 * y};
  });
  const auto roll = sample::sheet(60, 6, [](double x, double y) {
    return Point{(1 + x) * std::cos(9 * x), (1 + x) * std::sin(9 * x), y};
  });
  for (const Triangle_surface& s : {cylinder, roll})
  {
    const auto d = pipeline::map(s).distortion;
    BOOST_TEST(d.stretch_l2 < 1 + 2e-4);
    BOOST_TEST(d.angle < 0.01);
  }
  BOOST_TEST(pipeline::map(cone).distortion.stretch_l2 < 1.001); // its faces are planar only in the limit
  BOOST_TEST(pipeline::map(sample::scaled(cylinder, 1e-5)).distortion.stretch_l2 < 1 + 2e-4);
}

BOOST_DATA_TEST_CASE(every_method_gives_a_map_without_flipped_faces, data::xrange(9) * data::xrange(7), i, m)
{
  const Triangle_surface disc = disc_of(samples()[i].second);
  for (Map_border border : {Map_border::FREE, Map_border::CIRCLE, Map_border::SQUARE})
  {
    Map_options options;
    options.method = all<Map_method>()[m];
    options.border = border;
    const Parameterization p = pipeline::map(disc, options);
    BOOST_TEST_CONTEXT(samples()[i].first << ' ' << name_of(options.method) << ' ' << name_of(border))
    {
      BOOST_TEST(p.flipped.size() == 0u);
      BOOST_TEST(recount_flips(disc.triangles, p.at) == 0);
      BOOST_TEST(p.distortion.stretch_l2 >= 1 - 1e-9); // Cauchy and Schwarz
      BOOST_TEST((p.attempts.back().method == p.method));
      BOOST_TEST(p.attempts.back().flipped == 0);
      for (std::size_t k = 0; k + 1 < p.attempts.size(); ++k) { BOOST_TEST(p.attempts[k].flipped != 0); }
      if (p.border != Map_border::FREE || improves_maps(p.method)) { BOOST_TEST(p.is_one_to_one); }
      if (border == Map_border::CIRCLE && p.method == options.method)
        for (const Plane_point& q : p.at) { BOOST_TEST(norm(q - Plane_point{0.5, 0.5}) < 0.72); }
      if (border == Map_border::SQUARE && p.border == border)
        for (Index v = 0; v < disc.number_of_vertices(); ++v)
          BOOST_TEST((p.at[v][0] == 0 || p.at[v][0] == 1 || p.at[v][1] == 0 || p.at[v][1] == 1)
                     == disc.is_boundary_vertex(v));
    }
  }
}

BOOST_AUTO_TEST_CASE(conformal_maps_keep_angles_better)
{
  for (const auto& [name, s] : samples())
  {
    const Triangle_surface disc = disc_of(s);
    Map_options options;
    const Distortion low = pipeline::map(disc, options).distortion;
    options.method = Map_method::CONFORMAL;
    const Distortion found = pipeline::map(disc, options).distortion;
    BOOST_TEST_CONTEXT(name)
    {
      if (low.angle < 1e-6) { BOOST_TEST(found.angle < 1e-5); } // both are exact
      else { BOOST_TEST(found.angle < low.angle); }
    }
    options.border = Map_border::CIRCLE;
    const Parameterization in_circle = pipeline::map(disc, options);
    options.method = Map_method::SYMMETRIC_DIRICHLET;
    BOOST_TEST(in_circle.distortion.angle <= 1.001 * pipeline::map(disc, options).distortion.angle);
  }
}

BOOST_AUTO_TEST_CASE(a_border_that_is_fixed_stays_to_the_bit)
{
  const Triangle_surface disc = disc_of(sample::bitorus(20));
  const auto loops = boundary_loops(disc);
  const auto circle = place_on_circle(places_along(disc, loops.front()));
  auto at = map_into_polygon(disc, edge_weights(disc, Weights::POSITIVE), loops.front(), circle);
  Distortion_options fixed;
  fixed.has_free_border = false;
  internal::Distortion_minimizer minimizer(disc, at, fixed);
  for (int i = 0; i < 10; ++i) { minimizer.step(); }
  for (std::size_t i = 0; i < circle.size(); ++i) { BOOST_TEST((at[disc.source(loops.front()[i])] == circle[i])); }
  BOOST_TEST(find_flipped_faces(disc.triangles, at).size() == 0u);
  Map_options options;
  options.border = Map_border::CIRCLE;
  const Parameterization p = pipeline::map(disc, options);
  options.method = Map_method::POSITIVE;
  BOOST_TEST(p.distortion.stretch_l2 < 0.8 * pipeline::map(disc, options).distortion.stretch_l2);
  options = {};
  BOOST_TEST(pipeline::map(disc, options).distortion.stretch_l2 < p.distortion.stretch_l2);
}

BOOST_AUTO_TEST_CASE(polygons_that_would_be_ignored_are_refused)
{
  const Triangle_surface disc = disc_of(sample::bitorus(20));
  Map_options options;
  options.border = Map_border::SQUARE;
  options.loop = boundary_loops(disc).front();
  BOOST_CHECK_THROW(pipeline::map(disc, options), Invalid_input_error); // a border without places
  options.polygon = place_on_circle(places_along(disc, options.loop));
  for (const Map_method method : all<Map_method>())
  {
    options.method = method;
    if (!takes_polygon(method))
    {
      BOOST_CHECK_THROW(check(options), Invalid_input_error);
      continue;
    }
    const Parameterization p = pipeline::map(disc, options);
    Bounding_box<Plane_point> box(options.polygon.front());
    for (const Plane_point& q : options.polygon) { box.add(q); }
    const double size = std::max(box.high[0] - box.low[0], box.high[1] - box.low[1]);
    for (std::size_t i = 0; i < options.loop.size(); ++i)
    {
      const Plane_point wanted = 1 / size * (options.polygon[i] - box.low);
      BOOST_TEST(norm(p.at[disc.source(options.loop[i])] - wanted) < 1e-12);
    }
  }
  options.border = Map_border::CIRCLE;
  BOOST_CHECK_THROW(check(options), Invalid_input_error);
}

// Each step lowers the energy, and the image stays a simple polygon without flipped faces. The last map is stationary.
BOOST_AUTO_TEST_CASE(minimizing_goes_down_and_stays_one_to_one)
{
  for (const auto& [name, s] : samples())
  {
    const Triangle_surface disc = disc_of(s);
    Map_options options;
    options.method = Map_method::POSITIVE;
    std::vector<Plane_point> at = pipeline::map(disc, options).at;
    internal::Distortion_minimizer minimizer(disc, at, Distortion_options());
    auto rest = internal::rest_triangles(disc);
    double area = 0;
    for (const auto& t : rest) { area += t.weight; }
    const double scale = std::sqrt(area / area_of(disc.triangles, at));
    for (auto& t : rest)
    {
      for (Plane_point& g : t.gradients) { g = scale * g; }
    }
    double last = total_energy(rest, at);
    BOOST_TEST_CONTEXT(name)
    {
      double gain = 1;
      for (int i = 0; i < 60 && gain > 1e-7; ++i)
      {
        gain = minimizer.step();
        const double now = total_energy(rest, at);
        BOOST_TEST(now <= last);
        BOOST_TEST(is_one_to_one(disc, at));
        last = now;
      }
      BOOST_TEST(gain < 1e-3);
      BOOST_TEST(last >= 4 * area * (1 - 1e-12)); // an isometry has 4
    }
  }
}

BOOST_AUTO_TEST_CASE(a_map_that_winds_twice_is_not_one_to_one)
{
  // A fan of 2 x 8 faces around one vertex, each an eighth of a turn: no face is flipped, and the border goes around
  // twice.
  Triangle_surface s;
  std::vector<Plane_point> at{{0, 0}};
  s.points.push_back({0, 0, 0});
  for (int i = 0; i < 16; ++i)
  {
    s.points.push_back({std::cos(sample::pi * i / 8), std::sin(sample::pi * i / 8), 0});
    at.push_back({(1 + 0.01 * i) * std::cos(sample::pi * i / 4), (1 + 0.01 * i) * std::sin(sample::pi * i / 4)});
    s.triangles.push_back({0, 1 + i, 1 + (i + 1) % 16});
  }
  s = sample::connected(std::move(s));
  BOOST_TEST(find_flipped_faces(s.triangles, at).size() == 0u);
  BOOST_TEST(!is_one_to_one(s, at));
  for (int i = 0; i < 16; ++i) { at[1 + i] = {s.points[1 + i][0], s.points[1 + i][1]}; }
  BOOST_TEST(is_one_to_one(s, at));
}

BOOST_AUTO_TEST_CASE(distortion_does_not_depend_on_scale_or_mirror)
{
  const Triangle_surface disc = disc_of(sample::bitorus(16));
  const double whole = pipeline::map(disc).distortion.stretch_l2;
  BOOST_TEST(pipeline::map(sample::scaled(disc, std::ldexp(1., 40))).distortion.stretch_l2 == whole,
             boost::test_tools::tolerance(1e-9));
  BOOST_TEST(pipeline::map(sample::scaled(disc, 1e-3)).distortion.stretch_l2 == whole,
             boost::test_tools::tolerance(1e-4));
  BOOST_TEST(pipeline::map(sample::mirrored(disc)).distortion.stretch_l2 == whole, boost::test_tools::tolerance(2e-2));
  BOOST_TEST((pipeline::map(disc).at == pipeline::map(disc).at)); // deterministic
}

// The end of a tube underflows in a map into a circle; more stretch, or a better cut, saves it.
BOOST_AUTO_TEST_CASE(long_tubes_are_saved)
{
  const Triangle_surface s = sample::tube_with_cap(8, 240); // 60 radii
  Map_options options;
  options.method = Map_method::POSITIVE;
  const Parameterization p = pipeline::map(s, options);
  BOOST_TEST(p.attempts.front().flipped > 0);
  Unwrap_options unwrap;
  const Unwrapping u = pipeline::unwrap(s, unwrap);
  BOOST_TEST(u.map.flipped.size() == 0u);
  BOOST_TEST(recount_flips(u.disc.triangles, u.map.at) == 0);
  const Triangle_surface longer = sample::tube_with_cap(6, 1200); // 300 radii
  const Unwrapping v = pipeline::unwrap(longer, unwrap);
  BOOST_TEST(v.map.flipped.size() == 0u);
  BOOST_TEST(verify_cut(longer, v.cut).failures.size() == 0u);
}

BOOST_AUTO_TEST_CASE(stretch_falls_with_every_extension)
{
  for (const auto& [name, s] : {samples()[2], samples()[3], samples()[5]})
    for (bool on_edges : {false, true})
    {
      Unwrap_options options;
      options.cut.on_edges = on_edges;
      const Unwrapping plain = pipeline::unwrap(s, options);
      options.max_stretch = 1 + 0.6 * (plain.map.distortion.stretch_l2 - 1);
      const Unwrapping u = pipeline::unwrap(s, options);
      BOOST_TEST_CONTEXT(name)
      {
        BOOST_TEST(u.extensions.size() > 0u);
        double stretch = plain.map.distortion.stretch_l2, length = plain.cut.length;
        for (const Unwrap_step& e : u.extensions)
        {
          BOOST_TEST(e.length > length);
          if (!e.is_taken)
          {
            BOOST_TEST(e.stretch_l2 >= stretch);
            continue;
          }
          BOOST_TEST(e.stretch_l2 < stretch);
          stretch = e.stretch_l2;
          length = e.length;
        }
        BOOST_TEST(u.map.distortion.stretch_l2 == stretch);
        BOOST_TEST(u.cut.length == length);
        BOOST_TEST(verify_cut(s, u.cut).failures.size() == 0u);
        if (on_edges) { BOOST_TEST(u.cut.surface.origins.size() == 0u); }
      }
    }
}

// The paper's functional: the one taken costs least of all that were tried.
BOOST_AUTO_TEST_CASE(the_cut_of_least_cost_is_taken)
{
  const Triangle_surface s = sample::three_rings(16);
  double area = 0;
  for (const auto& t : s.triangles)
  {
    area += norm(cross(s.points[t[1]] - s.points[t[0]], s.points[t[2]] - s.points[t[0]])) / 2;
  }
  for (double w : {0., 0.5, 1.})
  {
    Unwrap_options options;
    options.family = 6;
    options.stretch_weight = w;
    const Unwrapping u = pipeline::unwrap(s, options);
    const auto cost = [&](double length, double stretch) {
      return w > 0 ? (1 - w) * length / std::sqrt(area) + w * stretch : length / std::sqrt(area);
    };
    double least = cost(u.cut.length, u.map.distortion.stretch_l2);
    BOOST_TEST(u.members.size() == 6u);
    BOOST_TEST((u.variations.size() > 0) == (w > 0));
    std::set<double> lengths;
    for (const auto* steps : {&u.members, &u.variations})
      for (const Unwrap_step& e : *steps)
      {
        BOOST_TEST(cost(e.length, e.stretch_l2) >= least);
        lengths.insert(e.length);
      }
    BOOST_TEST(lengths.size() > 4u);
    BOOST_TEST(lengths.count(u.cut.length) == 1u);
    if (w == 0) { BOOST_TEST(*lengths.begin() == u.cut.length); }
  }
}

namespace {

// Two components, so that charts can overlap.
Polygon_soup twice(const Polygon_soup& once)
{
  Polygon_soup soup = once;
  for (const auto& p : once.points) { soup.points.push_back({p[0] + 10, p[1], p[2]}); }
  for (std::size_t f = 0; f < once.number_of_polygons(); ++f)
  {
    std::array<Index, 3> t;
    for (std::size_t k = 0; k < 3; ++k) { t[k] = once.corner(f, k) + static_cast<Index>(once.points.size()); }
    soup.add_polygon(t.data(), 3);
  }
  return soup;
}

} // namespace

BOOST_AUTO_TEST_CASE(each_fault_of_an_unwrapping_is_caught_by_name)
{
  const Triangle_surface s = sample::bitorus(16);
  const Polygon_soup soup = twice(sample::soup(s));
  const pipeline::Run run = pipeline::run(soup);
  std::vector<Triangle_surface> discs;
  std::vector<Chart> charts;
  for (const Cut& cut : run.cuts) { discs.push_back(surface_of(cut.surface, cut.opened)); }
  for (const Triangle_surface& d : discs) { charts.push_back({&d.triangles, pipeline::map(d).at, 1}); }
  pack_charts(charts);
  std::vector<Plane_point> texture(run.assembled.mesh.points.size(), {0, 0});
  for (std::size_t i = 0; i < charts.size(); ++i)
    for (std::size_t v = 0; v < charts[i].at.size(); ++v) { texture[run.assembled.place[i][v]] = charts[i].at[v]; }

  const Result_mesh& mesh = run.assembled.mesh;
  const auto expect = [&](const Result_mesh& m, const std::vector<Plane_point>& at, const std::string& text) {
    const Verification v = verify_unwrapping(soup, m, at);
    if (text.empty())
    {
      BOOST_TEST(v.failures.size() == 0u);
      return;
    }
    BOOST_TEST_REQUIRE(v.failures.size() > 0u);
    BOOST_TEST(v.failures.front().find(text) != std::string::npos, v.failures.front());
  };
  expect(mesh, texture, "");
  const auto& face = mesh.faces[20];
  auto faulty = texture;
  std::swap(faulty[face[0]], faulty[face[1]]);
  expect(mesh, faulty, "turned over");
  faulty = texture;
  faulty[face[0]] = faulty[face[1]];
  expect(mesh, faulty, "turned over or have no area");
  faulty = texture;
  faulty[face[2]][1] = 1.5;
  expect(mesh, faulty, "outside of the unit square");
  faulty[face[2]][1] = std::nan("");
  expect(mesh, faulty, "outside of the unit square");
  faulty = texture;
  faulty.pop_back();
  expect(mesh, faulty, "texture coordinates");
  const auto move = [&](std::size_t i, double scale, const Plane_point& to) {
    for (std::size_t v = 0; v < charts[i].at.size(); ++v)
    {
      faulty[run.assembled.place[i][v]] = scale * (charts[i].at[v] - charts[i].at[0]) + to;
    }
  };
  faulty = texture;
  const auto& inner = discs[0].triangles[20];
  const std::array<Plane_point, 3> at{charts[0].at[inner[0]], charts[0].at[inner[1]], charts[0].at[inner[2]]};
  move(1, 1e-4, (1. / 3) * (at[0] + at[1] + at[2]));
  expect(mesh, faulty, "charts lie inside others");
  BOOST_TEST(verify_unwrapping(soup, mesh, texture, 1e-9).failures.size() == 0u);
  BOOST_TEST_REQUIRE(verify_unwrapping(soup, mesh, texture, 0.5).failures.size() == 1u);
  BOOST_TEST(verify_unwrapping(soup, mesh, texture, 0.5).failures[0].find("nearer to another chart")
             != std::string::npos);

  // in a tile of its own, which is number 13; on the line between two
  faulty = texture;
  move(1, 1e-3, {3.5, 1.5});
  BOOST_TEST(verify_unwrapping(soup, mesh, faulty, 0.5, 14).failures.size() == 0u);
  BOOST_TEST(!verify_unwrapping(soup, mesh, faulty, 0, 13));
  move(1, 1e-3, {3, 1.5});
  BOOST_TEST_REQUIRE(verify_unwrapping(soup, mesh, faulty, 0, 14).failures.size() == 1u);
  BOOST_TEST(verify_unwrapping(soup, mesh, faulty, 0, 14).failures[0].find("not in one tile") != std::string::npos);

  Result_mesh charted = mesh;
  charted.chart_of = mesh.component_of;
  expect(charted, texture, "");
  charted.chart_of.assign(mesh.faces.size(), 0);
  expect(charted, texture, "charts are not one disc each");
  charted.chart_of = mesh.component_of;
  charted.chart_of[20] = 1 - charted.chart_of[20];
  expect(charted, texture, "in another chart than what they are joined to");
  charted.chart_of[20] = -1;
  expect(charted, texture, "have a chart out of range");
  charted.chart_of.pop_back();
  expect(charted, texture, "entries for the charts");

  faulty = texture;
  for (std::size_t i = 0; i < 2; ++i) // both to the same corner
  {
    Plane_point low{1, 1};
    for (const Plane_point& p : charts[i].at) { low = {std::min(low[0], p[0]), std::min(low[1], p[1])}; }
    for (std::size_t v = 0; v < charts[i].at.size(); ++v) { faulty[run.assembled.place[i][v]] = charts[i].at[v] - low; }
  }
  expect(mesh, faulty, "border in the plane that meets another");
  Result_mesh torn = mesh;
  torn.seams.pop_back();
  BOOST_TEST(!verify_unwrapping(soup, torn, texture));
}

// A grid in a turned rectangle lies along its longer side; points on a line along it; one point anyhow.
BOOST_AUTO_TEST_CASE(the_smallest_rectangle_lies_along_its_longer_side)
{
  for (const double angle : {0., 0.3, 1.2, 2.5})
  {
    const Plane_point d{std::cos(angle), std::sin(angle)}, across{-d[1], d[0]};
    std::vector<Plane_point> grid, line;
    for (int i = 0; i <= 5; ++i)
    {
      line.push_back((0.3 * i) * d);
      for (int j = 0; j <= 3; ++j) { grid.push_back((0.3 * i) * d + (0.4 * j) * across); }
    }
    for (const auto& points : {grid, line})
    {
      const Plane_point side = longer_side_of_smallest_rectangle(points);
      BOOST_TEST(std::abs(dot(side, d)) == 1, boost::test_tools::tolerance(1e-12));
    }
  }
  BOOST_TEST(norm(longer_side_of_smallest_rectangle({{2, 3}, {2, 3}})) == 1);
}
