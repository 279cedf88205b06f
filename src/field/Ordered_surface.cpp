// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/field/Ordered_surface.h>

#include <meridian/surface/Surface_curve.h>
#include <meridian/surface/insert_curves.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

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

namespace internal {

namespace {

// Unfolds the multiple saddles of one surface, then makes its graph, field and order anew.
class Saddle_unfolder
{
public:
  Saddle_unfolder(const Triangle_surface& root, Ordered_surface& m) : m_root(root), m_ordered(m) {}

  void unfold()
  {
    for (const Critical_point& p : m_ordered.critical)
    {
      if (p.kind == Critical_kind::SADDLE && p.multiplicity >= 2) { divide_star(p.vertex); }
    }
    if (!m_added.empty()) { insert_into_order(); }
  }

private:
  static constexpr double ring = 0.25; // where on its edges the ring lies
  struct Spoke
  {
    Index halfedge;
    bool higher;
  };
  struct Value
  {
    double value;
    Index region;
  };
  // The new vertices that come right before and after a node.
  struct Added
  {
    std::vector<Index> below, above;
  };

  // The halfedges that leave a saddle, in their order, from the first of a valley on.
  std::vector<Spoke> spokes_of(Index saddle) const
  {
    const Ordered_surface& m = m_ordered;
    std::vector<Spoke> spokes;
    for_each_around_node(m.surface, saddle, [&](Index h) {
      spokes.push_back({h, m.rank[m.surface.target(h)] > m.rank[saddle]});
    });
    const std::size_t n = spokes.size();
    std::size_t start = 0;
    while (spokes[start].higher || !spokes[(start + n - 1) % n].higher) { ++start; }
    std::rotate(spokes.begin(), spokes.begin() + start, spokes.end());
    return spokes;
  }

  // The value where a spoke of a saddle meets the ring.
  Value value_on(const Spoke& spoke, Index saddle) const
  {
    const Ordered_surface& m = m_ordered;
    const Index node = m.graph.node[saddle];
    // A target that was itself added lies next to the node it was added for.
    const Index w = m.surface.target(spoke.halfedge);
    const bool is_new = w >= static_cast<Index>(m.graph.node.size());
    const Index rw = is_new ? m_new_value.at(w).region : m.field.region_of(m.graph.node[w]);
    const Index r = std::max(rw, m.field.region_of(node));
    const double at_node = m.field.value_in(r, node);
    const double at_target = m.field.convert(is_new ? m_new_value.at(w).value : m.field.value[m.graph.node[w]], rw, r);
    return {at_node + ring * (at_target - at_node), r};
  }

  // Inserts the ring around a saddle. Its vertices in two valleys come before it, those of further valleys and the
  // peaks after it.
  void divide_star(Index saddle)
  {
    Ordered_surface& m = m_ordered;
    const std::vector<Spoke> spokes = spokes_of(saddle);
    Surface_curve curve;
    curve.closed = true;
    std::vector<Value> values;
    for (const Spoke& k : spokes)
    {
      curve.points.push_back(Curve_point::on_edge(m.surface.opposite[k.halfedge], 1 - ring));
      values.push_back(value_on(k, saddle));
    }
    const std::vector<Index> vertices = insert_curves(m_root, m.surface, {curve}, false).vertices.front();
    auto& [below, above] = m_added[m.graph.node[saddle]];
    std::vector<Index> valleys_above, peaks;
    int valley = 0;
    for (std::size_t i = 0; i < spokes.size(); ++i)
    {
      if (!spokes[i].higher && (i == 0 || spokes[i - 1].higher)) { ++valley; }
      (spokes[i].higher ? peaks : valley <= 2 ? below : valleys_above).push_back(vertices[i]);
      m_new_value[vertices[i]] = values[i];
      m.rank.push_back(m.rank[saddle]); // compares like the node with everything outside its star
    }
    above = std::move(valleys_above);
    above.insert(above.end(), peaks.begin(), peaks.end());
  }

  void insert_into_order()
  {
    Ordered_surface& m = m_ordered;
    const Closed_model graph = std::move(m.graph);
    const Scalar_field field = std::move(m.field);
    const Node_order order = std::move(m.order);
    m.graph = make_closed_model(m.surface);
    m.field = Scalar_field(m.graph.number_of_nodes);
    m.field.regions = field.regions;
    m.field.region.assign(m.graph.number_of_nodes, 0);
    m.order = Node_order();
    m.order.rounds = order.rounds;
    m.order.numbered = order.numbered;
    for (Index a : order.nodes)
    {
      const auto extra = m_added.find(a);
      if (extra != m_added.end()) { append_new(extra->second.below); }
      append(graph.representative[a], {field.value[a], field.region_of(a)});
      if (extra != m_added.end()) { append_new(extra->second.above); }
    }
    rank_all();
  }

  // Appends the node of a vertex to the order.
  void append(Index v, const Value& value)
  {
    const Index node = m_ordered.graph.node[v];
    m_ordered.order.nodes.push_back(node);
    m_ordered.field.value[node] = value.value;
    m_ordered.field.region[node] = value.region;
  }
  void append_new(const std::vector<Index>& vertices)
  {
    for (Index v : vertices) { append(v, m_new_value.at(v)); }
  }

  void rank_all()
  {
    Ordered_surface& m = m_ordered;
    m.order.rank.resize(m.graph.number_of_nodes);
    for (Index i = 0; i < m.graph.number_of_nodes; ++i) { m.order.rank[m.order.nodes[i]] = i; }
    m.rank.resize(m.surface.number_of_vertices());
    for (Index v = 0; v < m.surface.number_of_vertices(); ++v) { m.rank[v] = m.order.rank[m.graph.node[v]]; }
  }

  const Triangle_surface& m_root;
  Ordered_surface& m_ordered;
  std::map<Index, Added> m_added;     // by node
  std::map<Index, Value> m_new_value; // by new vertex
};

} // namespace

} // namespace internal

void unfold_saddles(const Triangle_surface& root, Ordered_surface& m) { internal::Saddle_unfolder(root, m).unfold(); }

} // namespace meridian
