// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/map/internal/map_by_levels.h>

#include <meridian/base/exceptions.h>
#include <meridian/map/constrained_triangulation.h>
#include <meridian/map/internal/disc_hierarchy.h>
#include <meridian/map/internal/distortion_energy.h>
#include <meridian/map/internal/relax_locally.h>
#include <meridian/map/is_one_to_one.h>
#include <meridian/map/map_into_polygon.h>
#include <meridian/map/map_with_low_stretch.h>
#include <meridian/map/planar_map.h>
#include <meridian/surface/measures.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace meridian {

namespace internal {

namespace {

// A level with vertices of its own.
struct Level_surface
{
  Triangle_surface surface;
  std::vector<Index> vertex; // of the disc
};

Level_surface surface_of(const Triangle_surface& disc, const std::vector<std::array<Index, 3>>& triangles)
{
  Level_surface level;
  std::vector<Index> number(disc.number_of_vertices(), -1);
  for (const auto& t : triangles)
    for (Index v : t) { number[v] = 0; }
  for (Index v = 0; v < disc.number_of_vertices(); ++v)
  {
    if (number[v] < 0) { continue; }
    number[v] = static_cast<Index>(level.vertex.size());
    level.vertex.push_back(v);
    level.surface.points.push_back(disc.points[v]);
  }
  for (const auto& t : triangles) { level.surface.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]}); }
  connect(level.surface);
  return level;
}

// Puts vertices into the polygons of their neighbours, one by one. On the border a vertex may also go into the triangle
// that its side has outside: no two sides have the same, so the border stays simple but for rounding.
class Vertex_placer
{
public:
  // `at` has room for four points more than there are vertices.
  Vertex_placer(const Triangle_surface& disc, const Disc_hierarchy& levels, std::vector<Plane_point>& at)
    : m_disc(disc), m_levels(levels), m_at(at)
  {
    for (Index h = 0; h < disc.number_of_halfedges(); ++h) { m_mean += disc.length(h) / disc.number_of_halfedges(); }
  }

  // Begins another level. `loop`: the border of the last; `scale`: what lengths in the plane are, in those of the
  // surface.
  void begin(const std::vector<Index>& loop, double scale)
  {
    m_scale = scale;
    m_at.resize(m_disc.number_of_vertices());
    const auto outside = triangulate_outside(loop, m_at);
    m_apex.resize(m_at.size());
    std::vector<Index> next(m_at.size(), -1);
    for (std::size_t i = 0; i < loop.size(); ++i) { next[loop[i]] = loop[(i + 1) % loop.size()]; }
    for (const auto& t : outside)
    {
      const auto is_side = [&](int k) { return next[t[(k + 1) % 3]] == t[k]; };
      const bool is_shared = is_side(0) + is_side(1) + is_side(2) > 1;
      const Plane_point middle = (1. / 3) * (m_at[t[0]] + m_at[t[1]] + m_at[t[2]]);
      for (int k = 0; k < 3; ++k)
        if (is_side(k)) { m_apex[t[(k + 1) % 3]] = is_shared ? middle : m_at[t[(k + 2) % 3]]; }
    }
  }

  // Returns false if there is no room in double precision.
  bool place(const Disc_hierarchy::Removal& removal)
  {
    m_removal = removal;
    m_ring.clear();
    for (std::size_t i = removal.begin; i < removal.end; ++i) { m_ring.push_back(m_levels.ring(i)); }
    Plane_point p = mean_of_ring();
    if (!is_inside(p) && !find_inside(p)) { return false; }
    improve(p);
    m_at[removal.vertex] = p;
    if (removal.is_border)
    {
      Plane_point& apex = m_apex[m_ring.back()];
      if (!sees_apex(p)) { apex = 0.5 * (corner(0) + corner(m_ring.size() - 1)); } // of what it left free
      m_apex[removal.vertex] = apex;
    }
    return true;
  }

private:
  const Plane_point& corner(std::size_t i) const { return m_at[m_ring[i % m_ring.size()]]; }
  std::size_t number_of_faces() const { return m_ring.size() - m_removal.is_border; }

