// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/curves/flow_lines.h>

#include <meridian/surface/Closed_model.h>

#include <algorithm>
#include <limits>

namespace meridian {

Flow_tracer::Flow_tracer(const Ordered_surface& m, bool descend, const std::vector<Critical_point>& critical)
  : m_flow(m, descend), m_surface(m.surface), m_kind(m.graph.number_of_nodes, REGULAR)
{
  for (const Critical_point& p : critical)
    m_kind[m_flow.node(p.vertex)] = p.kind == Critical_kind::SADDLE                 ? SADDLE
                                    : (p.kind == Critical_kind::MINIMUM) == descend ? BOTTOM
                                                                                    : TOP;
}

void Flow_tracer::trace(Index saddle)
{
  std::vector<Index> spokes;
  for_each_around_node(m_surface, saddle, [&](Index h) { spokes.push_back(h); });
  const std::size_t n = spokes.size();
  std::size_t first = 0; // a spoke upwards before one downwards
  while (m_flow.is_down(spokes[first], saddle) || !m_flow.is_down(spokes[(first + 1) % n], saddle)) { ++first; }
  std::vector<std::vector<Index>> sectors;
  for (std::size_t i = 1; i <= n; ++i)
  {
    const Index h = spokes[(first + i) % n];
    if (!m_flow.is_down(h, saddle)) { continue; }
    if (!m_flow.is_down(spokes[(first + i - 1) % n], saddle)) { sectors.emplace_back(); }
    sectors.back().push_back(h);
  }
  for (const auto& sector : sectors) { trace_line(sector); }
}

Index Flow_tracer::passage(Index h) const
{
  const Index o = m_surface.opposite[h];
  if (o < 0 || m_runs.count(m_surface.edge(h))) { return -1; }
  const bool here = m_flow.flows_out(h), there = m_flow.flows_out(o);
  return here == there ? -1 : here ? h : o;
}

Curve_point Flow_tracer::point_on(Index h, const Portal& portal) const
{
  return {{h, turn_fraction(m_surface, h, portal.t)}, -1, m_surface.edge(h)};
}

bool Flow_tracer::reach_portal(Flow_line& line, Index h, double t)
{
  t = t > margin ? std::min(t, 1 - margin) : margin;
  const auto line_number = static_cast<Index>(m_lines.size());
  const auto [at, is_new] =
    m_portals.try_emplace(m_surface.edge(h), Portal{turn_fraction(m_surface, h, t), line_number});
  line.curve.points.push_back(point_on(h, at->second));
  return !is_new && join(line, at->second.line);
}

bool Flow_tracer::reach_vertex(Flow_line& line, Index v)
{
  line.curve.points.push_back(Curve_point::on_vertex(v));
  if (m_kind[m_flow.node(v)] != REGULAR || m_surface.is_boundary_vertex(v))
  {
    line.end = v;
    return true;
  }
  const auto [at, is_new] = m_visited.try_emplace(v, static_cast<Index>(m_lines.size()));
  return !is_new && join(line, at->second);
}

bool Flow_tracer::join(Flow_line& line, Index other)
{
  line.joined = other;
  return true;
}

Flow_tracer::Departure Flow_tracer::depart(const std::vector<Index>& lower) const
{
  Departure best;
  const auto offer = [&](const Departure& d) {
    if (best.halfedge < 0 || d.speed > best.speed) { best = d; }
  };
  for (Index h : lower)
  {
    const Index v = m_surface.source(h);
    offer({h, true, 0.5, m_flow.steepness(h)});
    const Index across = m_surface.next(h), w = m_surface.target(across);
    if (m_flow.rank(w) >= m_flow.rank(v) || is_sink(w) || is_sink(m_surface.target(h))
        || m_turns.count({m_surface.face(h), v}))
    {
      continue;
    }
    const auto [t, time] = m_flow.leave(across, m_surface.points[v]);
    if (time < std::numeric_limits<double>::infinity() && t > 0 && t < 1)
    {
      offer({across, false, t, norm(m_flow.slope(m_surface.face(h)))});
    }
  }
  return best;
}

void Flow_tracer::trace_line(std::vector<Index> lower)
{
  Flow_line line;
  line.descends = m_flow.descends();
  line.start = m_surface.source(lower.front());
  bool is_begun = false;
  for (;;)
  {
    const Departure d = depart(lower);
    const Index v = d.along ? m_surface.source(d.halfedge) : m_surface.apex(d.halfedge);
    if (!is_begun) // on a boundary loop, where the line leaves it
    {
      line.start = v;
      line.curve.points.push_back(Curve_point::on_vertex(v));
      is_begun = true;
    }
    Index h = d.halfedge;
    bool is_over = false;
    if (d.along)
    {
      const bool is_crossed = m_portals.count(m_surface.edge(h)) > 0;
      if (!is_crossed) { m_runs.insert(m_surface.edge(h)); }
      is_over = reach_portal(line, h, 0.5) || reach_vertex(line, m_surface.target(h));
      h = -1;
    }
    else
    {
      m_straight.insert({m_surface.face(h), v});
      is_over = reach_portal(line, h, d.t);
    }
    while (!is_over && h >= 0) { is_over = cross_face(line, h); }
    if (is_over) { break; }
    lower.clear();
    const Index at = line.curve.points.back().vertex;
    m_surface.for_each_outgoing(at, [&](Index g) {
      if (m_flow.is_down(g, at)) { lower.push_back(g); }
    });
  }
  if (line.joined >= 0) { line.end = m_lines[line.joined].end; }
  const Index end = line.end;
  const bool ends_here = line.joined < 0;
  m_lines.push_back(std::move(line));
  // Beyond a boundary loop that is not critical the flow goes on.
  if (!ends_here || m_kind[m_flow.node(end)] != REGULAR || !m_left.insert(m_flow.node(end)).second) { return; }
  std::vector<Index> onward;
  for_each_around_node(m_surface, end, [&](Index g) {
    if (m_flow.is_down(g, end)) { onward.push_back(g); }
  });
  trace_line(onward);
}

bool Flow_tracer::cross_face(Flow_line& line, Index& h)
{
  const Index low = m_flow.lower_end(h), high = m_surface.source(h) == low ? m_surface.target(h) : m_surface.source(h);
  const auto slide = [&] {
    h = -1;
    return reach_vertex(line, low);
  };
  if (passage(h) != h || is_sink(low)) { return slide(); }
  const Index o = m_surface.opposite[h], f = m_surface.face(o), c = m_surface.apex(o);
  if (m_flow.rank(c) >= m_flow.rank(high)) { return slide(); }
  if (is_sink(c) && m_flow.rank(c) < m_flow.rank(low))
  {
    h = -1;
    return reach_vertex(line, c);
  }
  const Index at_low = m_surface.source(o) == low ? m_surface.prev(o) : m_surface.next(o);
  const Index at_high = m_surface.source(o) == low ? m_surface.next(o) : m_surface.prev(o);
  const Curve_point& p = line.curve.points.back();
  const Point from = m_surface.point_on(p.halfedge, p.t);
  const auto [t_low, time_low] = m_flow.leave(at_low, from);
  const auto [t_high, time_high] = m_flow.leave(at_high, from);
  // The line may turn around the higher end, unless lines only come from there or one goes from it through the face.
  const bool may_turn =
    m_kind[m_flow.node(high)] != TOP && !m_surface.is_boundary_vertex(high) && !m_straight.count({f, high});
  const bool turns = may_turn && time_high < time_low;
  if (!turns && !(time_low < std::numeric_limits<double>::infinity())) { return slide(); }
  const Index to = turns ? at_high : at_low;
  if (passage(to) == m_surface.opposite[to] && m_surface.opposite[to] >= 0) { return slide(); }
  m_turns.insert({f, turns ? high : low});
  h = to;
  return reach_portal(line, to, turns ? t_high : t_low);
}

} // namespace meridian
