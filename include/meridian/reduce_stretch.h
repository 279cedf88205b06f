// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_REDUCE_STRETCH_H
#define MERIDIAN_REDUCE_STRETCH_H

#include <meridian/convex_map.h>
#include <meridian/distortion.h>
#include <meridian/edge_weights.h>

namespace meridian {
namespace internal {

// How much longer edges are on the surface than in the plane, averaged at each vertex over the area of its faces. Finite on every map.
inline std::vector<double> stretch_at_vertices(const Triangle_surface& disc, const std::vector<Plane_point>& at)
{
  double size = 0, image = 0;
  for (Index h = 0; h < disc.number_of_halfedges(); ++h)
  {
    const Plane_point d = at[disc.target(h)] - at[disc.source(h)];
    size += dot(disc.points[disc.target(h)] - disc.points[disc.source(h)], disc.points[disc.target(h)] - disc.points[disc.source(h)]);
    image += dot(d, d);
  }
  size /= std::max<Index>(disc.number_of_halfedges(), 1);
  image /= std::max<Index>(disc.number_of_halfedges(), 1);
  std::vector<double> sum(disc.number_of_vertices(), 0), area(disc.number_of_vertices(), 0);
  for (Index f = 0; f < disc.number_of_faces(); ++f)
  {
    const auto& t = disc.triangles[f];
    double there = 1e-20 * size, here = 1e-24 * image;
    for (int k = 0; k < 3; ++k)
    {
      const Point e = disc.points[t[(k + 1) % 3]] - disc.points[t[k]];
      const Plane_point d = at[t[(k + 1) % 3]] - at[t[k]];
      there += dot(e, e);
      here += dot(d, d);
    }
    const double weight = norm(cross(disc.points[t[1]] - disc.points[t[0]], disc.points[t[2]] - disc.points[t[0]])) + 1e-6 * size;
    for (Index v : t)
    {
      sum[v] += weight * (here > 0 ? std::sqrt(there / here) : 1);
      area[v] += weight;
    }
  }
  for (std::size_t v = 0; v < sum.size(); ++v) { sum[v] = area[v] > 0 && sum[v] > 0 ? sum[v] / area[v] : 1; }
  return sum;
}

} // namespace internal

/*!
 * \ingroup PkgMeridianParameterization
 *
 * maps a disc into a convex polygon with low stretch, so that no part of the surface becomes small.
 *
 * It begins with positive weights. The weight of every edge is then divided by the geometric mean of the stretch at its ends, a symmetric
 * form of the step of Yoshizawa, Belyaev and Seidel (2004), and the disc mapped again. A step that raises the L2 stretch, or turns a face over,
 * is taken back and halved. If no map without flipped faces is found so, equal weights are tried.
 *
 * \tparam SymmetricTraits a model of CGAL's `SparseLinearAlgebraWithFactorTraits_d`
 * \param disc the surface
 * \param loop its boundary, as halfedges
 * \param border the image of each halfedge's source, on a convex polygon, counterclockwise
 * \param steps how often weights are changed at most
 *
 * \returns the image of each vertex: of the maps without flipped faces that of the least L2 stretch; if there is none, that with the fewest
 * \pre no interior edge joins two points of one side of the polygon
 * \throws Solver_error if neither the positive nor the equal weights give a system that can be solved
 * \par Complexity
 * One factorization a step.
 */
template <class SymmetricTraits = Symmetric_solver_traits>
std::vector<Plane_point> map_with_low_stretch(const Triangle_surface& disc, const std::vector<Index>& loop, const std::vector<Plane_point>& border,
                                              int steps = 10)
{
  struct State { std::vector<Plane_point> at; std::size_t flips; double stretch; };
  const auto judge = [&](std::vector<Plane_point> at) {
    const std::size_t flips = find_flipped_faces(disc.triangles, at).size();
    const double stretch = flips > 0 ? 0 : measure_distortion(disc.points, disc.triangles, at, measure_faces(disc.points, disc.triangles, at)).stretch_l2;
    return State{std::move(at), flips, stretch};
  };
  const auto is_better = [](const State& a, const State& b) { return a.flips != b.flips ? a.flips < b.flips : a.stretch < b.stretch; };
  // The best map that comes of some weights.
  const auto improve = [&](std::vector<double> weights) {
    State best = judge(map_into_polygon<SymmetricTraits>(disc, weights, loop, border)), last = best;
    double power = 1;
    for (int i = 0; i < steps && power > 0.2; ++i)
    {
      const auto stretch = internal::stretch_at_vertices(disc, last.at);
      std::vector<double> next = weights;
      double largest = 0;
      for (Index h = 0; h < disc.number_of_halfedges(); ++h)
      {
        next[h] /= std::pow(stretch[disc.source(h)] * stretch[disc.target(h)], power / 2);
        largest = std::max(largest, next[h]);
      }
      for (double& w : next) { w /= largest; }
      State now;
      try { now = judge(map_into_polygon<SymmetricTraits>(disc, next, loop, border)); }
      catch (const Solver_error&) { power /= 2; continue; }
      const bool goes_on = is_better(now, best) || best.flips > 0; // flips may pass: the stretch shows where an image is too small
      if (is_better(now, best)) { best = now; }
      if (!goes_on) { power /= 2; continue; }
      weights = std::move(next);
      last = std::move(now);
    }
    return best;
  };

  State best{{}, static_cast<std::size_t>(-1), 0};
  for (const bool is_equal : {false, true})
  {
    std::vector<double> weights(disc.number_of_halfedges(), 1);
    if (!is_equal) { weights = edge_weights(disc, Weights::POSITIVE); }
    try
    {
      State found = improve(weights);
      if (is_better(found, best)) { best = std::move(found); }
    }
    catch (const Solver_error&) { if (is_equal && best.at.empty()) { throw; } }
    if (best.flips == 0) { break; }
  }
  return std::move(best.at);
}

} // namespace meridian

#endif // MERIDIAN_REDUCE_STRETCH_H
