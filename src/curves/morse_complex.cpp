// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/curves/morse_complex.h>

#include <meridian/base/exceptions.h>

#include <algorithm>
#include <map>

namespace meridian {

std::vector<Curve_point> whole_line(const std::vector<Flow_line>& lines, Index i)
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

Morse_complex make_morse_complex(const Ordered_surface& m)
{
  Morse_complex c;
  c.critical = find_critical_points(m.surface, m.rank);
  std::map<Index, Index> vertex; // of the graph, by node
  for (std::size_t i = 0; i < c.critical.size(); ++i)
  {
    vertex[m.graph.node[c.critical[i].vertex]] = static_cast<Index>(i);
  }
  for (bool descend : {true, false})
  {
    Flow_tracer tracer(m, descend, c.critical);
    for (const Critical_point& p : c.critical)
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
    c.edges.push_back({from->second, to->second, i, length(m.surface, whole)});
    if (c.critical[to->second].kind == Critical_kind::SADDLE) { c.connections.emplace_back(from->second, to->second); }
  }
  return c;
}

} // namespace meridian
