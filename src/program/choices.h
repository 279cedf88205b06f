// SPDX-License-Identifier: GPL-3.0-or-later
// What one may choose by a word on the command line alone; the library has numbers, functions and flags for it.
#ifndef MERIDIAN_CHOICES_H
#define MERIDIAN_CHOICES_H

#include <meridian/base/names.h>

#include <array>

namespace meridian {
namespace program {

enum class Prefer
{
  GAUSSIAN_CURVATURE,
  MEAN_CURVATURE,
  LENGTH,
  POSITION,
  HIDDEN,
  WEIGHTS
};

enum class Basis
{
  PAIRS,
  SHORTEST
};

enum class Longitudes
{
  FLOW,
  ARC
};

enum class Chart_per
{
  OBJECT,
  GROUP,
  MATERIAL,
  SMOOTHING,
  SMOOTH_ANGLE
};

enum class Boundary_mode
{
  CLOSED,
  OPEN
};

} // namespace program

template <> struct Names<program::Prefer>
{
  static constexpr std::array<Named_value<program::Prefer>, 6> table{{
    {program::Prefer::GAUSSIAN_CURVATURE, "gaussian-curvature", "high at the saddle"},
    {program::Prefer::MEAN_CURVATURE, "mean-curvature", "high at the saddle"},
    {program::Prefer::LENGTH, "length", "short"},
    {program::Prefer::POSITION, "position", "far out in a direction"},
    {program::Prefer::HIDDEN, "hidden", "hidden from an eye"},
    {program::Prefer::WEIGHTS, "weights", "through low weights of vertices"},
  }};
};

template <> struct Names<program::Basis>
{
  static constexpr std::array<Named_value<program::Basis>, 2> table{{
    {program::Basis::PAIRS, "pairs", "a meridian and a longitude for every handle"},
    {program::Basis::SHORTEST, "shortest", "short loops that are a basis of homology and may cross"},
  }};
};

template <> struct Names<program::Longitudes>
{
  static constexpr std::array<Named_value<program::Longitudes>, 2> table{{
    {program::Longitudes::FLOW, "flow",
     "of flow lines where these serve; of more than eight handles with --no-tighten alone"},
    {program::Longitudes::ARC, "arc", "shortest arcs at once"},
  }};
};

template <> struct Names<program::Chart_per>
{
  static constexpr std::array<Named_value<program::Chart_per>, 5> table{{
    {program::Chart_per::OBJECT, "object", "what an OBJ file names with o"},
    {program::Chart_per::GROUP, "group", "with g"},
    {program::Chart_per::MATERIAL, "material", "with usemtl"},
    {program::Chart_per::SMOOTHING, "smoothing", "with s"},
    {program::Chart_per::SMOOTH_ANGLE, "smooth-angle", "what edges of more than 30 degrees enclose"},
  }};
};

template <> struct Names<program::Boundary_mode>
{
  static constexpr std::array<Named_value<program::Boundary_mode>, 2> table{{
    {program::Boundary_mode::CLOSED, "closed", "each boundary loop takes one value of the field"},
    {program::Boundary_mode::OPEN, "open", "the boundary is free and level lines may end there"},
  }};
};

} // namespace meridian

#endif // MERIDIAN_CHOICES_H
