// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CURVES_FLOW_LINES_H
#define MERIDIAN_CURVES_FLOW_LINES_H

#include <meridian/base/vectors.h>
#include <meridian/curves/internal/flow_direction.h>
#include <meridian/field/Ordered_surface.h>
#include <meridian/field/critical_points.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/Surface_curve.h>

#include <map>
#include <set>
#include <utility>
#include <vector>

namespace meridian {

/// \ingroup PkgMeridianFlow
/// a line of steepest descent or ascent, as far as no earlier line runs.
struct Flow_line
{
  Index start = -1;     ///< the vertex it begins at: a saddle, or on a boundary loop that a line ended at before
  bool descends = true; ///< or ascends
  Surface_curve curve;  ///< on the surface that was ordered; a point inside an edge has the edge for a node
  Index joined = -1;    ///< the earlier line that it ends on, or -1 if it ends at a vertex of its own
  Index end = -1;       ///< a vertex of the critical node or boundary loop that it, or the line it joins, comes to
};

/*!
 * \ingroup PkgMeridianFlow
 *
 * follows steepest descent or ascent through faces.
 *
 * An edge is crossed at one point, its portal, the same for all lines, and in one direction. So lines of one tracer
 * merge and never cross. Where the field turns back at an edge, or the order does not let a line go on, it slides along
 * the edge to the lower end. What is allowed is decided by ranks alone: on the way down the higher end of the edge that
 * is crossed never rises, and while it stays the same the line turns around it one way, less than once. So every line
 * ends, and ends at a critical node or a boundary loop, however bad the values are. (Downwards is upwards for ascending
 * lines.)
 */
class Flow_tracer
{
public:
  /// \param m an ordered surface whose saddles are simple
  /// \param descend whether lines go down
  /// \param critical its critical points, as `find_critical_points(m.surface, m.rank)` gives them
  Flow_tracer(const Ordered_surface& m, bool descend, const std::vector<Critical_point>& critical);
  Flow_tracer(Ordered_surface&& m, bool descend, const std::vector<Critical_point>& critical) = delete;

  /// traces the two lines of a saddle.
  /// \param saddle its vertex
  void trace(Index saddle);

  /// \returns all lines that were traced
  const std::vector<Flow_line>& lines() const { return m_lines; }

private:
  enum Kind : char
  {
    REGULAR,
    SADDLE,
    TOP,
    BOTTOM
  };
  static constexpr double margin = 0.05; // no portal comes closer to an end of its edge
  struct Portal
  {
    double t;
    Index line;
  };

  // Whether lines next to a vertex go straight to it.
  bool is_sink(Index v) const { return m_kind[m_flow.node(v)] == BOTTOM || m_surface.is_boundary_vertex(v); }

  // The halfedge by which lines cross an edge, leaving its face, or -1 if they slide along it.
  Index passage(Index h) const;
  Curve_point point_on(Index h, const Portal& portal) const;
  // Brings the line to the portal of `h`, which `t` places if it is new. \returns whether the line ends there on
  // another.
  bool reach_portal(Flow_line& line, Index h, double t);
  // The same for a vertex.
  bool reach_vertex(Flow_line& line, Index v);
  bool join(Flow_line& line, Index other);

  // What a line does from a vertex: the steepest of the ways into faces and along edges, among halfedges to lower
  // neighbours.
  struct Departure
  {
    Index halfedge = -1;
    bool along = true;
    double t = 0.5, speed = -1;
  };
  Departure depart(const std::vector<Index>& lower) const;

  void trace_line(std::vector<Index> lower);

  // From the portal of `h`, reached out of its face: through the next face, or along the edge. Sets `h` to the edge
  // reached, or to -1 at a vertex. \returns whether the line is over
  bool cross_face(Flow_line& line, Index& h);

  internal::Flow_direction m_flow;
  const Refined_surface& m_surface;
  std::vector<Kind> m_kind; // of each node
  std::vector<Flow_line> m_lines;
  std::map<Index, Portal> m_portals;            // by edge
  std::set<Index> m_runs;                       // edges that lines run along
  std::map<Index, Index> m_visited;             // vertex: the line that came first
  std::set<std::pair<Index, Index>> m_straight; // face and corner, where a line goes from the corner through the face
  std::set<std::pair<Index, Index>> m_turns;    // face and corner that a line passes by
  std::set<Index> m_left;                       // boundary loops that a line goes on from
};

} // namespace meridian

#endif // MERIDIAN_CURVES_FLOW_LINES_H
