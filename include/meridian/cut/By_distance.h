// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_BY_DISTANCE_H
#define MERIDIAN_CUT_BY_DISTANCE_H

#include <meridian/base/choices.h>
#include <meridian/base/vectors.h>
#include <meridian/field/Field.h>
#include <meridian/handles/preference.h>
#include <meridian/surface/Triangle_surface.h>

namespace meridian {

struct Cut_job;

/// \ingroup PkgMeridianCut
/// cuts contours of the geodesic distance from a vertex (\cite steiner2002).
struct By_distance : Chosen_extrema, Meridian_options
{
  /// its name in reports and options
  static constexpr Choice_name names{"geodesic", "contours of the geodesic distance from a vertex"};
  static constexpr bool cuts_edges = false;      ///< whether it finds a whole cut graph of edges
  static constexpr bool moves_onto_edges = true; ///< whether its curves can be moved onto edges one by one
  Index source = -1;                             ///< where distances begin; -1: far out
  /// cuts the handles.
  /// \param job the surface and the choices, and what is filled
  void cut_handles(Cut_job& job) const;
};

/// \ingroup PkgMeridianCut
/// checks choices of this method alone.
/// \param method the choices
/// \throws Invalid_input_error if they do not go together
void check(const By_distance& method);

/// \ingroup PkgMeridianCut
/// checks choices of this method for a surface.
/// \param s the surface
/// \param method the choices
/// \throws Invalid_input_error if they do not go together or a vertex is not one of the surface
void check(const Triangle_surface& s, const By_distance& method);

} // namespace meridian

#endif // MERIDIAN_CUT_BY_DISTANCE_H
