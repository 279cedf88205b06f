// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_CUT_H
#define MERIDIAN_CUT_CUT_H

#include <meridian/base/Progress_observer.h>
#include <meridian/base/vectors.h>
#include <meridian/field/Field.h>
#include <meridian/handles/select_meridians.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/open_along.h>

#include <string>
#include <vector>

namespace meridian {

/// \ingroup PkgMeridianCut
/// a cut graph of one connected surface, and what was counted on the way.
struct Cut : Field_summary
{
  Refined_surface surface;                    ///< the input, refined; the cut graph is its seam
  Opened_surface opened;                      ///< the disc
  std::vector<std::vector<Index>> meridians;  ///< closed, as vertices of `surface`, the most preferred first
  std::vector<std::vector<Index>> longitudes; ///< closed, of the same handles; with `Cut_method::GENERATORS`
  std::vector<std::vector<Index>> flow_lines; ///< open; with `Cut_method::MORSE`
  std::vector<std::vector<Index>> links;      ///< open, as vertices of `surface`
  /// open: the graph's paths, where they are none of these: with methods that cut edges and with `Tightening::GRAPH`
  std::vector<std::vector<Index>> paths;
  std::vector<Meridian_choice> choices; ///< the count after each meridian
  std::vector<Index> saddles;           ///< for each meridian, a vertex of its saddle
  int genus = 0, boundary_loops = 0;
  bool links_in_plane = false;
  std::string link_note;   ///< why links were not taken through the plane, if asked for
  double length = 0;       ///< of the seams
  double length_found = 0; ///< before the graph was tightened
  double smallest_angle_before = 0, smallest_angle_after = 0; ///< in radians
  Stage_times seconds;
};

} // namespace meridian

#endif // MERIDIAN_CUT_CUT_H
