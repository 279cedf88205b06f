// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FIELD_LAPLACE_SYSTEM_H
#define MERIDIAN_FIELD_LAPLACE_SYSTEM_H

#include <meridian/field/Sparse_solver.h>
#include <meridian/surface/Closed_model.h>

#include <cmath>
#include <functional>
#include <string>

namespace meridian {
namespace internal {

// Dirichlet problems on sets of nodes of one graph.
class Laplace_system
{
public:
  // `known(a, values)` writes the values at a node that is known, one a side.
  using Known_values = std::function<void(Index, double*)>;
  // `write(a, side, value)` receives a solution.
  using Write = std::function<void(Index, int, double)>;

  Laplace_system(const Closed_model& graph, const std::vector<double>& weights,
                 Make_solver make_solver = make_symmetric_solver)
    : m_graph(graph), m_weights(weights), m_make_solver(make_solver), m_row(graph.number_of_nodes, -1)
  {}

  const Closed_model& graph() const { return m_graph; }

  // Writes the solution at the nodes `unknown` to `x`; `known(a)` is the value at any other node next to them.
  void solve(const std::vector<Index>& unknown, const std::function<double(Index)>& known, std::vector<double>& x)
  {
    solve(
      unknown, 1, [&](Index a, double* value) { *value = known(a); },
      [&](Index a, int, double value) { x[a] = value; });
  }

  // The same for several right-hand sides with one factorization.
  void solve(const std::vector<Index>& unknown, int sides, const Known_values& known, const Write& write)
  {
    if (unknown.empty()) { return; }
    const std::size_t n = unknown.size();
    std::vector<std::vector<double>> right(sides, std::vector<double>(n));
    const Sparse_matrix a = assemble(unknown, known, right);
    const auto solver = m_make_solver();
    const bool is_factored = solver->factor(a);
    std::vector<double> solution;
    for (int k = 0; k < sides; ++k)
    {
      if (!is_factored || !solver->solve(right[k], solution))
        throw Solver_error("the system of " + std::to_string(n)
                           + " equations cannot be factorized; the symmetric positive weights are the safest");
      for (std::size_t i = 0; i < n; ++i)
      {
        if (!std::isfinite(solution[i]))
          throw Solver_error(
            "the solution of the system is not finite; the symmetric positive weights are the safest");
        write(unknown[i], k, solution[i]);
      }
    }
  }

private:
  Sparse_matrix assemble(const std::vector<Index>& unknown, const Known_values& known,
                         std::vector<std::vector<double>>& right)
  {
    const Index n = static_cast<Index>(unknown.size());
    for (Index i = 0; i < n; ++i) { m_row[unknown[i]] = i; }
    Sparse_matrix a(n);
    std::vector<double> sum(right.size()), value(right.size());
    for (Index i = 0; i < n; ++i)
    {
      double diagonal = 0;
      std::fill(sum.begin(), sum.end(), 0);
      for (Index e = m_graph.begin[unknown[i]]; e < m_graph.begin[unknown[i] + 1]; ++e)
      {
        const double w = m_weights[m_graph.halfedge[e]];
        const Index neighbor = m_graph.neighbor[e];
        diagonal += w;
        if (m_row[neighbor] >= 0)
        {
          a.add(i, m_row[neighbor], -w);
          continue;
        }
        known(neighbor, value.data());
        for (std::size_t k = 0; k < right.size(); ++k) { sum[k] += w * value[k]; }
      }
      a.add(i, i, diagonal);
      for (std::size_t k = 0; k < right.size(); ++k) { right[k][i] = sum[k]; }
    }
    for (Index node : unknown) { m_row[node] = -1; }
    return a;
  }

  const Closed_model& m_graph;
  const std::vector<double>& m_weights;
  Make_solver m_make_solver;
  std::vector<Index> m_row; // the equation of a node, -1 where it is known
};

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_FIELD_LAPLACE_SYSTEM_H
