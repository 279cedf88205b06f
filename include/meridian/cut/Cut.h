// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_CUT_H
#define MERIDIAN_CUT_CUT_H

#include <meridian/base/Progress_observer.h>
#include <meridian/base/names.h>
#include <meridian/base/vectors.h>
#include <meridian/cut/Tightening.h>
#include <meridian/field/Field.h>
#include <meridian/handles/select_meridians.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/open_along.h>

#include <array>
#include <string>
#include <vector>

namespace meridian {

/// \ingroup PkgMeridianCut
/// what a curve of a cut graph is.
enum class Curve_kind
{
  MERIDIAN,  ///< closed, around a handle
  LONGITUDE, ///< closed, along it
  FLOW_LINE, ///< of a field, from a saddle down
  LINK,      ///< between boundaries
  ARC,       ///< from border to border through a disc, which it divides
  SEAM,      ///< that was given, from node to node
  PATH       ///< of the graph, where its curves are none of these: with methods that cut edges and `Tightening::GRAPH`
};

/// the names of `Curve_kind`.
template <> struct Names<Curve_kind>
{
  static constexpr std::array<Named_value<Curve_kind>, 7> table{{
    {Curve_kind::MERIDIAN, "meridian", "closed, around a handle"},
    {Curve_kind::LONGITUDE, "longitude", "closed, along a handle"},
    {Curve_kind::FLOW_LINE, "flow_line", "of a field, from a saddle down"},
    {Curve_kind::LINK, "link", "between boundaries"},
    {Curve_kind::ARC, "arc", "through a disc, which it divides"},
    {Curve_kind::SEAM, "seam", "that was given"},
    {Curve_kind::PATH, "path", "a path of the cut graph"},
  }};
};

/// \ingroup PkgMeridianCut
/// a curve of a cut graph.
struct Named_curve
{
  Curve_kind kind;             ///< what it is
  std::vector<Index> vertices; ///< of the refined surface, along edges
  bool is_closed = false;      ///< whether an edge leads from the last vertex to the first
  Index saddle = -1;           ///< of a meridian: a vertex of the saddle that it belongs to
};

/// \ingroup PkgMeridianCut
/// a cut graph of one connected surface, and what was counted on the way.
struct Cut : Field_summary
{
  Refined_surface surface;                  ///< the input, refined; the cut graph is its seam
  Opened_surface opened;                    ///< the disc
  std::vector<Named_curve> curves;          ///< that the cut graph is made of; of one kind, the most preferred first
  std::vector<Meridian_choice> choices;     ///< the count after each meridian, if they stay as they were chosen
  Tightening tightening = Tightening::NONE; ///< what was made shorter
  int genus = 0;                            ///< of the surface
  int boundary_loops = 0;                   ///< of the surface
  bool links_in_plane = false;              ///< whether links run through an embedding in the plane
  std::string link_note;                    ///< why links were not taken through the plane, if asked for
  double length = 0;                        ///< of the seams
  double length_found = 0;                  ///< before the graph was tightened
  double smallest_angle_before = 0;         ///< of the surface, in radians
  double smallest_angle_after = 0;          ///< of the refined surface, in radians
  Stage_times seconds;                      ///< of each stage
};

/// \ingroup PkgMeridianCut
/// \param cut a cut
/// \param kind of which kind
/// \returns its curves of that kind, in order
std::vector<Named_curve> curves_of(const Cut& cut, Curve_kind kind);

/// \ingroup PkgMeridianCut
/// appends curves of one kind; meridians and longitudes are closed.
/// \param cut the cut that they are of
/// \param kind of which kind
/// \param lines the vertices of each, on the refined surface
void add_curves(Cut& cut, Curve_kind kind, std::vector<std::vector<Index>> lines);

} // namespace meridian

#endif // MERIDIAN_CUT_CUT_H
