#include "pipeline.h"

#include "instances.h"

#include <meridian/handles/classify_generators.h>

namespace pipeline {

Cut cut(const Triangle_surface& s, const Cut_options& options) { return cut_to_disc(s, options); }

Scalar_field harmonic(const Triangle_surface& s, const Closed_model& g, const std::vector<Dirichlet_value>& prescribed,
                      Weights weights)
{
  const auto w = edge_weights(s, weights);
  return weights == Weights::MEAN_VALUE ? solve_harmonic_field<General_solver_traits>(s, g, w, prescribed)
                                        : solve_harmonic_field<Symmetric_solver_traits>(s, g, w, prescribed);
}

Generators generators(const Triangle_surface& s, const Generator_options& options)
{
  return find_generators(s, options);
}

Homology_basis basis(const Triangle_surface& s, const Basis_options& options)
{
  return find_shortest_basis(s, options);
}

Generators classified(const Triangle_surface& s, const Generator_options& options)
{
  Generators g = find_generators(s, options);
  classify_generators(s, g);
  return g;
}

Ordered_surface order(const Triangle_surface& root, const std::vector<double>& field, bool simplify)
{
  Ordered_surface m;
  m.surface = divide_chords(root);
  m.graph = make_closed_model(m.surface);
  m.field = Scalar_field(m.graph.number_of_nodes);
  for (Index a = 0; a < m.graph.number_of_nodes; ++a)
  {
    const Index v = m.graph.representative[a];
    if (v < root.number_of_vertices())
    {
      m.field.value[a] = field[v];
      continue;
    }
    const Origin o = m.surface.origin(v);
    m.field.value[a] = (field[o.index[0]] + field[o.index[1]]) / 2;
  }
  m.order = order_nodes(m.graph, m.field);
  if (simplify) { simplify_order(m.graph, m.order, {m.order.nodes.front()}, {m.order.nodes.back()}); }
  for (Index a : m.graph.node) { m.rank.push_back(m.order.rank[a]); }
  m.critical = find_critical_points(m.surface, m.rank);
  unfold_saddles(root, m);
  return m;
}

Parameterization map(const Triangle_surface& disc, const Map_options& options)
{
  return parameterize_disc(disc, options);
}

Unwrapping unwrap(const Triangle_surface& s, const Unwrap_options& options) { return unwrap_surface(s, options); }

Run run(const Polygon_soup& soup, bool repair, const Cut_options& options)
{
  Run r;
  r.examination = examine_surface(soup, repair);
  for (const auto& c : r.examination.components) { r.cuts.push_back(cut_to_disc(c.surface, options)); }
  r.assembled = assemble_result(soup, r.examination, r.cuts);
  r.verification = verify_cut(soup, r.assembled.mesh);
  return r;
}

} // namespace pipeline
