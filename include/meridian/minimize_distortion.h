// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MINIMIZE_DISTORTION_H
#define MERIDIAN_MINIMIZE_DISTORTION_H

#include <meridian/internal/dirichlet_energy.h>
#include <meridian/internal/scaffold.h>
#include <meridian/solver_traits.h>

#include <CGAL/Polygon_2_algorithms.h>

#include <functional>

namespace meridian {

/// \ingroup PkgMeridianParameterization
/// when `minimize_distortion()` ends.
struct Distortion_options
{
  int iterations = 60;                         ///< at most
  double least_gain = 2e-4;                    ///< it ends when a step lowers the energy by a smaller part
  std::function<void(double)> progress = {};   ///< receives the part done; may throw to cancel
};

namespace internal {

// The shapes that faces should have in the plane: their own, if they have one. Faces that are all but degenerate are made a little higher.
inline std::vector<Rest_triangle> rest_triangles(const Triangle_surface& s)
{
  double mean = 0;
  for (Index h = 0; h < s.number_of_halfedges(); ++h) { mean += s.length(h) / std::max<Index>(s.number_of_halfedges(), 1); }
  if (!(mean > 0)) { mean = 1; }
  std::vector<Rest_triangle> rest;
  for (Index f = 0; f < s.number_of_faces(); ++f)
  {
    Index base = 3 * f;
    for (Index h = 3 * f; h < 3 * f + 3; ++h) { if (s.length(h) > s.length(base)) { base = h; } }
    const double longest = s.length(base), b = std::max(longest, 1e-4 * mean);
    const Point e = s.points[s.target(base)] - s.points[s.source(base)], d = s.points[s.apex(base)] - s.points[s.source(base)];
    const double x = longest > 0 ? std::min(std::max(dot(e, d) / longest, 0.), b) : b / 2;
    const double y = std::max(longest > 0 ? norm(meridian::cross(e, d)) / longest : 0, 1e-3 * b);
    rest.push_back(make_rest_triangle({s.source(base), s.target(base), s.apex(base)}, b, x, y));
  }
  return rest;
}

// A triangle that should keep the shape it has.
inline Rest_triangle rest_as_is(const std::array<Index, 3>& t, const std::vector<Plane_point>& at)
{
  const Plane_point e = at[t[1]] - at[t[0]], d = at[t[2]] - at[t[0]];
  const double b = norm(e);
  Rest_triangle r = make_rest_triangle(t, b, dot(e, d) / b, cross(e, d) / b);
  for (Plane_point& g : r.gradients) { g = {(g[0] * e[0] - g[1] * e[1]) / b, (g[0] * e[1] + g[1] * e[0]) / b}; }
  return r;
}

template <class SymmetricTraits>
class Distortion_minimizer
{
public:
  Distortion_minimizer(const Triangle_surface& disc, std::vector<Plane_point>& at)
    : m_disc(disc), m_at(at), m_rest(rest_triangles(disc)), m_size(at.size())
  {
    const auto loops = boundary_loops(disc);
    for (Index h : loops.front()) { m_loop.push_back(disc.source(h)); }
    for (const Rest_triangle& t : m_rest) { m_area += t.weight; }
    scale();
  }

