// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_BY_FLOW_LINES_H
#define MERIDIAN_CUT_BY_FLOW_LINES_H

#include <meridian/base/choices.h>
#include <meridian/field/Field.h>

namespace meridian {

struct Cut_job;

/// \ingroup PkgMeridianCut
/// cuts the descending flow lines of all saddles (\cite ni2004). Of the field's maxima the highest is kept.
struct By_flow_lines : Field_options
{
  /// its name in reports and options
  static constexpr Choice_name names{"morse", "the descending flow lines of all saddles"};
  static constexpr bool cuts_edges = false;       ///< whether it finds a whole cut graph of edges
  static constexpr bool moves_onto_edges = false; ///< whether its curves can be moved onto edges one by one
  /// cuts the handles.
  /// \param job the surface and the choices, and what is filled
  void cut_handles(Cut_job& job) const;
};

} // namespace meridian

#endif // MERIDIAN_CUT_BY_FLOW_LINES_H
