// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/map/parameterize_disc.h>

#include <meridian/base/Bounding_box.h>
#include <meridian/base/exceptions.h>
#include <meridian/base/vectors.h>
#include <meridian/field/edge_weights.h>
#include <meridian/map/distortion.h>
#include <meridian/map/internal/cgal_maps.h>
#include <meridian/map/internal/map_by_levels.h>
#include <meridian/map/is_one_to_one.h>
#include <meridian/map/map_into_polygon.h>
#include <meridian/map/map_with_low_stretch.h>
#include <meridian/map/minimize_distortion.h>
#include <meridian/map/planar_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace meridian {

namespace {

// Vertices of discs that are mapped without levels, and by one method after the other: of larger ones that takes
// minutes and hardly comes to a good end, while an extension of the cut helps.
constexpr Index most_at_once = 100000;

// The corners of a square, which lie at the quarters of the border, and points along its sides between them.
std::vector<Plane_point> place_on_square(const std::vector<double>& places)
{
  std::vector<std::size_t> corner; // the points nearest to the quarters, all different
  for (int k = 0; k < 4; ++k)
  {
    std::size_t i = std::lower_bound(places.begin(), places.end(), 0.25 * k) - places.begin();
    if (i > 0 && (i == places.size() || 0.25 * k - places[i - 1] < places[i] - 0.25 * k)) { --i; }
    if (k > 0) { i = std::max(i, corner.back() + 1); }
    corner.push_back(std::min(i, places.size() - 4 + k));
  }
  constexpr std::array<Plane_point, 5> at{Plane_point{0, 0}, Plane_point{1, 0}, Plane_point{1, 1}, Plane_point{0, 1},
                                          Plane_point{0, 0}};
  std::vector<Plane_point> points(places.size());
  for (int k = 0; k < 4; ++k)
  {
    const std::size_t first = corner[k], last = k < 3 ? corner[k + 1] : places.size();
    const double from = places[first], to = k < 3 ? places[last] : 1 + places[corner[0]];
    for (std::size_t i = first; i < last; ++i)
    {
      const double t = (places[i] - from) / (to - from);
      for (int d = 0; d < 2; ++d)
      {
        points[i][d] = at[k][d] == at[k + 1][d] ? at[k][d] : (1 - t) * at[k][d] + t * at[k + 1][d];
      }
    }
  }
  return points;
}

Distortion_options distortion_options(const Map_options& options, Distortion_energy energy, Map_border border)
{
  Distortion_options distortion;
  distortion.energy = energy;
  distortion.has_free_border = border == Map_border::FREE;
  distortion.make_solver = options.make_solver;
  distortion.least_gain = options.least_gain;
  return distortion;
}

// Lowers the distortion of angles of a map of low distortion.
void lower_angle_distortion(const Triangle_surface& disc, std::vector<Plane_point>& at, const Map_options& options,
                            Map_border border, const Progress& progress)
{
  try
  {
    minimize_distortion(disc, at, distortion_options(options, Distortion_energy::CONFORMAL, border), progress);
  }
  catch (const Solver_error&)
  {} // what was reached so far is a map
}

// Part `i` of two of what is to be done.
Progress half_of(const Progress& progress, int i)
{
  if (!progress) { return {}; }
  return [progress, i](double done) { progress((i + done) / 2); };
}

// Maps a disc by one method. Returns why there is no map, or nothing.
std::string map_disc(const Triangle_surface& disc, Map_method method, Map_border border, const Map_options& options,
                     const Progress& progress, std::vector<Plane_point>& at)
{
  if (method >= Map_method::MEAN_VALUE)
  {
    return internal::map_with_cgal(disc, method, border == Map_border::SQUARE, at);
  }
  if (method == Map_method::CONFORMAL)
  {
    std::string reason = map_disc(disc, Map_method::SYMMETRIC_DIRICHLET, border, options, half_of(progress, 0), at);
    if (reason.empty()) { lower_angle_distortion(disc, at, options, border, half_of(progress, 1)); }
    return reason;
  }
  const Distortion_options distortion = distortion_options(options, Distortion_energy::SYMMETRIC_DIRICHLET, border);
  if (method == Map_method::SYMMETRIC_DIRICHLET && border == Map_border::FREE)
  {
    at = internal::map_by_levels(disc, distortion, progress);
    if (!at.empty()) { return ""; }
    if (disc.number_of_vertices() > most_at_once)
    {
      return "double precision is not enough for a map into a circle that finer levels can be put into";
    }
  }
  const bool is_given = !options.polygon.empty() && border == Map_border::SQUARE;
  const auto loop = is_given ? options.loop : boundary_loops(disc).front();
  const auto places = places_along(disc, loop);
  const auto polygon = is_given                       ? options.polygon
                       : border == Map_border::SQUARE ? place_on_square(places)
                                                      : place_on_circle(places);
  if (method == Map_method::POSITIVE)
  {
    at = map_into_polygon(disc, edge_weights(disc, Weights::POSITIVE), loop, polygon, options.make_solver);
    return "";
  }
  at = map_with_low_stretch(disc, loop, polygon, method == Map_method::STRETCH ? 20 : 3, options.make_solver);
  if (method == Map_method::STRETCH) { return ""; }
  if (!is_one_to_one(disc, at))
  {
    return "double precision is not enough for the map into a convex polygon that it begins with";
  }
  try
  {
    minimize_distortion(disc, at, distortion, progress);
  }
  catch (const Solver_error&)
  {} // what was reached so far is a map
  return "";
}

// Moves a map into the unit square and rounds it to 50 bits, so that it fits wherever it is packed later.
void place_in_unit_square(std::vector<Plane_point>& at)
{
  Bounding_box<Plane_point> box(at.front());
  for (const Plane_point& p : at) { box.add(p); }
  const Plane_point low = box.low, extent = box.high - low;
  const double size = std::max(extent[0], extent[1]), grid = std::ldexp(1., 50);
  for (Plane_point& p : at)
    for (int k = 0; k < 2; ++k) { p[k] = size > 0 ? std::nearbyint((p[k] - low[k]) / size * grid) / grid : 0; }
}

// Counts and measures what there is to say of a map.
void measure(const Triangle_surface& disc, Parameterization& map)
{
  map.is_one_to_one = map.flipped.empty() && is_one_to_one(disc, map.at);
  map.faces = measure_faces(disc.points, disc.triangles, map.at);
  map.distortion = measure_distortion(disc.points, disc.triangles, map.at, map.faces);
}

// Into a circle, by nothing but what is joined to what: for lengths between which double precision cannot tell.
std::vector<Plane_point> map_without_lengths(const Triangle_surface& disc, const Make_solver& make_solver)
{
  const auto loop = boundary_loops(disc).front();
  std::vector<double> places;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    places.push_back(static_cast<double>(i) / static_cast<double>(loop.size()));
  }
  return map_into_polygon(disc, std::vector<double>(disc.number_of_halfedges(), 1), loop, place_on_circle(places),
                          make_solver);
}

