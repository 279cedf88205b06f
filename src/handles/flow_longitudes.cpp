// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/handles/internal/flow_longitudes.h>

#include <meridian/base/Progress_observer.h>
#include <meridian/curves/chords.h>
#include <meridian/curves/flow_lines.h>
#include <meridian/field/Field.h>
#include <meridian/field/order_surface.h>
#include <meridian/surface/Closed_model.h>
#include <meridian/surface/root_edges.h>

#include <limits>

namespace meridian {

namespace internal {

Flow_longitudes::Flow_longitudes(const Triangle_surface& root, const Ordered_surface& m, const Morse_complex& complex,
                                 Normal_curves& curves, const std::vector<std::pair<Index, Index>>& saddles,
                                 double longer, const Solvers& solvers)
  : m_root(root), m_ordered(m), m_curves(curves), m_saddles(saddles), m_complex(complex), m_longer(longer),
    m_solvers(solvers), m_critical(find_critical_points(m.surface, m.rank))
{
  if (static_cast<int>(saddles.size()) > few) { return; }
  m_fields = std::make_unique<Two_point_fields>(root, m_solvers.symmetric);
  m_whole.surface = root;
  for (Index v = 0; v < root.number_of_vertices(); ++v) { m_whole.vertex_of.push_back(v); }
  for (Index f = 0; f < root.number_of_faces(); ++f) { m_whole.face_of.push_back(f); }
}

bool Flow_longitudes::add(Index i, const Crossing_loop& arc, Generator_pair& pair)
{
  // Both lines of the meridian's saddle may come to one end in the field itself.
  if (m_fields)
    for (bool descend : {false, true})
    {
      Flow_tracer tracer(m_ordered, descend, m_critical);
      if (take(i, find_flow_loops(m_curves, m_whole, m_ordered, {m_saddles[i].first}, tracer), m_ordered, m_whole, arc,
               pair))
      {
        return true;
      }
    }
  const Index low = pair.meridian.saddle;
  const Index across = farthest_on(arc, low);
  if (!m_fields) { return add_on_patch(i, arc, low, across, pair); }
  // The saddle becomes the minimum of a field; the maximum is where the shortest flow line from it comes to or, for
  // the second iteration, across the handle.
  for (Index high : {nearest_critical(m_saddles[i].first), across})
  {
    Ordered_surface h;
    if (high < 0 || !m_fields->order(low, high, h)) { continue; }
    if (take_all(i, h, m_whole, arc, pair)) { return true; }
  }
  return false;
}

Index Flow_longitudes::farthest_on(const Crossing_loop& arc, Index from) const
{
  Index best = -1;
  for (const auto& step : arc.steps)
  {
    const Index v = m_root.source(step.halfedge);
    if (best < 0
        || distance(m_root.points[v], m_root.points[from]) > distance(m_root.points[best], m_root.points[from]))
    {
      best = v;
    }
  }
  return best;
}

Index Flow_longitudes::nearest_critical(Index saddle) const
{
  double least = std::numeric_limits<double>::infinity();
  Index best = -1;
  for (const Complex_edge& e : m_complex.edges)
  {
    const Flow_line& line = m_complex.lines[e.line];
    if (m_ordered.graph.node[line.start] != m_ordered.graph.node[saddle] || !(e.length < least)) { continue; }
    least = e.length;
    best = root_vertex(m_root, m_ordered.surface, line.end);
  }
  return best;
}

bool Flow_longitudes::add_on_patch(Index i, const Crossing_loop& arc, Index low, Index high, Generator_pair& pair)
{
  std::vector<Index> faces;
  for (Index x : m_curves.crossings(2 * i)) { faces.push_back(face_after(m_curves, x)); }
  for (const auto& step : arc.steps) { faces.push_back(m_root.face(step.halfedge)); }
  const Surface_patch patch =
    cut_patch(m_root, faces, faces.front(), reach * arc.length, share * m_root.number_of_faces() / m_saddles.size());
  if (!patch.vertex.count(low) || !patch.vertex.count(high) || low == high) { return false; }
  Order_options options;
  options.solvers = m_solvers;
  options.minima = {patch.vertex.at(low)};
  options.maxima = {patch.vertex.at(high)};
  const Closed_model g = make_closed_model(patch.surface);
  if (g.node[options.minima.front()] == g.node[options.maxima.front()]) { return false; }
  const Ordered_surface h = order_surface(patch.surface, options, run_unwatched);
  return take_all(i, h, patch, arc, pair);
}

bool Flow_longitudes::take_all(Index i, const Ordered_surface& h, const Surface_patch& patch, const Crossing_loop& arc,
                               Generator_pair& pair)
{
  const auto critical = find_critical_points(h.surface, h.rank);
  std::vector<Index> saddles;
  for (const Critical_point& p : critical)
  {
    if (p.kind == Critical_kind::SADDLE) { saddles.push_back(p.vertex); }
  }
  Flow_tracer tracer(h, true, critical);
  return take(i, find_flow_loops(m_curves, patch, h, saddles, tracer), h, patch, arc, pair);
}

bool Flow_longitudes::take(Index i, const std::vector<Flow_loop>& loops, const Ordered_surface& h,
                           const Surface_patch& patch, const Crossing_loop& arc, Generator_pair& pair)
{
  for (const Flow_loop& loop : loops)
  {
    if (loop.length > m_longer * arc.length) { return false; }
    if (!try_loop(m_curves, 2 * i + 1, loop.steps)) { continue; }
    pair.longitude.method = Curve_method::FLOW;
    pair.longitude.was_flow = true;
    pair.longitude.saddle = loop.saddle;
    for (const auto& step : loop.steps)
      for (Index v : {m_root.source(step.halfedge), m_root.target(step.halfedge)})
        pair.longitude.field.emplace(v, h.field(h.graph.node[patch.vertex.empty() ? v : patch.vertex.at(v)]));
    return true;
  }
  return false;
}

} // namespace internal

} // namespace meridian
