// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/map/map_with_low_stretch.h>

#include <meridian/base/exceptions.h>
#include <meridian/field/edge_weights.h>
#include <meridian/map/distortion.h>
#include <meridian/map/map_into_polygon.h>
#include <meridian/map/planar_map.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace meridian {

namespace {

// More than this no face counts: a few slivers that the map makes ever so thin must not decide about all others.
constexpr double largest_stretch = 1000;

double area_of_face(const Triangle_surface& s, std::size_t f)
{
  const auto& t = s.triangles[f];
  return norm(cross(s.points[t[1]] - s.points[t[0]], s.points[t[2]] - s.points[t[0]])) / 2;
}

// The L2 stretch around each vertex: root of the mean square over its faces, by area.
std::vector<double> stretch_at_vertices(const Triangle_surface& disc, const std::vector<Face_distortion>& faces)
{
  std::vector<double> sum(disc.number_of_vertices(), 0), area(disc.number_of_vertices(), 0);
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    const double a = area_of_face(disc, f), stretch = std::min(faces[f].stretch_l2, largest_stretch);
    for (Index v : disc.triangles[f])
    {
      sum[v] += a * stretch * stretch;
      area[v] += a;
    }
  }
  for (std::size_t v = 0; v < sum.size(); ++v) { sum[v] = area[v] > 0 && sum[v] > 0 ? std::sqrt(sum[v] / area[v]) : 1; }
  return sum;
}

// How much longer edges are on the surface than in the plane, averaged at each vertex over the area of its faces.
// Finite on every map, and larger the more of it lies in one point.
std::vector<double> edge_stretch_at_vertices(const Triangle_surface& disc, const std::vector<Plane_point>& at)
{
  double size = 0, image = 0;
  for (Index h = 0; h < disc.number_of_halfedges(); ++h)
  {
    const Plane_point d = at[disc.target(h)] - at[disc.source(h)];
    size += dot(disc.points[disc.target(h)] - disc.points[disc.source(h)],
                disc.points[disc.target(h)] - disc.points[disc.source(h)]);
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
    const double weight =
      norm(cross(disc.points[t[1]] - disc.points[t[0]], disc.points[t[2]] - disc.points[t[0]])) + 1e-6 * size;
    for (Index v : t)
    {
      sum[v] += weight * (here > 0 ? std::sqrt(there / here) : 1);
      area[v] += weight;
    }
  }
  for (std::size_t v = 0; v < sum.size(); ++v) { sum[v] = area[v] > 0 && sum[v] > 0 ? sum[v] / area[v] : 1; }
  return sum;
}

// A map on the way.
struct Stretched_map
{
  std::vector<Plane_point> at;
  std::vector<Face_distortion> faces;
  std::size_t flips = 0;
  double stretch = 0; // mean square, by area

  bool is_better_than(const Stretched_map& other) const
  {
    return flips != other.flips ? flips < other.flips : stretch < other.stretch;
  }
};

Stretched_map judge_map(const Triangle_surface& disc, std::vector<Plane_point> at)
{
  Stretched_map m;
  m.at = std::move(at);
  m.faces = measure_faces(disc.points, disc.triangles, m.at);
  m.flips = find_flipped_faces(disc.triangles, m.at).size();
  double area = 0;
  for (std::size_t f = 0; f < m.faces.size(); ++f)
  {
    const double a = area_of_face(disc, f), stretch = std::min(m.faces[f].stretch_l2, largest_stretch);
    area += a;
    m.stretch += a * stretch * stretch;
  }
  m.stretch /= area > 0 ? area : 1;
  return m;
}

// The best map that comes of some weights.
Stretched_map lower_stretch(const Triangle_surface& disc, std::vector<double> weights, const std::vector<Index>& loop,
                            const std::vector<Plane_point>& border, int steps, Make_solver make_solver)
{
  Stretched_map best = judge_map(disc, map_into_polygon(disc, weights, loop, border, make_solver)), last = best;
  double power = 1;
  for (int i = 0; (i < steps || (best.flips > 0 && i < 8)) && power > 0.2; ++i)
  {
    const auto stretch =
      last.flips > 0 ? edge_stretch_at_vertices(disc, last.at) : stretch_at_vertices(disc, last.faces);
    std::vector<double> next = weights;
    double largest = 0;
    for (Index h = 0; h < disc.number_of_halfedges(); ++h)
    {
      next[h] /= std::pow(stretch[disc.source(h)] * stretch[disc.target(h)], power / 2);
      largest = std::max(largest, next[h]);
    }
    for (double& w : next) { w = std::max(w / largest, 1e-280); }
    Stretched_map now;
    try
    {
      now = judge_map(disc, map_into_polygon(disc, next, loop, border, make_solver));
    }
    catch (const Solver_error&)
    {
      power /= 2;
      continue;
    }
    const bool is_better = now.is_better_than(best);
    if (is_better) { best = now; }
    else if (best.flips == 0)
    {
      power /= 2;
      continue;
    } // flips may pass where the map goes on
    weights = std::move(next);
    last = std::move(now);
  }
  return best;
}

} // namespace

std::vector<Plane_point> map_with_low_stretch(const Triangle_surface& disc, const std::vector<Index>& loop,
                                              const std::vector<Plane_point>& border, int steps,
                                              Make_solver make_solver)
{
  Stretched_map best;
  for (const bool is_equal : {false, true})
  {
    std::vector<double> weights(disc.number_of_halfedges(), 1);
    if (!is_equal) { weights = edge_weights(disc, Weights::POSITIVE); }
    try
    {
      Stretched_map found = lower_stretch(disc, std::move(weights), loop, border, steps, make_solver);
      if (best.at.empty() || found.is_better_than(best)) { best = std::move(found); }
      if (best.flips == 0) { break; }
    }
    catch (const Solver_error&)
    {
      if (is_equal && best.at.empty()) { throw; }
    }
  }
  return std::move(best.at);
}

} // namespace meridian