// The best of the maps that are tried.
struct Best_map
{
  Parameterization map;
  bool overlaps = false; // where no face is flipped

  // Keeps a map if it is better than the one before. Returns whether the best is one-to-one.
  bool consider(const Triangle_surface& disc, Map_method method, Map_border border, std::vector<Plane_point> at)
  {
    place_in_unit_square(at);
    auto flipped = find_flipped_faces(disc.triangles, at);
    const bool meets_itself = flipped.empty() && !is_one_to_one(disc, at);
    map.attempts.push_back({method, border, static_cast<Index>(flipped.size()),
                            meets_itself ? "no face is flipped, but the border meets itself" : ""});
    if (map.at.empty() || flipped.size() < map.flipped.size() || (overlaps && flipped.empty() && !meets_itself))
    {
      overlaps = meets_itself;
      map.at = std::move(at);
      map.method = method;
      map.border = border;
      map.flipped = std::move(flipped);
    }
    return map.flipped.empty() && !overlaps;
  }

  Parameterization take(const Triangle_surface& disc)
  {
    if (map.at.empty()) { throw Solver_error("the disc has no map into the plane: " + map.attempts.back().reason); }
    measure(disc, map);
    return std::move(map);
  }
};

} // namespace

void check(const Map_options& o)
{
  const auto forbid = [](bool is_wrong, const std::string& message) {
    if (is_wrong) { throw Invalid_input_error(message); }
  };
  forbid(o.loop.size() != o.polygon.size(), "a polygon for the border goes with as many halfedges; "
                                              + std::to_string(o.polygon.size()) + " points and "
                                              + std::to_string(o.loop.size()) + " halfedges were given");
  forbid(!o.polygon.empty() && o.border != Map_border::SQUARE, "a polygon for the border takes the place of a square");
  forbid(!o.polygon.empty() && !takes_polygon(o.method),
         std::string("map method ") + name_of(o.method) + " cannot put the border on a polygon that is given");
}

