// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_BY_CONTOURS_H
#define MERIDIAN_CUT_BY_CONTOURS_H

#include <meridian/base/choices.h>
#include <meridian/field/Field.h>
#include <meridian/handles/preference.h>

namespace meridian {

struct Cut_job;

/// \ingroup PkgMeridianCut
/// cuts a meridian for each handle: a level line of a field (\cite patane2007, section 3).
struct By_contours : Field_options, Meridian_options
{
  /// its name in reports and options
  static constexpr Choice_name names{"contours", "a meridian for each handle, a level line"};
  static constexpr bool cuts_edges = false;      ///< whether it finds a whole cut graph of edges
  static constexpr bool moves_onto_edges = true; ///< whether its curves can be moved onto edges one by one
  /// cuts the handles.
  /// \param job the surface and the choices, and what is filled
  void cut_handles(Cut_job& job) const;
};

} // namespace meridian

#endif // MERIDIAN_CUT_BY_CONTOURS_H
