// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/field/order_surface.h>

#include <meridian/base/exceptions.h>
#include <meridian/field/Node_order.h>
#include <meridian/field/critical_points.h>
#include <meridian/field/edge_weights.h>
#include <meridian/field/intrinsic_delaunay.h>
#include <meridian/field/solve_harmonic_field.h>
#include <meridian/surface/check_surface.h>
#include <meridian/surface/measures.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace meridian {

Field_summary summarize_field(const Triangle_surface& root, const Ordered_surface& m, const Field_options& options)
{
  Field_summary f;
  f.field_kind = options.values.empty() ? "harmonic" : options.values_name;
  f.critical = m.critical;
  f.counts = count(m.critical);
  for (Critical_point& p : f.critical)
  {
    if (p.vertex >= root.number_of_vertices()) { p.vertex = -1; }
  }
  f.order_rounds = m.order.rounds;
  f.order_numbered = m.order.numbered;
  f.flat_regions = static_cast<int>(m.field.regions.size()) - 1;
  for (Index v = 0; v < root.number_of_vertices(); ++v) { f.field.push_back(m.field(m.graph.node[v])); }
  return f;
}

void order_by_field(const Triangle_surface& root, Ordered_surface& m, const std::vector<Index>& minima,
                    const std::vector<Index>& maxima)
{
  m.order = order_nodes(m.graph, m.field);
  if (!minima.empty()) { simplify_order(m.graph, m.order, minima, maxima); }
  m.rank.clear();
  for (Index a : m.graph.node) { m.rank.push_back(m.order.rank[a]); }
  m.critical = find_critical_points(m.surface, m.rank);
  unfold_saddles(root, m);
}

namespace internal {

Scalar_field field_of_values(const Triangle_surface& root, const Refined_surface& s, const Closed_model& g,
                             const std::vector<double>& values)
{
  check_values(root, values, "the field");
  Scalar_field field(g.number_of_nodes);
  std::vector<int> count(g.number_of_nodes, 0);
  for (Index v = 0; v < s.number_of_vertices(); ++v)
  {
    const Origin o = s.origin(v);
    const double x = o.kind == Origin::EDGE
                       ? values[o.index[0]] + o.weight[0] * (values[o.index[1]] - values[o.index[0]])
                       : values[o.index[0]];
    double& mean = field.value[g.node[v]];
    mean += (x - mean) / ++count[g.node[v]];
  }
  return field;
}

} // namespace internal

namespace {

// Writes the extrema that may stay: all minima, of the field if none are given, and the highest of the maxima.
void keep_one_maximum(const Ordered_surface& m, std::vector<Index>& minima, std::vector<Index>& maxima)
{
  const Node_order order = order_nodes(m.graph, m.field);
  const auto lower = [&](Index a, Index b) { return order.rank[a] < order.rank[b]; };
  if (minima.empty())
    for (Index a = 0; a < m.graph.number_of_nodes; ++a)
    {
      bool is_lowest = true;
      for (Index i = m.graph.begin[a]; i < m.graph.begin[a + 1]; ++i)
      {
        is_lowest = is_lowest && !lower(m.graph.neighbor[i], a);
      }
      if (is_lowest) { minima.push_back(a); }
    }
  maxima = {maxima.empty() ? order.nodes.back() : *std::max_element(maxima.begin(), maxima.end(), lower)};
}

} // namespace

Ordered_surface order_surface(const Triangle_surface& root, const Field_options& options, const Run_stage& run)
{
  check(root, options);
  Ordered_surface m;
  std::vector<Dirichlet_value> prescribed;
  std::vector<Index> minima, maxima;
  run(Stage::EXTREMA, [&] {
    m.surface = divide_chords(root);
    m.graph = make_closed_model(m.surface);
    if (options.minima.empty() && options.maxima.empty() && options.values.empty())
    {
      const auto [a, b] = find_distant_nodes(m.surface, m.graph);
      minima = {std::min(a, b)};
      maxima = {std::max(a, b)};
    }
    for (Index v : options.minima) { minima.push_back(m.graph.node[v]); }
    for (Index v : options.maxima) { maxima.push_back(m.graph.node[v]); }
    for (auto* nodes : {&minima, &maxima})
    {
      std::sort(nodes->begin(), nodes->end());
      nodes->erase(std::unique(nodes->begin(), nodes->end()), nodes->end());
    }
    for (Index a : maxima)
      if (std::binary_search(minima.begin(), minima.end(), a))
        throw Invalid_input_error(
          "a minimum and a maximum of the field lie on "
          + std::string(m.graph.is_loop(a) ? "one boundary loop, which is one place of the field" : "the same vertex")
          + " (vertex " + std::to_string(m.graph.representative[a]) + "); choose them apart");
    for (Index a : minima) { prescribed.push_back({a, 0}); }
    for (Index a : maxima) { prescribed.push_back({a, 1}); }
  });
  run(Stage::FIELD, [&] {
    if (!options.values.empty())
    {
      m.field = internal::field_of_values(root, m.surface, m.graph, options.values);
      return;
    }
    if (options.weights == Weights::INTRINSIC_DELAUNAY)
    {
      const Weighted_graph joined = make_intrinsic_delaunay_graph(m.surface);
      m.field =
        solve_harmonic_field(m.surface, m.graph, joined.graph, joined.weights, prescribed, options.solvers.symmetric);
      return;
    }
    const auto weights = edge_weights(m.surface, options.weights);
    m.field = solve_harmonic_field(m.surface, m.graph, weights, prescribed,
                                   options.weights == Weights::MEAN_VALUE ? options.solvers.general
                                                                          : options.solvers.symmetric);
  });
  run(Stage::ORDER, [&] {
    if (options.one_maximum && maxima.size() != 1) { keep_one_maximum(m, minima, maxima); }
    order_by_field(root, m, minima, maxima);
  });
  return m;
}

} // namespace meridian
