// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/field/Two_point_fields.h>

#include <meridian/field/Scalar_field.h>
#include <meridian/field/edge_weights.h>
#include <meridian/field/order_surface.h>
#include <meridian/surface/Closed_model.h>

#include <cmath>
#include <vector>

namespace meridian {

namespace internal {

Two_point_fields::Two_point_fields(const Triangle_surface& root, Make_solver make_solver)
  : m_root(root), m_solver(make_solver())
{
  m_base.surface = divide_chords(root);
  m_base.graph = make_closed_model(m_base.surface);
  const Closed_model& g = m_base.graph;
  const auto weights = edge_weights(m_base.surface, Weights::POSITIVE);
  Sparse_matrix a(g.number_of_nodes - 1);
  for (Index i = 0; i + 1 < g.number_of_nodes; ++i) // the last node is pinned
  {
    double diagonal = 0;
    for (Index e = g.begin[i]; e < g.begin[i + 1]; ++e)
    {
      diagonal += weights[g.halfedge[e]];
      if (g.neighbor[e] + 1 < g.number_of_nodes) { a.add(g.neighbor[e], -weights[g.halfedge[e]]); }
    }
    a.add(i, diagonal);
    a.end_row();
  }
  m_is_factored = m_solver->factor(a);
}

bool Two_point_fields::order(Index low, Index high, Ordered_surface& m)
{
  const Index p = m_base.graph.node[low], q = m_base.graph.node[high], n = m_base.graph.number_of_nodes - 1;
  if (p == q || !m_is_factored) { return false; }
  std::vector<double> b(n, 0), x;
  if (p < n) { b[p] = -1; }
  if (q < n) { b[q] = 1; }
  if (!m_solver->solve(b, x)) { return false; }
  m = m_base;
  m.field = Scalar_field(n + 1);
  const double at_low = p < n ? x[p] : 0, range = (q < n ? x[q] : 0) - at_low;
  for (Index i = 0; i <= n; ++i)
  {
    m.field.value[i] = ((i < n ? x[i] : 0) - at_low) / range;
    if (!std::isfinite(m.field.value[i])) { return false; }
  }
  order_by_field(m_root, m, {p}, {q});
  return true;
}

} // namespace internal

} // namespace meridian