  // One step of Newton's method. Returns the energy before it.
  double step(double& gain)
  {
    std::vector<Rest_triangle> ring;
    const auto triangles = triangulate_outside(m_loop, m_at); // appends the corners of the box
    double outside = 0;
    for (const auto& t : triangles)
    {
      ring.push_back(rest_as_is(t, m_at));
      outside += ring.back().weight;
    }
    for (Rest_triangle& t : ring) { t.weight = lambda * m_area / (double)ring.size(); }
    std::vector<const Rest_triangle*> all;
    for (const auto* list : {static_cast<const std::vector<Rest_triangle>*>(&m_rest), static_cast<const std::vector<Rest_triangle>*>(&ring)})
      for (const Rest_triangle& t : *list) { all.push_back(&t); }

    const std::size_t n = m_size;
    typename SymmetricTraits::Matrix hessian(2 * n);
    typename SymmetricTraits::Vector right(2 * n), solution(2 * n);
    for (std::size_t i = 0; i < 2 * n; ++i) { right[i] = 0; }
    double before = 0, trace = 0;
    for (const Rest_triangle* t : all)
    {
      const Map_gradient j = gradient_of(*t, m_at);
      before += t->weight * symmetric_dirichlet_energy(j);
      const Energy_derivatives d = derive_energy(*t, j);
      std::array<Index, 6> row;
      for (int k = 0; k < 6; ++k) { row[k] = 2 * t->corners[k / 2] + k % 2; }
      for (int k = 0; k < 6; ++k)
      {
        if (t->corners[k / 2] >= static_cast<Index>(n)) { continue; }
        right[row[k]] -= t->weight * d.gradient[k];
        for (int l = 0; l < 6; ++l)
        {
          if (row[l] > row[k] || t->corners[l / 2] >= static_cast<Index>(n)) { continue; }
          double entry = 0;
          for (const Hessian_mode& mode : d.modes) { entry += mode.lambda * mode.q[k] * mode.q[l]; }
          hessian.add_coef(row[k], row[l], t->weight * entry);
          if (k == l) { trace += t->weight * entry; }
        }
      }
    }
    for (std::size_t i = 0; i < 2 * n; ++i) { hessian.add_coef(i, i, 1e-12 * trace / static_cast<double>(2 * n)); }
    SymmetricTraits solver;
    double denominator = 1;
    if (!solver.factor(hessian, denominator) || !solver.linear_solver(right, solution))
      throw Solver_error("the system of " + std::to_string(2 * n) + " equations for a map of low distortion cannot be factorized");
    std::vector<Plane_point> move(m_at.size(), {0, 0});
    double slope = 0;
    for (std::size_t i = 0; i < n; ++i)
    {
      move[i] = {solution[2 * i] / denominator, solution[2 * i + 1] / denominator};
      slope -= move[i][0] * right[2 * i] + move[i][1] * right[2 * i + 1];
    }

    double length = 1, limit = 1;
    for (const Rest_triangle& t : m_rest) { length = std::min(length, step_to_collapse(t, m_at, move)); }
    if (length < 1) length *= 0.9;
    for (const Rest_triangle& t : ring) { limit = std::min(limit, 0.9 * step_to_collapse(t, m_at, move)); }
    limit = std::min(limit, length);
    gain = 0;
    double inside = 0;
    for (const Rest_triangle& t : m_rest) { inside += t.weight * symmetric_dirichlet_energy(gradient_of(t, m_at)); }
    std::vector<Plane_point> next = m_at;
    tries = 0;
    for (bool last = false; tries < 80; ++tries, length /= 2)
    {
      if (length < limit && !last) { length = limit; last = true; }
      for (std::size_t i = 0; i < n; ++i) { next[i] = m_at[i] + length * move[i]; }
      double after = 0;
      for (const Rest_triangle& t : m_rest) { after += t.weight * symmetric_dirichlet_energy(gradient_of(t, next)); }
      if (!(after < inside)) { continue; }
      const auto is_turned = [&](const Rest_triangle& t) { return orientation_of(next[t.corners[0]], next[t.corners[1]], next[t.corners[2]]) <= 0; };
      if (std::any_of(m_rest.begin(), m_rest.end(), is_turned)) { continue; }
      std::vector<CGAL::Exact_predicates_inexact_constructions_kernel::Point_2> polygon;
      for (Index v : m_loop) { polygon.emplace_back(next[v][0], next[v][1]); }
      if (!CGAL::is_simple_2(polygon.begin(), polygon.end())) { continue; }
      gain = (inside - after) / inside;
      m_at.swap(next);
      break;
    }
    if (length < 0.4) { lambda = std::min(lambda * 8, 1e2); } if (length > 0.8) { lambda = std::max(lambda / 2, 1e-6); }
    before = inside; m_predicted = -slope / inside;
    m_at.resize(n);
    m_length = length;
    return before;
  }

  // Gives the image the area of the surface, about the origin.
  void scale()
  {
    double area = 0;
    for (const Rest_triangle& t : m_rest) { area += cross(m_at[t.corners[1]] - m_at[t.corners[0]], m_at[t.corners[2]] - m_at[t.corners[0]]) / 2; }
    const double factor = std::sqrt(m_area / area);
    for (Plane_point& p : m_at) { p = factor * p; }
  }
  double m_length = 0, m_predicted = 0, lambda = 1e-2; int tries = 0;
  double m_area = 0;
private:
  const Triangle_surface& m_disc;
  std::vector<Plane_point>& m_at;
  std::vector<Rest_triangle> m_rest;
  std::size_t m_size;
  std::vector<Index> m_loop;
};

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_MINIMIZE_DISTORTION_H
