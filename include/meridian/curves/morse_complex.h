// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CURVES_MORSE_COMPLEX_H
#define MERIDIAN_CURVES_MORSE_COMPLEX_H

#include <meridian/base/vectors.h>
#include <meridian/curves/flow_lines.h>
#include <meridian/field/Ordered_surface.h>
#include <meridian/field/critical_points.h>
#include <meridian/surface/Surface_curve.h>

#include <utility>
#include <vector>

namespace meridian {

/// \ingroup PkgMeridianFlow
/// a flow line from a saddle to the critical point that it comes to, as an edge of a complex.
struct Complex_edge
{
  Index from;    ///< the saddle, as an index into `Morse_complex::critical`
  Index to;      ///< where it comes to, as another
  Index line;    ///< an index into `Morse_complex::lines`
  double length; ///< as far as `to`
};

/// \ingroup PkgMeridianFlow
/// the quasi Morse-Smale complex of an ordered surface (\cite patane2007, section 4; \cite edelsbrunner2003).
struct Morse_complex
{
  std::vector<Flow_line> lines;         ///< descending ones first
  std::vector<Critical_point> critical; ///< the vertices of the graph
  std::vector<Complex_edge> edges;      ///< the edges of the graph
  /// edges of the graph from saddle to saddle, as indices into `critical`
  std::vector<std::pair<Index, Index>> connections;
  /// \returns whether no line of a saddle comes to a saddle
  bool is_morse_smale() const { return connections.empty(); }
};

/// \ingroup PkgMeridianFlow
/// \param lines the lines of a tracer
/// \param i which of them
/// \returns the points of a flow line as far as its critical point: its own, and what it joins
std::vector<Curve_point> whole_line(const std::vector<Flow_line>& lines, Index i);

/*!
 * \ingroup PkgMeridianFlow
 *
 * \returns the quasi Morse-Smale complex: the two descending and the two ascending flow lines of every saddle, and
 *          their graph
 * \param m an ordered surface whose saddles are simple
 *
 * On a surface with boundary, lines go on beyond a boundary loop that is not critical; those pieces are lines of their
 * own, and the edge of the graph is the piece that began at the saddle.
 *
 * \par Complexity
 * \f$ O(k \log k) \f$ for `k` edges crossed, and one pass over the surface
 */
Morse_complex make_morse_complex(const Ordered_surface& m);

} // namespace meridian

#endif // MERIDIAN_CURVES_MORSE_COMPLEX_H
