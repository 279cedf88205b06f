// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_BY_GENERATORS_H
#define MERIDIAN_CUT_BY_GENERATORS_H

#include <meridian/base/choices.h>
#include <meridian/cut/join_generators.h>
#include <meridian/field/Field.h>
#include <meridian/handles/preference.h>

namespace meridian {

struct Cut_job;

/// \ingroup PkgMeridianCut
/// cuts a meridian and a longitude for each handle (\cite patane2007, section 4).
struct By_generators : Field_options, Meridian_options
{
  /// its name in reports and options
  static constexpr Choice_name names{"generators", "a meridian and a longitude for each handle"};
  static constexpr bool cuts_edges = false;       ///< whether it finds a whole cut graph of edges
  static constexpr bool moves_onto_edges = false; ///< whether its curves can be moved onto edges one by one
  Generator_join join = Generator_join::SURFACE;  ///< how the pairs are joined
  /// cuts the handles.
  /// \param job the surface and the choices, and what is filled
  void cut_handles(Cut_job& job) const;
};

} // namespace meridian

#endif // MERIDIAN_CUT_BY_GENERATORS_H