  // Whether all faces around `p` are upright, and the border stays out of the way of itself.
  bool is_inside(const Plane_point& p) const
  {
    for (std::size_t i = 0; i < number_of_faces(); ++i)
    {
      if (orientation_of(p, corner(i), corner(i + 1)) <= 0) { return false; }
    }
    return !m_removal.is_border || sees_apex(p) || orientation_of(p, corner(m_ring.size() - 1), corner(0)) > 0;
  }

  // Whether the triangle outside of the side is divided by the lines from its apex to `p`.
  bool sees_apex(const Plane_point& p) const
  {
    const Plane_point& apex = m_apex[m_ring.back()];
    return orientation_of(p, corner(m_ring.size() - 1), apex) > 0 && orientation_of(corner(0), p, apex) > 0;
  }

  // Mean-value coordinates in space, used in the plane.
  Plane_point mean_of_ring() const
  {
    const Point& v = m_disc.points[m_removal.vertex];
    std::vector<double> weight(m_ring.size(), 0);
    for (std::size_t i = 0; i < number_of_faces(); ++i)
    {
      const std::size_t j = (i + 1) % m_ring.size();
      const Point a = m_disc.points[m_ring[i]] - v, b = m_disc.points[m_ring[j]] - v;
      const double half = std::atan2(norm(meridian::cross(a, b)), dot(a, b)) / 2, t = std::min(std::tan(half), 1e3);
      weight[i] += t / std::max(norm(a), 1e-4 * m_mean);
      weight[j] += t / std::max(norm(b), 1e-4 * m_mean);
    }
    Plane_point sum{0, 0};
    double whole = 0;
    for (std::size_t i = 0; i < m_ring.size(); ++i)
    {
      sum = sum + weight[i] * corner(i);
      whole += weight[i];
    }
    return (1 / whole) * sum;
  }

  // The part of the polygon that is to the left of all its sides.
  std::vector<Plane_point> find_kernel() const
  {
    std::vector<Plane_point> kernel, next;
    for (std::size_t i = 0; i < m_ring.size(); ++i) { kernel.push_back(corner(i)); }
    for (std::size_t i = 0; i < m_ring.size() && kernel.size() > 2; ++i)
    {
      const Plane_point from = corner(i), along = corner(i + 1) - from;
      next.clear();
      for (std::size_t k = 0; k < kernel.size(); ++k)
      {
        const Plane_point &a = kernel[k], &b = kernel[(k + 1) % kernel.size()];
        const double x = meridian::cross(along, a - from), y = meridian::cross(along, b - from);
        if (x >= 0) { next.push_back(a); }
        if ((x > 0 && y < 0) || (x < 0 && y > 0)) { next.push_back(a + (x / (x - y)) * (b - a)); }
      }
      kernel.swap(next);
    }
    return kernel;
  }

  // Goes from the middle of that part to where the vertex was moved to, up to a point that is inside beyond rounding.
  bool find_inside(Plane_point& p) const
  {
    constexpr int most_tries = 40;
    const std::vector<Plane_point> kernel = find_kernel();
    Plane_point middle{0, 0};
    for (const Plane_point& q : kernel) { middle = middle + (1. / static_cast<double>(kernel.size())) * q; }
    const Plane_point& base = m_at[m_removal.into];
    double part = 1;
    for (int tries = 0; tries < most_tries && !kernel.empty(); ++tries, part /= 2)
    {
      p = base + part * (middle - base);
      if (is_inside(p)) { return true; }
    }
    return false;
  }

  // A few of Newton's steps, for this vertex alone.
  void improve(Plane_point& p)
  {
    const Index v = m_removal.vertex;
    std::vector<Rest_triangle> rest;
    for (std::size_t i = 0; i < number_of_faces(); ++i)
    {
      rest.push_back(rest_triangle(m_disc, {v, m_ring[i], m_ring[(i + 1) % m_ring.size()]}, 1e-4 * m_mean));
      for (Plane_point& g : rest.back().gradients) { g = m_scale * g; }
    }
    const auto energy = [&](const Plane_point& q) {
      m_at[v] = q;
      double sum = 0;
      for (const Rest_triangle& t : rest) { sum += t.weight * symmetric_dirichlet_energy(gradient_of(t, m_at)); }
      return sum;
    };
    const auto for_each = [&](const auto& f) {
      for (const Rest_triangle& t : rest)
      {
        f(t, static_cast<int>(std::find(t.corners.begin(), t.corners.end(), v) - t.corners.begin()));
      }
    };
    double now = energy(p);
    for (int steps = m_removal.is_border ? 8 : 3; steps > 0; --steps)
    {
      Plane_point move;
      m_at[v] = p;
      if (!find_local_direction(for_each, m_at, move)) { return; }
      double length = 1, then = now;
      const auto is_better = [&] {
        then = energy(p + length * move);
        return then < now && is_inside(p + length * move);
      };
      while (length > 0.01 && !is_better()) { length /= 2; }
      if (length <= 0.01) { return; }
      p = p + length * move;
      if (then > 0.99 * now) { return; }
      now = then;
    }
  }

