// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/field/Ordered_surface.h>

#include <meridian/surface/Surface_curve.h>
#include <meridian/surface/insert_curves.h>

#include <algorithm>
#include <map>
#include <utility>

namespace meridian {

Refined_surface divide_chords(const Triangle_surface& root)
{
  Refined_surface s(root);
  std::vector<Surface_curve> points;
  for (Index h : chords_of_loops(s, make_closed_model(s)))
  {
    points.push_back({{Curve_point::on_edge(h, 0.5)}, false});
  }
  if (!points.empty()) { insert_curves(root, s, points, false); }
  return s;
}

void unfold_saddles(const Triangle_surface& root, Ordered_surface& m)
{
  constexpr double ring = 0.25; // where on its edges the ring lies
  Refined_surface& s = m.surface;
  std::map<Index, std::pair<std::vector<Index>, std::vector<Index>>> added; // new vertices before and after a node
  std::map<Index, std::pair<double, Index>> new_value;                      // of a new vertex: value and region
  for (const Critical_point& p : m.critical)
  {
    if (p.kind != Critical_kind::SADDLE || p.multiplicity < 2) { continue; }
    struct Spoke
    {
      Index halfedge;
      bool higher;
    };
    std::vector<Spoke> spokes;
    for_each_around_node(s, p.vertex, [&](Index h) { spokes.push_back({h, m.rank[s.target(h)] > m.rank[p.vertex]}); });
    // Begin with the first spoke of a valley.
    const std::size_t n = spokes.size();
    std::size_t start = 0;
    while (spokes[start].higher || !spokes[(start + n - 1) % n].higher) { ++start; }
    std::rotate(spokes.begin(), spokes.begin() + start, spokes.end());

    Surface_curve curve;
    curve.closed = true;
    for (const Spoke& k : spokes) { curve.points.push_back(Curve_point::on_edge(s.opposite[k.halfedge], 1 - ring)); }
    const Index node = m.graph.node[p.vertex];
    std::vector<std::pair<double, Index>> values;
    for (const Spoke& k : spokes)
    {
      // A target that was itself added lies next to the node it was added for.
      const Index w = s.target(k.halfedge);
      const bool is_new = w >= static_cast<Index>(m.graph.node.size());
      const Index rw = is_new ? new_value.at(w).second : m.field.region_of(m.graph.node[w]);
      const Index r = std::max(rw, m.field.region_of(node));
      const double at_node = m.field.value_in(r, node);
      const double at_target = m.field.convert(is_new ? new_value.at(w).first : m.field.value[m.graph.node[w]], rw, r);
      values.emplace_back(at_node + ring * (at_target - at_node), r);
    }
    const std::vector<Index> vertices = insert_curves(root, s, {curve}, false).vertices.front();
    auto& [below, above] = added[node];
    std::vector<Index> valleys_above, peaks;
    int valley = 0;
    for (std::size_t i = 0; i < n; ++i)
    {
      if (!spokes[i].higher && (i == 0 || spokes[i - 1].higher)) { ++valley; }
      (spokes[i].higher ? peaks : valley <= 2 ? below : valleys_above).push_back(vertices[i]);
      new_value[vertices[i]] = values[i];
      m.rank.push_back(m.rank[p.vertex]); // compares like the node with everything outside its star
    }
    above = std::move(valleys_above);
    above.insert(above.end(), peaks.begin(), peaks.end());
  }
  if (added.empty()) { return; }

  const Closed_model old = std::move(m.graph);
  const Scalar_field field = std::move(m.field);
  const Node_order order = std::move(m.order);
  m.graph = make_closed_model(s);
  m.field = Scalar_field(m.graph.number_of_nodes);
  m.field.regions = field.regions;
  m.field.region.assign(m.graph.number_of_nodes, 0);
  m.order = Node_order();
  m.order.rounds = order.rounds;
  m.order.numbered = order.numbered;
  const auto append = [&](Index node, double value, Index region) {
    m.order.nodes.push_back(node);
    m.field.value[node] = value;
    m.field.region[node] = region;
  };
  const auto append_new = [&](Index v) { append(m.graph.node[v], new_value.at(v).first, new_value.at(v).second); };
  for (Index a : order.nodes)
  {
    const auto extra = added.find(a);
    if (extra != added.end())
    {
      for (Index v : extra->second.first) { append_new(v); }
    }
    append(m.graph.node[old.representative[a]], field.value[a], field.region_of(a));
    if (extra != added.end())
    {
      for (Index v : extra->second.second) { append_new(v); }
    }
  }
  m.order.rank.resize(m.graph.number_of_nodes);
  for (Index i = 0; i < m.graph.number_of_nodes; ++i) { m.order.rank[m.order.nodes[i]] = i; }
  m.rank.resize(s.number_of_vertices());
  for (Index v = 0; v < s.number_of_vertices(); ++v) { m.rank[v] = m.order.rank[m.graph.node[v]]; }
}

} // namespace meridian
