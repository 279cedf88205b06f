// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/map/minimize_distortion.h>

#include <meridian/base/exceptions.h>
#include <meridian/map/constrained_triangulation.h>
#include <meridian/map/internal/relax_locally.h>
#include <meridian/map/is_one_to_one.h>
#include <meridian/map/planar_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace meridian {

namespace internal {

Rest_triangle rest_triangle(const Triangle_surface& s, const std::array<Index, 3>& t, double least)
{
  int k = 0; // where the longest side begins
  double longest = 0;
  for (int i = 0; i < 3; ++i)
  {
    const double length = distance(s.points[t[i]], s.points[t[(i + 1) % 3]]);
    if (length > longest)
    {
      longest = length;
      k = i;
    }
  }
  const std::array<Index, 3> corners{t[k], t[(k + 1) % 3], t[(k + 2) % 3]};
  const double b = std::max(longest, least);
  const Point e = s.points[corners[1]] - s.points[corners[0]], d = s.points[corners[2]] - s.points[corners[0]];
  const double x = longest > 0 ? std::min(std::max(dot(e, d) / longest, 0.), b) : b / 2;
  const double y = std::max(longest > 0 ? norm(meridian::cross(e, d)) / longest : 0, 1e-3 * b);
  return make_rest_triangle(corners, b, x, y);
}

std::vector<Rest_triangle> rest_triangles(const Triangle_surface& s)
{
  double mean = 0;
  for (Index h = 0; h < s.number_of_halfedges(); ++h) { mean += s.length(h) / s.number_of_halfedges(); }
  if (!(mean > 0)) { mean = 1; }
  std::vector<Rest_triangle> rest;
  rest.reserve(s.number_of_faces());
  for (const auto& t : s.triangles) { rest.push_back(rest_triangle(s, t, 1e-4 * mean)); }
  return rest;
}

namespace {

// A triangle that should keep the shape it has.
Rest_triangle rest_as_is(const std::array<Index, 3>& t, const std::vector<Plane_point>& at)
{
  const Plane_point e = at[t[1]] - at[t[0]], d = at[t[2]] - at[t[0]];
  const double b = norm(e);
  Rest_triangle r = make_rest_triangle(t, b, dot(e, d) / b, cross(e, d) / b);
  for (Plane_point& g : r.gradients) { g = {(g[0] * e[0] - g[1] * e[1]) / b, (g[0] * e[1] + g[1] * e[0]) / b}; }
  return r;
}

// The number of each vertex among those that move, or -1; four more are around it all, and stay.
std::vector<Index> number_what_moves(const Triangle_surface& disc, bool has_free_border)
{
  std::vector<Index> row(static_cast<std::size_t>(disc.number_of_vertices()) + 4, -1);
  Index rows = 0;
  for (Index v = 0; v < disc.number_of_vertices(); ++v)
  {
    if (has_free_border || !disc.is_boundary_vertex(v)) { row[v] = rows++; }
  }
  return row;
}

} // namespace

Distortion_minimizer::Distortion_minimizer(const Triangle_surface& disc, std::vector<Plane_point>& at,
                                           const Distortion_options& options, bool is_near)
  : m_at(at), m_solver(options.make_solver()), m_energy(options.energy), m_has_free_border(options.has_free_border),
    m_faces(rest_triangles(disc)), m_hessian(number_what_moves(disc, options.has_free_border)), m_pins(options.pins),
    m_stiffness(options.stiffness), m_is_near(is_near), m_resistance(is_near ? 0.001 : 0.01)
{
  for (Index v = 0; v < static_cast<Index>(at.size()) + 4; ++v) { m_may_move.push_back(m_hessian.unknown(v) >= 0); }
  const auto loops = boundary_loops(disc);
  for (Index h : loops.front()) { m_loop.push_back(disc.source(h)); }
  double image = 0;
  for (const Rest_triangle& t : m_faces)
  {
    m_area += t.weight;
    image += cross(m_at[t.corners[1]] - m_at[t.corners[0]], m_at[t.corners[2]] - m_at[t.corners[0]]) / 2;
  }
  m_stiffness *= m_area / image;
  // It is the surface that is scaled, so that a border that is fixed stays to the bit.
  const double scale = std::sqrt(m_area / image);
  m_is_roomy = m_has_free_border && is_roomy(m_loop, m_at);
  for (Rest_triangle& t : m_faces)
  {
    for (Plane_point& g : t.gradients) { g = scale * g; }
  }
}

void Distortion_minimizer::surround(std::vector<Plane_point>& with_box)
{
  with_box = m_at;
  m_outside.clear();
  if (!m_has_free_border) { return; }
  for (const auto& t : triangulate_outside(m_loop, with_box)) { m_outside.push_back(rest_as_is(t, with_box)); }
  for (Rest_triangle& t : m_outside) { t.weight = m_resistance * m_area / static_cast<double>(m_outside.size()); }
}

void Distortion_minimizer::relax(std::vector<Plane_point>& with_box)
{
  for (int rounds = m_is_first ? 3 : 1; rounds > 0; --rounds)
  {
    relax_locally(m_faces, m_outside, m_may_move, with_box);
    m_at.assign(with_box.begin(), with_box.begin() + m_at.size());
    surround(with_box);
  }
  m_is_first = false;
}

double Distortion_minimizer::step()
{
  if (m_hessian.number_of_unknowns() == 0) { return 0; }
  const std::size_t n = m_at.size();
  std::vector<Plane_point> with_box;
  surround(with_box);
  if (m_is_near && m_was_short) { relax(with_box); }
  std::vector<Plane_point> move(with_box.size(), {0, 0});
  const double slope = find_direction(with_box, move);
  m_gained = 0;
  const double before = energy(m_at), gain = -slope / before;
  if (!(gain > 0)) { return 0; }

  const auto before_collapse = [&](const std::vector<Rest_triangle>& triangles) {
    double length = 1;
    for (const Rest_triangle& t : triangles) { length = std::min(length, step_to_collapse(t, with_box, move)); }
    return length < 1 ? 0.9 * length : 1;
  };
  double length = before_collapse(m_faces);
  const double safe = std::min(length, before_collapse(m_outside)); // so far nothing outside is turned over
  std::vector<Plane_point> next(n);
  bool was_safe = false;
  for (int tries = 0; tries < 80; ++tries, length /= 2)
  {
    if (length < safe && !was_safe)
    {
      length = safe;
      was_safe = true;
    }
    for (std::size_t i = 0; i < n; ++i) { next[i] = m_at[i] + length * move[i]; }
    const auto is_turned = [&](const Rest_triangle& t) {
      return orientation_of(next[t.corners[0]], next[t.corners[1]], next[t.corners[2]]) <= 0;
    };
    if (!(energy(next) < before) || std::any_of(m_faces.begin(), m_faces.end(), is_turned)
        || (m_has_free_border && !(m_is_roomy ? is_roomy(m_loop, next) : is_simple(m_loop, next))))
    {
      continue;
    }
    m_gained = 1 - energy(next) / before;
    m_was_short = length < 0.8;
    m_at.swap(next);
    m_is_roomy = m_is_roomy || is_roomy(m_loop, m_at);
    if (length < 0.4) { m_resistance = std::min(8 * m_resistance, 100.); }
    if (length > 0.8) { m_resistance = std::max(m_resistance / 2, 1e-6); }
    return gain;
  }
  return 0;
}

double Distortion_minimizer::energy(const std::vector<Plane_point>& at) const
{
  double sum = 0;
  for (const Rest_triangle& t : m_faces) { sum += t.weight * energy_of(m_energy, gradient_of(t, at)); }
  for (const Map_pin& p : m_pins) { sum += m_stiffness * dot(at[p.vertex] - p.at, at[p.vertex] - p.at); }
  return sum;
}

void Distortion_minimizer::add_springs(const std::vector<Plane_point>& at)
{
  for (const Map_pin& p : m_pins)
  {
    if (m_hessian.unknown(p.vertex) < 0) { continue; }
    m_hessian.add_to_vertex(p.vertex, 2 * m_stiffness, 2 * m_stiffness * (p.at - at[p.vertex]));
  }
}

double Distortion_minimizer::find_direction(const std::vector<Plane_point>& at, std::vector<Plane_point>& move)
{
  m_hessian.reset(m_faces, m_outside);
  for (const Rest_triangle& t : m_faces) { m_hessian.add(t, derive_energy(t, gradient_of(t, at), m_energy)); }
  for (const Rest_triangle& t : m_outside) { m_hessian.add(t, derive_energy(t, gradient_of(t, at))); }
  add_springs(at);
  // A little is added to the diagonal, and more if rounding made the matrix indefinite.
  const Index unknowns = m_hessian.number_of_unknowns();
  double added = 1e-12 * m_hessian.trace() / unknowns;
  for (int tries = 0;; ++tries, added *= 100)
  {
    m_hessian.add_to_diagonal(added);
    if (m_solver->factor(m_hessian.matrix()) && m_solver->solve(m_hessian.downwards(), m_solution)) { break; }
    if (tries == 6)
      throw Solver_error(
        "the system of " + std::to_string(unknowns)
        + " equations for a map of low distortion cannot be factorized; a map into a circle needs less");
  }
  double slope = 0;
  for (std::size_t v = 0; v < m_at.size(); ++v)
  {
    const Index row = m_hessian.unknown(static_cast<Index>(v));
    if (row < 0) { continue; }
    move[v] = {m_solution[row], m_solution[row + 1]};
    slope -= move[v][0] * m_hessian.downwards()[row] + move[v][1] * m_hessian.downwards()[row + 1];
  }
  return slope;
}

} // namespace internal

void minimize_distortion(const Triangle_surface& disc, std::vector<Plane_point>& at, const Distortion_options& options,
                         const Progress& progress)
{
  internal::Distortion_minimizer minimizer(disc, at, options);
  for (int i = 0; i < options.iterations; ++i)
  {
    if (progress) { progress(static_cast<double>(i) / options.iterations); }
    if (minimizer.step() < options.least_gain) { return; }
  }
}

} // namespace meridian
