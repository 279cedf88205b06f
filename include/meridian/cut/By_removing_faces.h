// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_BY_REMOVING_FACES_H
#define MERIDIAN_CUT_BY_REMOVING_FACES_H

#include <meridian/base/choices.h>
#include <meridian/surface/Triangle_surface.h>

namespace meridian {

struct Cut_job;

/// \ingroup PkgMeridianCut
/// cuts edges: what is left when faces are removed and keep a disc (\cite gu2002).
struct By_removing_faces
{
  /// its name in reports and options
  static constexpr Choice_name names{"geometry-image", "the edges left when faces are removed"};
  static constexpr bool cuts_edges = true;        ///< whether it finds a whole cut graph of edges
  static constexpr bool moves_onto_edges = false; ///< whether its curves can be moved onto edges one by one
  /// cuts the handles.
  /// \param job the surface and the choices, and what is filled
  void cut_handles(Cut_job& job) const;
};

/// \cond
inline void check(const By_removing_faces&) {}
inline void check(const Triangle_surface&, const By_removing_faces&) {}
/// \endcond

} // namespace meridian

#endif // MERIDIAN_CUT_BY_REMOVING_FACES_H
