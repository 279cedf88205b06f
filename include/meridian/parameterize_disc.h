// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_PARAMETERIZE_DISC_H
#define MERIDIAN_PARAMETERIZE_DISC_H

#include <meridian/Parameterization.h>
#include <meridian/edge_weights.h>
#include <meridian/internal/cgal_maps.h>
#include <meridian/minimize_distortion.h>
#include <meridian/reduce_stretch.h>

#include <utility>

namespace meridian {

namespace internal {

// The corners of a square, which lie at the quarters of the border, and points along its sides between them.
inline std::vector<Plane_point> place_on_square(const std::vector<double>& places)
{
  std::vector<std::size_t> corner; // the points nearest to the quarters, all different
  for (int k = 0; k < 4; ++k)
  {
    std::size_t i = std::lower_bound(places.begin(), places.end(), 0.25 * k) - places.begin();
    if (i > 0 && (i == places.size() || 0.25 * k - places[i - 1] < places[i] - 0.25 * k)) { --i; }
    if (k > 0) { i = std::max(i, corner.back() + 1); }
    corner.push_back(std::min(i, places.size() - 4 + k));
  }
  constexpr std::array<Plane_point, 5> at{Plane_point{0, 0}, Plane_point{1, 0}, Plane_point{1, 1}, Plane_point{0, 1}, Plane_point{0, 0}};
  std::vector<Plane_point> points(places.size());
  for (int k = 0; k < 4; ++k)
  {
    const std::size_t first = corner[k], last = k < 3 ? corner[k + 1] : places.size();
    const double from = places[first], to = k < 3 ? places[last] : 1 + places[corner[0]];
    for (std::size_t i = first; i < last; ++i)
    {
      const double t = (places[i] - from) / (to - from);
      for (int d = 0; d < 2; ++d) { points[i][d] = at[k][d] == at[k + 1][d] ? at[k][d] : (1 - t) * at[k][d] + t * at[k + 1][d]; }
    }
  }
  return points;
}

template <class SymmetricTraits, class GeneralTraits>
std::string map_disc(const Triangle_surface& disc, Map_method method, const Map_options& options, std::vector<Plane_point>& at)
{
  if (method >= Map_method::MEAN_VALUE) { return map_with_cgal<GeneralTraits>(disc, method, options.in_square, at); }
  const auto loops = boundary_loops(disc);
  const auto& loop = loops.front();
  const bool in_square = options.in_square && method != Map_method::SYMMETRIC_DIRICHLET && loop.size() >= 4;
  const auto places = places_along(disc, loop);
  const auto border = in_square ? place_on_square(places) : place_on_circle(places);
  if (method == Map_method::POSITIVE)
  {
    at = map_into_polygon<SymmetricTraits>(disc, edge_weights(disc, Weights::POSITIVE), loop, border);
    return "";
  }
  at = map_with_low_stretch<SymmetricTraits>(disc, loop, border, method == Map_method::STRETCH ? 20 : 3);
  if (method == Map_method::STRETCH) { return ""; }
  std::vector<Index> polygon;
  for (Index h : loop) { polygon.push_back(disc.source(h)); }
  if (!find_flipped_faces(disc.triangles, at).empty() || !is_simple(polygon, at)) { return "double precision is not enough for the map into a circle that it begins with"; }
  Distortion_options distortion;
  distortion.progress = options.progress;
  minimize_distortion<SymmetricTraits>(disc, at, distortion);
  return "";
}

} // namespace internal

template <class SymmetricTraits, class GeneralTraits>
Parameterization parameterize_disc(const Triangle_surface& disc, const Map_options& options)
{
  std::vector<Map_method> methods{options.method};
  const auto add = [&](Map_method m) { if (std::find(methods.begin(), methods.end(), m) == methods.end()) { methods.push_back(m); } };
  if (has_free_border(options.method)) { add(Map_method::SYMMETRIC_DIRICHLET); }
  for (Map_method m : {Map_method::POSITIVE, Map_method::TUTTE, Map_method::STRETCH}) { add(m); }

  Parameterization best;
  bool has_map = false;
  for (Map_method method : methods)
  {
    std::vector<Plane_point> at;
    std::string reason;
    try
    {
      reason = internal::map_disc<SymmetricTraits, GeneralTraits>(disc, method, options, at);
    }
    catch (const Solver_error& e) { reason = e.what(); }
    if (!reason.empty())
    {
      best.attempts.push_back({method, -1, reason});
      continue;
    }
    auto flipped = find_flipped_faces(disc.triangles, at);
    best.attempts.push_back({method, static_cast<Index>(flipped.size()), ""});
    if (!has_map || flipped.size() < best.flipped.size())
    {
      best.at = std::move(at);
      best.method = method;
      best.flipped = std::move(flipped);
      has_map = true;
    }
    if (best.flipped.empty()) { break; }
  }
  if (!has_map) { throw Solver_error("the disc has no map into the plane: " + best.attempts.back().reason); }
  std::vector<Index> polygon;
  const auto loops = boundary_loops(disc);
  for (Index h : loops.front()) { polygon.push_back(disc.source(h)); }
  best.is_one_to_one = best.flipped.empty() && is_simple(polygon, best.at);
  best.faces = measure_faces(disc.points, disc.triangles, best.at);
  best.distortion = measure_distortion(disc.points, disc.triangles, best.at, best.faces);
  return best;
}

} // namespace meridian

#endif // MERIDIAN_PARAMETERIZE_DISC_H
