// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MAP_MAP_INTO_POLYGON_H
#define MERIDIAN_MAP_MAP_INTO_POLYGON_H

#include <meridian/field/Laplace_system.h>
#include <meridian/field/Sparse_solver.h>
#include <meridian/map/planar_map.h>
#include <meridian/surface/Closed_model.h>

namespace meridian {

/// \ingroup PkgMeridianParameterization
/// \returns for each halfedge of a boundary loop where along the loop it begins, from 0 to 1: half by length and half
///          by number, so that edges without length have a place too
inline std::vector<double> places_along(const Triangle_surface& s, const std::vector<Index>& loop)
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

/// \ingroup PkgMeridianParameterization
/// \returns points on the unit circle at the given places
inline std::vector<Plane_point> place_on_circle(const std::vector<double>& places)
{
  std::vector<Plane_point> points;
  for (double p : places) { points.push_back({std::cos(2 * std::acos(-1.) * p), std::sin(2 * std::acos(-1.) * p)}); }
  return points;
}

/*!
 * \ingroup PkgMeridianParameterization
 *
 * maps a disc into a convex polygon so that every inner vertex is the average of its neighbours (Tutte 1963; Floater
 * 1997).
 *
 * With positive weights and no chord that joins two points of one side of the polygon, no face is turned over in exact
 * arithmetic.
 *
 * \param disc the surface
 * \param weights one for each halfedge, equal on twins, positive
 * \param loop the boundary, as halfedges
 * \param border the image of each halfedge's source
 *
 * \returns the image of each vertex
 * \throws Solver_error if the system cannot be factorized
 * \par Complexity
 * One factorization.
 */
inline std::vector<Plane_point> map_into_polygon(const Triangle_surface& disc, const std::vector<double>& weights,
                                          const std::vector<Index>& loop, const std::vector<Plane_point>& border, Make_solver make_solver = make_symmetric_solver)
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
  g.begin.assign(n + 1, 0);
  for (Index h = 0; h < disc.number_of_halfedges(); ++h) { ++g.begin[disc.source(h) + 1]; }
  for (Index v = 0; v < n; ++v) { g.begin[v + 1] += g.begin[v]; }
  g.halfedge.resize(g.begin.back());
  g.neighbor.resize(g.begin.back());
  std::vector<Index> fill(g.begin.begin(), g.begin.end() - 1), inner;
  for (Index h = 0; h < disc.number_of_halfedges(); ++h)
  {
    const Index i = fill[disc.source(h)]++;
    g.halfedge[i] = h;
    g.neighbor[i] = disc.target(h);
  }
  for (Index v = 0; v < n; ++v)
  {
    if (!is_border[v]) { inner.push_back(v); }
  }
  internal::Laplace_system system(g, weights, make_solver);
  system.solve(
    inner, 2, [&](Index v, double* value) { std::copy(at[v].begin(), at[v].end(), value); }, [&](Index v, int i, double x) { at[v][i] = x; });
  return at;
}

} // namespace meridian

#endif // MERIDIAN_MAP_MAP_INTO_POLYGON_H
