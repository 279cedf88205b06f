// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/map/pin_map.h>

#include <meridian/map/is_one_to_one.h>
#include <meridian/map/planar_map.h>

#include <algorithm>
#include <complex>
#include <limits>
#include <optional>

namespace meridian {

namespace internal {

namespace {

using Complex = std::complex<double>;

Complex number(const Plane_point& p) { return {p[0], p[1]}; }

// Turns, scales and moves all points, as pins are nearest to where they shall be.
void fit(std::vector<Plane_point>& at, const std::vector<Map_pin>& pins)
{
  Complex from = 0, to = 0;
  for (const Map_pin& p : pins)
  {
    from += number(at[p.vertex]) / static_cast<double>(pins.size());
    to += number(p.at) / static_cast<double>(pins.size());
  }
  Complex product = 0;
  double square = 0;
  for (const Map_pin& p : pins)
  {
    product += std::conj(number(at[p.vertex]) - from) * (number(p.at) - to);
    square += std::norm(number(at[p.vertex]) - from);
  }
  const Complex factor = square > 0 && std::abs(product) > 0 ? product / square : 1;
  for (Plane_point& p : at)
  {
    const Complex z = factor * (number(p) - from) + to;
    p = {z.real(), z.imag()};
  }
}

double farthest(const std::vector<Plane_point>& at, const std::vector<Map_pin>& pins)
{
  double most = 0;
  for (const Map_pin& p : pins) { most = std::max(most, norm(at[p.vertex] - p.at)); }
  return most;
}

// Puts vertices where they shall be, if all are next to it.
bool snap(const Triangle_surface& disc, std::vector<Plane_point>& at, const std::vector<Map_pin>& pins)
{
  constexpr double next_to = 0.05; // of the shortest edge
  std::vector<Plane_point> next = at;
  for (const Map_pin& p : pins)
  {
    double shortest = std::numeric_limits<double>::infinity();
    disc.for_each_outgoing(p.vertex,
                           [&](Index h) { shortest = std::min(shortest, norm(at[disc.target(h)] - at[p.vertex])); });
    if (!(norm(at[p.vertex] - p.at) <= next_to * shortest)) { return false; }
    next[p.vertex] = p.at;
  }
  const auto loops = boundary_loops(disc);
  std::vector<Index> loop;
  for (Index h : loops.front()) { loop.push_back(disc.source(h)); }
  if (!is_one_to_one(disc, next) || !is_roomy(loop, next)) { return false; }
  at.swap(next);
  return true;
}

} // namespace

} // namespace internal

double pin_map(const Triangle_surface& disc, std::vector<Plane_point>& at, const std::vector<Map_pin>& pins,
               Make_solver make_solver)
{
  constexpr int rounds = 24, steps = 6, scaled = 5;
  constexpr double stiffer = 4;
  internal::fit(at, pins);
  Distortion_options options;
  options.make_solver = make_solver;
  options.pins = pins;
  options.stiffness = 1;
  std::optional<internal::Distortion_minimizer> minimizer;
  double left = internal::farthest(at, pins);
  for (int i = 0; !internal::snap(disc, at, pins) && i < rounds; ++i, options.stiffness *= stiffer)
  {
    const std::vector<Plane_point> before = at;
    if (i < scaled) { minimizer.emplace(disc, at, options); } // for the size that the image has now
    else { minimizer->stiffen(stiffer); }
    for (int k = 0; k < steps && minimizer->step() > options.least_gain; ++k) {}
    if (!is_one_to_one(disc, at)) // springs that contradict each other squeeze to where rounding decides
    {
      at = before;
      break;
    }
    constexpr double little = 0.99;
    const double now = internal::farthest(at, pins);
    if (i >= scaled && now > little * left) { break; }
    left = now;
  }
  return internal::farthest(at, pins);
}

} // namespace meridian
