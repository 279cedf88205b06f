#include "pipeline.h"

#include <meridian/base/Polygon_soup.h>
#include <meridian/base/vectors.h>
#include <meridian/cut/Cut.h>
#include <meridian/cut/Cut_options.h>
#include <meridian/cut/cut_to_disc.h>
#include <meridian/field/Node_order.h>
#include <meridian/field/Ordered_surface.h>
#include <meridian/field/Scalar_field.h>
#include <meridian/field/critical_points.h>
#include <meridian/field/edge_weights.h>
#include <meridian/field/solve_harmonic_field.h>
#include <meridian/handles/Generators.h>
#include <meridian/handles/classify_generators.h>
#include <meridian/handles/find_generators.h>
#include <meridian/handles/find_shortest_basis.h>
#include <meridian/map/Parameterization.h>
#include <meridian/map/parameterize_disc.h>
#include <meridian/proof/verify_cut.h>
#include <meridian/result/assemble_result.h>
#include <meridian/result/recount.h>
#include <meridian/surface/Closed_model.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/examine_surface.h>
#include <meridian/unwrap/Unwrapping.h>
#include <meridian/unwrap/internal/Unwrapper.h>
#include <meridian/unwrap/unwrap_surface.h>

namespace pipeline {

Cut cut(const Triangle_surface& s, const Cut_options& options) { return cut_to_disc(s, options); }

Scalar_field harmonic(const Triangle_surface& s, const Closed_model& g, const std::vector<Dirichlet_value>& prescribed,
                      Weights weights)
{
  const auto w = edge_weights(s, weights);
  return weights == Weights::MEAN_VALUE ? solve_harmonic_field(s, g, w, prescribed, make_general_solver)
                                        : solve_harmonic_field(s, g, w, prescribed);
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
