// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/field/order_surface.h>

#include <meridian/base/exceptions.h>
#include <meridian/base/run_both.h>
#include <meridian/field/Node_order.h>
#include <meridian/field/critical_points.h>
#include <meridian/field/curved_vertices.h>
#include <meridian/field/edge_weights.h>
#include <meridian/field/intrinsic_delaunay.h>
#include <meridian/field/solve_field.h>
#include <meridian/field/solve_harmonic_field.h>
#include <meridian/surface/check_surface.h>
#include <meridian/surface/measures.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <variant>

namespace meridian {

Field_summary summarize_field(const Triangle_surface& root, const Ordered_surface& m)
{
  Field_summary f;
  f.field_kind = m.field_name;
  f.solver = m.field.solver;
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

std::pair<Index, Index> sorted(const std::pair<Index, Index>& ends)
{
  return {std::min(ends.first, ends.second), std::max(ends.first, ends.second)};
}

// The stages on the way to an order of a surface.
class Surface_order
{
public:
  Surface_order(const Triangle_surface& root, const Order_options& options)
    : m_root(root), m_options(options), m_harmonic(std::get_if<Harmonic_field>(&options.field))
  {}

  // Makes the model, and takes or finds the extrema.
  void prepare()
  {
    m_result.graph = make_closed_model(m_root);
    if (!chords_of_loops(m_root, m_result.graph).empty())
    {
      m_result.surface = divide_chords(m_root);
      m_result.graph = make_closed_model(m_result.surface);
    }
    internal::run_both([&] { weigh_edges(); }, [&] { choose_extrema(); });
  }

  void make_field()
  {
    Given_field given = solve_field(m_root, m_options.field, m_options.solvers);
    m_result.field_name = std::move(given.name);
    if (m_harmonic) { m_result.field = solve_harmonic(*m_harmonic); }
    m_weights = std::vector<double>();
    if (m_result.surface.triangles.empty()) { m_result.surface = Refined_surface(m_root); }
    if (!m_harmonic)
    {
      m_result.field = internal::field_of_values(m_root, m_result.surface, m_result.graph, given.values);
    }
  }

  void order()
  {
    if (m_options.one_maximum && m_maxima.size() != 1) { keep_one_maximum(m_result, m_minima, m_maxima); }
    order_by_field(m_root, m_result, m_minima, m_maxima);
  }

  Ordered_surface take_result() { return std::move(m_result); }

private:
  // The surface of the model. Where no edge is divided that is the root, of which a copy is made after the field,
  // because that is what needs the most memory.
  const Triangle_surface& surface() const { return m_result.surface.triangles.empty() ? m_root : m_result.surface; }

  // Those of the surface as it is, which are needed for the field.
  void weigh_edges()
  {
    if (!m_harmonic || m_harmonic->weights == Weights::INTRINSIC_DELAUNAY) { return; }
    m_weights = edge_weights(surface(), m_harmonic->weights);
  }

  void choose_extrema()
  {
    if (m_harmonic && m_options.minima.empty()) { find_extrema(*m_harmonic); }
    else
    {
      for (Index v : m_options.minima) { m_minima.push_back(m_result.graph.node[v]); }
      for (Index v : m_options.maxima) { m_maxima.push_back(m_result.graph.node[v]); }
    }
    for (auto* nodes : {&m_minima, &m_maxima})
    {
      std::sort(nodes->begin(), nodes->end());
      nodes->erase(std::unique(nodes->begin(), nodes->end()), nodes->end());
    }
    for (Index a : m_maxima)
      if (std::binary_search(m_minima.begin(), m_minima.end(), a))
        throw Invalid_input_error(
          "a minimum and a maximum of the field lie on "
          + std::string(m_result.graph.is_loop(a) ? "one boundary loop, which is one place of the field"
                                                  : "the same vertex")
          + " (vertex " + std::to_string(m_result.graph.representative[a]) + "); choose them apart");
  }

  void find_extrema(const Harmonic_field& field)
  {
    const Closed_model& g = m_result.graph;
    std::pair<Index, Index> ends;
    if (field.extrema == Extrema::CURVED)
    {
      const auto [low, high] = find_curved_vertices(m_root, 4, field.weights, m_options.solvers.symmetric);
      ends = {g.node[low], g.node[high]};
    }
    else { ends = sorted(find_distant_nodes(surface(), g)); }
    m_minima = {ends.first};
    m_maxima = {ends.second};
  }

  Scalar_field solve_harmonic(const Harmonic_field& field) const
  {
    const Triangle_surface& s = surface();
    const Closed_model& g = m_result.graph;
    std::vector<Dirichlet_value> prescribed;
    for (Index a : m_minima) { prescribed.push_back({a, 0}); }
    for (Index a : m_maxima) { prescribed.push_back({a, 1}); }
    const Solvers& solvers = m_options.solvers;
    if (field.weights == Weights::INTRINSIC_DELAUNAY)
    {
      const Weighted_graph joined = make_intrinsic_delaunay_graph(s);
      return solve_harmonic_field(s, g, joined.graph, joined.weights, prescribed, solvers.laplace);
    }
    const bool is_symmetric = field.weights != Weights::MEAN_VALUE;
    Scalar_field solved =
      solve_harmonic_field(s, g, m_weights, prescribed, is_symmetric ? solvers.laplace : solvers.general);
    for (Index a = 0; a < g.number_of_nodes && !is_symmetric; ++a)
    {
      if (!(solved(a) > -1e-3 && solved(a) < 1 + 1e-3))
      {
        throw Solver_error(
          "the field leaves the values of its extrema, which positive weights rule out: mean-value weights "
          "need a solver for unsymmetric systems");
      }
    }
    return solved;
  }

  const Triangle_surface& m_root;
  const Order_options& m_options;
  const Harmonic_field* m_harmonic;      // or null
  std::vector<Index> m_minima, m_maxima; // nodes
  std::vector<double> m_weights;         // of halfedges
  Ordered_surface m_result;
};

} // namespace

Ordered_surface order_surface(const Triangle_surface& root, const Order_options& options, const Run_stage& run)
{
  check(root, options);
  Surface_order steps(root, options);
  run(Stage::EXTREMA, [&] { steps.prepare(); });
  run(Stage::FIELD, [&] { steps.make_field(); });
  run(Stage::ORDER, [&] { steps.order(); });
  return steps.take_result();
}

} // namespace meridian
