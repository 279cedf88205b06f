// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_HANDLES_GENERATORS_H
#define MERIDIAN_HANDLES_GENERATORS_H

#include <meridian/base/Progress_observer.h>
#include <meridian/base/names.h>
#include <meridian/base/vectors.h>
#include <meridian/curves/contours.h>
#include <meridian/curves/tighten_curves.h>
#include <meridian/field/Field.h>
#include <meridian/field/Sparse_solver.h>
#include <meridian/handles/preference.h>
#include <meridian/surface/Refined_surface.h>

#include <array>
#include <map>
#include <vector>

namespace meridian {

/// \ingroup PkgMeridianGenerators
/// what one may choose about generators. Vertices are those of the surface.
struct Generator_options : Field_options, Meridian_options
{
  bool is_open = false;                  ///< whether the field's boundary is free, so that level lines may end there
  bool keep_complex = false;             ///< whether the quasi Morse-Smale complex of the field is kept
  bool flow = true;                      ///< whether longitudes are sought among flow lines first; of a surface with
                                         ///< more than eight handles, if they are not tightened
  bool tighten = true;                   ///< whether the curves are shortened within their classes
  Tighten_options tightening;            ///< and when that ends
  Solvers solvers;                       ///< of the fields
  Progress_observer* observer = nullptr; ///< told of the stages, or null
};

/// \ingroup PkgMeridianGenerators
/// how a curve was made.
enum class Curve_method
{
  CONTOUR, ///< a contour of the field
  FLOW,    ///< flow lines: every segment is monotone in a field
  ARC      ///< a shortest path between the two sides of the meridian
};

/// the names of `Curve_method`.
template <> struct Names<Curve_method>
{
  static constexpr std::array<Named_value<Curve_method>, 3> table{{
    {Curve_method::CONTOUR, "contour", "a level line"},
    {Curve_method::FLOW, "flow", "flow lines"},
    {Curve_method::ARC, "arc", "a shortest loop across the meridian"},
  }};
};

/// \ingroup PkgMeridianGenerators
/// on which side of its surface a curve bounds, up to homology (\cite dey2007).
enum class Loop_class
{
  HANDLE, ///< on the bounded side, like the meridian of a torus
  TUNNEL, ///< on the other side, like its longitude
  NEITHER,
  UNKNOWN ///< the surface has a boundary, meets itself or has faces without area
};

/// the names of `Loop_class`.
template <> struct Names<Loop_class>
{
  static constexpr std::array<Named_value<Loop_class>, 4> table{{
    {Loop_class::HANDLE, "handle", "bounds inside"},
    {Loop_class::TUNNEL, "tunnel", "bounds outside"},
    {Loop_class::NEITHER, "neither", "bounds on neither side"},
    {Loop_class::UNKNOWN, "unknown", "the surface has no inside"},
  }};
};

/// \ingroup PkgMeridianGenerators
/// a closed curve of a pair.
struct Generator_curve
{
  std::vector<Index> vertices; ///< of the refined surface, the one shared by the pair first
  double length = 0;           ///< on the refined surface
  double length_found = 0;     ///< before tightening
  Index saddle = -1;           ///< the root vertex of the saddle it belongs to, or nearest to it; -1 if there is none
  Curve_method method = Curve_method::ARC;     ///< how it was made
  bool was_flow = false;                       ///< whether it was made of flow lines before it was tightened
  std::map<Index, double> field;               ///< of flow lines: the field at root vertices around, linear along edges
  Loop_class loop_class = Loop_class::UNKNOWN; ///< written by `classify_generators()`
};

/// \ingroup PkgMeridianGenerators
/// a meridian and a longitude of one handle.
struct Generator_pair
{
  Generator_curve meridian;  ///< a level line
  Generator_curve longitude; ///< crosses it once, from right to left
};

/// \ingroup PkgMeridianGenerators
/// generators of one connected surface, and what was counted on the way.
struct Generators : Field_summary
{
  Refined_surface surface;           ///< the input, refined; the curves are its seams
  std::vector<Generator_pair> pairs; ///< as many as the genus
  bool is_morse_smale = true;        ///< whether no flow line of the field joins two saddles
  int saddle_connections = 0;        ///< how many do
  /// the flow lines of the field, from saddle to critical point, if asked for
  std::vector<std::vector<Point>> complex_lines;
  int genus = 0;                    ///< of the surface
  int boundary_loops = 0;           ///< of the surface
  int arcs = 0;                     ///< with a free boundary: the meridians' level lines that end on it
  int loops = 0;                    ///< and those that do not
  double smallest_angle_before = 0; ///< of the surface, in radians
  double smallest_angle_after = 0;  ///< of the refined surface, in radians
  Stage_times seconds;              ///< of each stage
};

/// \ingroup PkgMeridianGenerators
/// \param generators the generators of a surface
/// \returns the length of all meridians and longitudes together
double total_length(const Generators& generators);

} // namespace meridian

#endif // MERIDIAN_HANDLES_GENERATORS_H
