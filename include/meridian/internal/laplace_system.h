// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_INTERNAL_LAPLACE_SYSTEM_H
#define MERIDIAN_INTERNAL_LAPLACE_SYSTEM_H

#include <meridian/Node_graph.h>

#include <CGAL/number_utils.h>

#include <cmath>
#include <string>

namespace meridian {
namespace internal {

// Dirichlet problems on sets of nodes of one graph.
template <class SolverTraits>
class Laplace_system
{
public:
  Laplace_system(const Node_graph& graph, const std::vector<double>& weights)
    : m_graph(graph), m_weights(weights), m_row(graph.number_of_nodes, -1) {}

  // Writes the solution at the nodes `unknown` to `x`; `known(a)` is the value at any other node next to them.
  template <class Known>
  void solve(const std::vector<Index>& unknown, const Known& known, std::vector<double>& x)
  {
    if (unknown.empty()) { return; }
    const std::size_t n = unknown.size();
    for (std::size_t i = 0; i < n; ++i) { m_row[unknown[i]] = static_cast<Index>(i); }
    typename SolverTraits::Matrix a(n);
    typename SolverTraits::Vector b(n), solution(n);
    for (std::size_t i = 0; i < n; ++i)
    {
      double diagonal = 0, right = 0;
      for (Index e = m_graph.begin[unknown[i]]; e < m_graph.begin[unknown[i] + 1]; ++e)
      {
        const double w = m_weights[m_graph.halfedge[e]];
        const Index neighbor = m_graph.neighbor[e];
        diagonal += w;
        if (m_row[neighbor] < 0) { right += w * known(neighbor); }
        else { a.set_coef(i, m_row[neighbor], -w, true); }
      }
      a.set_coef(i, i, diagonal, true);
      b[i] = right;
    }
    for (Index node : unknown) { m_row[node] = -1; }

    SolverTraits solver;
    double denominator = 1;
    if (!solver.factor(a, denominator) || !solver.linear_solver(b, solution))
      throw Solver_error("solve_harmonic_field: the system of " + std::to_string(n)
                         + " equations cannot be factorized; the positive weights always can be");
    for (std::size_t i = 0; i < n; ++i)
    {
      const double value = solution[i] / denominator;
      if (!std::isfinite(value))
        throw Solver_error("solve_harmonic_field: the solution is not finite; the positive weights always give a finite one");
      x[unknown[i]] = value;
    }
  }

private:
  const Node_graph& m_graph;
  const std::vector<double>& m_weights;
  std::vector<Index> m_row; // the equation of a node, -1 where it is known
};

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_INTERNAL_LAPLACE_SYSTEM_H