  const Triangle_surface& m_disc;
  const Disc_hierarchy& m_levels;
  std::vector<Plane_point>& m_at; // of each vertex, and of a box around the border
  double m_scale = 1, m_mean = 0;
  std::vector<Plane_point> m_apex; // of the side that begins at each vertex of the border, of its triangle outside
  Disc_hierarchy::Removal m_removal{};
  std::vector<Index> m_ring;
};

} // namespace

void lower_distortion(const Triangle_surface& s, std::vector<Plane_point>& at, const Distortion_options& options,
                      bool is_near, const Progress& progress)
{
  Distortion_minimizer minimizer(s, at, options, is_near);
  constexpr int few = 4;
  constexpr double coarsely = 1e-3;
  const double little = std::min(coarsely, options.least_gain); // to be gained by a step, on average of a few
  std::array<double, few> gained;                               // by the last of them
  gained.fill(1);
  try
  {
    for (int i = 0; i < options.iterations; ++i)
    {
      if (progress) { progress(static_cast<double>(i) / options.iterations); }
      if (minimizer.step() < options.least_gain) { return; }
      gained[i % few] = minimizer.gained();
      if (std::accumulate(gained.begin(), gained.end(), 0.) < few * little) { return; }
    }
  }
  catch (const Solver_error&)
  {}
}

std::vector<Plane_point> map_by_levels(const Triangle_surface& disc, const Distortion_options& options,
                                       const Progress& progress)
{
  constexpr Index few = 8000, least = 15000; // vertices of the coarsest level, and of what is worth it
  constexpr int near_steps = 40;             // at most, from a map that is near
  constexpr int far_steps = 10;              // times as many on the coarsest level, where they cost little
  constexpr double coarse_gain = 5e-3;       // of a step, before a finer level is begun
  if (disc.number_of_vertices() < least) { return {}; }
  const Disc_hierarchy levels(disc, few);
  const std::size_t n = levels.number_of_levels();
  if (n < 2) { return {}; }
  std::vector<Plane_point> at(static_cast<std::size_t>(disc.number_of_vertices()) + 4), part;
  Vertex_placer placer(disc, levels, at);
  for (std::size_t l = n; l-- > 0;)
  {
    const Level_surface level = surface_of(disc, levels.triangles(l));
    const Triangle_surface& s = level.surface;
    const auto loop = boundary_loops(s).front();
    if (l + 1 == n)
    {
      part = map_with_low_stretch(s, loop, place_on_circle(places_along(s, loop)), 3, options.make_solver);
    }
    else
    {
      bool has_room = true;
      levels.for_each_removal(l, [&](const Disc_hierarchy::Removal& r) { has_room = has_room && placer.place(r); });
      if (!has_room) { return {}; }
      part.clear();
      for (Index v : level.vertex) { part.push_back(at[v]); }
    }
    if (!is_one_to_one(s, part)) { return {}; }
    Distortion_options here = options;
    here.iterations = l + 1 < n ? std::min(options.iterations, near_steps) : far_steps * options.iterations;
    if (l > 0) { here.least_gain = std::max(options.least_gain, coarse_gain); }
    lower_distortion(s, part, here, l + 1 < n, [&](double done) {
      if (progress) { progress((static_cast<double>(n - 1 - l) + done) / static_cast<double>(n)); }
    });
    if (l == 0) { break; }
    std::vector<Index> border;
    for (std::size_t i = 0; i < part.size(); ++i) { at[level.vertex[i]] = part[i]; }
    for (Index h : loop) { border.push_back(level.vertex[s.source(h)]); }
    placer.begin(border, std::sqrt(area(s) / area_of(s.triangles, part)));
  }
  return part;
}

} // namespace internal

} // namespace meridian
