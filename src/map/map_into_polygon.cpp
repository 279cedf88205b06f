// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/map/map_into_polygon.h>

#include <meridian/base/group_by.h>
#include <meridian/field/Laplace_system.h>
#include <meridian/surface/Closed_model.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace meridian {

std::vector<double> places_along(const Triangle_surface& s, const std::vector<Index>& loop)
{
  double whole = 0;
  for (Index h : loop) { whole += s.length(h); }
  const double size = static_cast<double>(loop.size());
  std::vector<double> places;
  double along = 0;
  for (Index h : loop)
  {
    places.push_back(along);
    along += 0.5 / size + (whole > 0 ? 0.5 * s.length(h) / whole : 0.5 / size);
  }
  return places;
}

std::vector<Plane_point> place_on_circle(const std::vector<double>& places)
{
  std::vector<Plane_point> points;
  for (double p : places) { points.push_back({std::cos(2 * std::acos(-1.) * p), std::sin(2 * std::acos(-1.) * p)}); }
  return points;
}

std::vector<Plane_point> map_into_polygon(const Triangle_surface& disc, const std::vector<double>& weights,
                                          const std::vector<Index>& loop, const std::vector<Plane_point>& border,
                                          Make_solver make_solver)
{
  const Index n = disc.number_of_vertices();
  std::vector<Plane_point> at(n, {0, 0});
  std::vector<char> is_border(n, 0);
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    at[disc.source(loop[i])] = border[i];
    is_border[disc.source(loop[i])] = 1;
  }
  Closed_model g; // the vertices themselves: nothing is shrunk here
  g.number_of_nodes = n;
  Groups leaving = group_by(n, disc.number_of_halfedges(), [&](Index h) { return disc.source(h); });
  g.begin = std::move(leaving.begin);
  g.halfedge = std::move(leaving.element);
  for (Index h : g.halfedge) { g.neighbor.push_back(disc.target(h)); }
  std::vector<Index> inner;
  for (Index v = 0; v < n; ++v)
  {
    if (!is_border[v]) { inner.push_back(v); }
  }
  internal::Laplace_system system(g, weights, make_solver);
  system.solve(
    inner, 2, [&](Index v, double* value) { std::copy(at[v].begin(), at[v].end(), value); },
    [&](Index v, int i, double x) { at[v][i] = x; });
  return at;
}

} // namespace meridian
