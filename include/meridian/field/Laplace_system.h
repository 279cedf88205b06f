// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FIELD_LAPLACE_SYSTEM_H
#define MERIDIAN_FIELD_LAPLACE_SYSTEM_H

#include <meridian/surface/Closed_model.h>

#include <cmath>
#include <string>

namespace meridian {
namespace internal {

// Dirichlet problems on sets of nodes of one graph.
template <class SolverTraits> class Laplace_system
{
public:
  Laplace_system(const Closed_model& graph, const std::vector<double>& weights)
    : m_graph(graph), m_weights(weights), m_row(graph.number_of_nodes, -1)
  {}

  const Closed_model& graph() const { return m_graph; }

  // Writes the solution at the nodes `unknown` to `x`; `known(a)` is the value at any other node next to them.
  template <class Known> void solve(const std::vector<Index>& unknown, const Known& known, std::vector<double>& x)
  {
    solve<1>(
      unknown, [&](Index a) { return std::array<double, 1>{known(a)}; },
      [&](Index a, int, double value) { x[a] = value; });
  }

  // The same for several right-hand sides with one factorization; `write(a, i, value)` receives the solutions.
  template <std::size_t Sides, class Known, class Write>
  void solve(const std::vector<Index>& unknown, const Known& known, const Write& write)
  {
    if (unknown.empty()) { return; }
    const std::size_t n = unknown.size();
    for (std::size_t i = 0; i < n; ++i) { m_row[unknown[i]] = static_cast<Index>(i); }
    using Vector = typename SolverTraits::Vector;
    typename SolverTraits::Matrix a(n);
    std::vector<Vector> right(Sides, Vector(n));
    for (std::size_t i = 0; i < n; ++i)
    {
      double diagonal = 0;
      std::array<double, Sides> sum{};
      for (Index e = m_graph.begin[unknown[i]]; e < m_graph.begin[unknown[i] + 1]; ++e)
      {
        const double w = m_weights[m_graph.halfedge[e]];
        const Index neighbor = m_graph.neighbor[e];
        diagonal += w;
        if (m_row[neighbor] >= 0)
        {
          a.set_coef(i, m_row[neighbor], -w, true);
          continue;
        }
        const std::array<double, Sides> value = known(neighbor);
        for (std::size_t k = 0; k < Sides; ++k) { sum[k] += w * value[k]; }
      }
      a.set_coef(i, i, diagonal, true);
      for (std::size_t k = 0; k < Sides; ++k) { right[k][i] = sum[k]; }
    }
    for (Index node : unknown) { m_row[node] = -1; }

    SolverTraits solver;
    double denominator = 1;
    const bool is_factored = solver.factor(a, denominator);
    for (std::size_t k = 0; k < Sides; ++k)
    {
      Vector solution(n);
      if (!is_factored || !solver.linear_solver(right[k], solution))
        throw Solver_error("the system of " + std::to_string(n)
                           + " equations cannot be factorized; the symmetric positive weights are the safest");
      for (std::size_t i = 0; i < n; ++i)
      {
        const double value = solution[i] / denominator;
        if (!std::isfinite(value))
          throw Solver_error("the solution of the system is not finite; the symmetric positive weights are the safest");
        write(unknown[i], static_cast<int>(k), value);
      }
    }
  }

private:
  const Closed_model& m_graph;
  const std::vector<double>& m_weights;
  std::vector<Index> m_row; // the equation of a node, -1 where it is known
};

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_FIELD_LAPLACE_SYSTEM_H