Parameterization parameterize_disc(const Triangle_surface& disc, const Map_options& options, const Progress& progress)
{
  check(options);
  const bool is_small = boundary_loops(disc).front().size() < 4; // no square
  using Choice = std::pair<Map_method, Map_border>;
  std::vector<Choice> choices;
  const auto add = [&](Map_method m, Map_border border) {
    if (border == Map_border::FREE && !improves_maps(m)) { border = Map_border::CIRCLE; }
    if (border == Map_border::SQUARE && is_small) { border = Map_border::CIRCLE; }
    if (std::find(choices.begin(), choices.end(), Choice(m, border)) == choices.end())
    {
      choices.emplace_back(m, border);
    }
  };
  add(options.method, options.border);
  if (choices.front().second == Map_border::FREE) { add(Map_method::SYMMETRIC_DIRICHLET, Map_border::FREE); }
  for (Map_border border : {options.border, options.polygon.empty() ? Map_border::CIRCLE : options.border})
    for (Map_method m : {Map_method::POSITIVE, Map_method::TUTTE, Map_method::STRETCH}) { add(m, border); }

  Best_map best;
  bool is_enough = false, has_no_levels = false;
  for (const auto& [method, border] : choices)
  {
    std::vector<Plane_point> at;
    std::string reason;
    try
    {
      reason = map_disc(disc, method, border, options, progress, at);
    }
    catch (const Solver_error& e)
    {
      reason = e.what();
    }
    if (!reason.empty())
    {
      best.map.attempts.push_back({method, border, -1, reason});
      has_no_levels = has_no_levels
                      || (method == Map_method::SYMMETRIC_DIRICHLET && border == Map_border::FREE
                          && disc.number_of_vertices() > most_at_once);
      continue;
    }
    is_enough = best.consider(disc, method, border, std::move(at));
    if (is_enough || has_no_levels) { break; }
  }
  if (!is_enough && !has_no_levels && options.polygon.empty())
  {
    best.consider(disc, Map_method::TUTTE, Map_border::CIRCLE, map_without_lengths(disc, options.make_solver));
  }
  return best.take(disc);
}

Parameterization improve_map(const Triangle_surface& disc, std::vector<Plane_point> at, const Map_options& options,
                             const Progress& progress)
{
  Parameterization map;
  map.method = options.method;
  const bool is_conformal = options.method == Map_method::CONFORMAL;
  internal::lower_distortion(disc, at,
                             distortion_options(options, Distortion_energy::SYMMETRIC_DIRICHLET, Map_border::FREE),
                             true, is_conformal ? half_of(progress, 0) : progress);
  if (is_conformal) { lower_angle_distortion(disc, at, options, Map_border::FREE, half_of(progress, 1)); }
  place_in_unit_square(at);
  map.flipped = find_flipped_faces(disc.triangles, at);
  map.at = std::move(at);
  map.attempts.push_back({map.method, map.border, static_cast<Index>(map.flipped.size()), ""});
  measure(disc, map);
  return map;
}

} // namespace meridian
