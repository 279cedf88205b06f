// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_BY_REMOVING_FACES_H
#define MERIDIAN_CUT_BY_REMOVING_FACES_H

#include <meridian/base/names.h>
#include <meridian/surface/Triangle_surface.h>

namespace meridian {

struct Cut_job;

/// \ingroup PkgMeridianCut
/// cuts edges: what is left when faces are removed and keep a disc (Gu, Gortler, Hoppe 2002).
struct By_removing_faces
{
  static constexpr Choice_name names{"geometry-image", "the edges left when faces are removed"};
  static constexpr bool cuts_edges = true, moves_onto_edges = false;
  void cut_handles(Cut_job& job) const;
};

inline void check(const By_removing_faces&) {}
inline void check(const Triangle_surface&, const By_removing_faces&) {}

} // namespace meridian

#endif // MERIDIAN_CUT_BY_REMOVING_FACES_H
