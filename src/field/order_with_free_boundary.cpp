// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/field/order_with_free_boundary.h>

#include <meridian/base/exceptions.h>
#include <meridian/base/vectors.h>
#include <meridian/field/Laplace_system.h>
#include <meridian/field/Scalar_field.h>
#include <meridian/field/curved_vertices.h>
#include <meridian/field/edge_weights.h>
#include <meridian/field/order_surface.h>
#include <meridian/field/solve_field.h>
#include <meridian/surface/Closed_model.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/measures.h>

#include <algorithm>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace meridian {

namespace {

// The stages on the way to an order of a filled surface.
class Free_boundary_order
{
public:
  Free_boundary_order(const Triangle_surface& root, const Filled_surface& filled, const Field_options& options,
                      const Solvers& solvers)
    : m_root(root), m_filled(filled), m_options(options), m_solvers(solvers),
      m_harmonic(std::get_if<Harmonic_field>(&options.field)), m_minima(options.minima), m_maxima(options.maxima)
  {}

  // Makes the model, and takes or finds the extrema.
  void prepare()
  {
    m_result.surface = Refined_surface(m_filled.surface);
    m_result.graph = make_closed_model(m_result.surface);
    if (m_harmonic && m_harmonic->weights == Weights::INTRINSIC_DELAUNAY)
      throw Invalid_input_error(
        "intrinsic Delaunay weights are made for the closed model; choose others where the boundary is free");
    if (m_minima.empty() && m_harmonic) { find_extrema(); }
    for (auto* nodes : {&m_minima, &m_maxima})
    {
      std::sort(nodes->begin(), nodes->end());
      nodes->erase(std::unique(nodes->begin(), nodes->end()), nodes->end());
    }
    for (Index a : m_maxima)
      if (std::binary_search(m_minima.begin(), m_minima.end(), a))
        throw Invalid_input_error("a minimum and a maximum of the field lie on the same vertex (vertex "
                                  + std::to_string(a) + "); choose them apart");
  }

  void make_field()
  {
    Given_field given = solve_field(m_root, m_options.field, m_solvers);
    m_result.field_name = std::move(given.name);
    if (m_harmonic) { solve_harmonic(); }
    else { take_values(std::move(given.values)); }
    average_over_fans();
  }

  void order() { order_by_field(m_filled.surface, m_result, m_minima, m_maxima); }

  Ordered_surface take_result() { return std::move(m_result); }

private:
  bool is_middle_of_fan(Index v) const { return v >= m_filled.vertices; } // no place of the surface

  void find_extrema()
  {
    if (m_harmonic->extrema == Extrema::CURVED)
    {
      const auto [low, high] = find_curved_vertices(m_root, 4, m_harmonic->weights, m_solvers.symmetric);
      m_minima = {low};
      m_maxima = {high};
      return;
    }
    const Triangle_surface& s = m_result.surface;
    auto [a, b] = find_distant_nodes(s, m_result.graph);
    for (Index* v : {&a, &b})
      if (is_middle_of_fan(*v)) { *v = s.target(s.outgoing[*v]); }
    if (a == b) { b = s.target(s.outgoing[a]); }
    m_minima = {std::min(a, b)};
    m_maxima = {std::max(a, b)};
  }

  void take_values(std::vector<double> values)
  {
    values.resize(m_result.surface.number_of_vertices(), 0);
    m_result.field = internal::field_of_values(m_filled.surface, m_result.surface, m_result.graph, values);
  }

  // Solves for a field that is harmonic between the extrema, over edges of the surface alone.
  void solve_harmonic()
  {
    const Triangle_surface& s = m_result.surface;
    auto weights = edge_weights(s, m_harmonic->weights);
    for (Index h = 0; h < s.number_of_halfedges(); ++h)
      if (is_middle_of_fan(s.source(h)) || is_middle_of_fan(s.target(h))) { weights[h] = 0; }
    const Closed_model& g = m_result.graph;
    Scalar_field& field = m_result.field;
    field = Scalar_field(g.number_of_nodes);
    std::vector<char> is_known(g.number_of_nodes, 0);
    for (Index v : m_minima) { is_known[v] = 1; }
    for (Index v : m_maxima)
    {
      is_known[v] = 1;
      field.value[v] = 1;
    }
    std::vector<Index> unknown;
    for (Index v = 0; v < m_filled.vertices; ++v)
    {
      if (!is_known[v]) { unknown.push_back(v); }
    }
    internal::Laplace_system system(g, weights,
                                    m_harmonic->weights == Weights::MEAN_VALUE ? m_solvers.general : m_solvers.laplace);
    system.solve(
      unknown, [&](Index a) { return field.value[a]; }, field.value);
    field.solver = system.description();
  }

  // The middle of each fan has the mean of its neighbours.
  void average_over_fans()
  {
    const Triangle_surface& s = m_result.surface;
    for (Index c = m_filled.vertices; c < s.number_of_vertices(); ++c)
    {
      double sum = 0;
      int count = 0;
      s.for_each_outgoing(c, [&](Index h) {
        sum += m_result.field.value[s.target(h)];
        ++count;
      });
      m_result.field.value[c] = sum / count;
    }
  }

  const Triangle_surface& m_root;
  const Filled_surface& m_filled;
  const Field_options& m_options;
  const Solvers& m_solvers;
  const Harmonic_field* m_harmonic; // or null
  std::vector<Index> m_minima, m_maxima;
  Ordered_surface m_result;
};

} // namespace

Ordered_surface order_with_free_boundary(const Triangle_surface& root, const Filled_surface& filled,
                                         const Field_options& options, const Solvers& solvers, const Run_stage& run)
{
  check(root, options);
  Free_boundary_order steps(root, filled, options, solvers);
  run(Stage::EXTREMA, [&] { steps.prepare(); });
  run(Stage::FIELD, [&] { steps.make_field(); });
  run(Stage::ORDER, [&] { steps.order(); });
  return steps.take_result();
}

} // namespace meridian
