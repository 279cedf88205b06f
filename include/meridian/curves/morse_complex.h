// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CURVES_MORSE_COMPLEX_H
#define MERIDIAN_CURVES_MORSE_COMPLEX_H

#include <meridian/curves/flow_lines.h>

#include <boost/graph/adjacency_list.hpp>

namespace meridian {

/// \ingroup PkgMeridianFlow
/// a critical point, as a vertex of the graph of a complex.
struct Complex_vertex
{
  Critical_point critical{};
};

/// \ingroup PkgMeridianFlow
/// a flow line from a saddle to the critical point that it comes to, as an edge of the graph of a complex.
struct Complex_edge
{
  Index line = -1;
  double length = 0;
};

/// \ingroup PkgMeridianFlow
using Complex_graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, Complex_vertex, Complex_edge>;

/// \ingroup PkgMeridianFlow
/// the quasi Morse-Smale complex of an ordered surface (Patane 2007, section 4; Edelsbrunner, Harer, Zomorodian 2003).
struct Morse_complex
{
  std::vector<Flow_line> lines; ///< descending ones first
  Complex_graph graph;          ///< critical points, and a line for each edge
  /// edges of the graph from saddle to saddle, as vertices of the graph
  std::vector<std::pair<Index, Index>> connections;
  bool is_morse_smale() const { return connections.empty(); } ///< whether no line of a saddle comes to a saddle
};

/// \ingroup PkgMeridianFlow
/// \returns the points of a flow line as far as its critical point: its own, and what it joins
inline std::vector<Curve_point> whole_line(const std::vector<Flow_line>& lines, Index i)
{
  const auto is_same = [](const Curve_point& a, const Curve_point& b) {
    return a.is_vertex() ? a.vertex == b.vertex : !b.is_vertex() && a.node == b.node;
  };
  std::vector<Curve_point> points = lines[i].curve.points;
  while (lines[i].joined >= 0)
  {
    i = lines[i].joined;
    const auto& next = lines[i].curve.points;
    const Curve_point at = points.back();
    auto from = std::find_if(next.begin(), next.end(), [&](const Curve_point& p) { return is_same(p, at); });
    if (from == next.end()) { throw Internal_error("whole_line: a line does not pass where another joins it"); }
    points.pop_back();
    points.insert(points.end(), from, next.end());
  }
  return points;
}

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
inline Morse_complex make_morse_complex(const Ordered_surface& m)
{
  Morse_complex c;
  const std::vector<Critical_point> critical = find_critical_points(m.surface, m.rank);
  std::map<Index, Index> vertex; // of the graph, by node
  for (const Critical_point& p : critical)
    vertex[m.graph.node[p.vertex]] = static_cast<Index>(boost::add_vertex(Complex_vertex{p}, c.graph));
  for (bool descend : {true, false})
  {
    Flow_tracer tracer(m, descend, critical);
    for (const Critical_point& p : critical)
    {
      if (p.kind == Critical_kind::SADDLE) { tracer.trace(p.vertex); }
    }
    const Index first = static_cast<Index>(c.lines.size());
    for (Flow_line line : tracer.lines())
    {
      if (line.joined >= 0) { line.joined += first; }
      c.lines.push_back(std::move(line));
    }
  }
  for (Index i = 0; i < static_cast<Index>(c.lines.size()); ++i)
  {
    const auto from = vertex.find(m.graph.node[c.lines[i].start]), to = vertex.find(m.graph.node[c.lines[i].end]);
    if (from == vertex.end() || to == vertex.end()) { continue; } // from or to a boundary loop
    const Surface_curve whole{whole_line(c.lines, i), false};
    boost::add_edge(from->second, to->second, Complex_edge{i, length(m.surface, whole)}, c.graph);
    if (c.graph[to->second].critical.kind == Critical_kind::SADDLE)
    {
      c.connections.emplace_back(from->second, to->second);
    }
  }
  return c;
}

} // namespace meridian

#endif // MERIDIAN_CURVES_MORSE_COMPLEX_H
