// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_BY_DISTANCE_H
#define MERIDIAN_CUT_BY_DISTANCE_H

#include <meridian/base/names.h>
#include <meridian/base/vectors.h>
#include <meridian/field/Field.h>
#include <meridian/handles/preference.h>
#include <meridian/surface/Triangle_surface.h>

namespace meridian {

struct Cut_job;

/// \ingroup PkgMeridianCut
/// cuts contours of the geodesic distance from a vertex (Steiner, Fischer 2002).
struct By_distance : Chosen_extrema, Meridian_options
{
  static constexpr Choice_name names{"geodesic", "contours of the geodesic distance from a vertex"};
  static constexpr bool cuts_edges = false, moves_onto_edges = true;
  Index source = -1; ///< where distances begin; -1: far out
  void cut_handles(Cut_job& job) const;
};

/// \ingroup PkgMeridianCut
/// checks choices of this method alone.
/// \throws Invalid_input_error if they do not go together
void check(const By_distance& method);

/// \ingroup PkgMeridianCut
/// checks choices of this method for a surface.
/// \throws Invalid_input_error if they do not go together or a vertex is not one of the surface
void check(const Triangle_surface& s, const By_distance& method);

} // namespace meridian

#endif // MERIDIAN_CUT_BY_DISTANCE_H
