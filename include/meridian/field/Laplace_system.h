// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FIELD_LAPLACE_SYSTEM_H
#define MERIDIAN_FIELD_LAPLACE_SYSTEM_H

#include <meridian/base/vectors.h>
#include <meridian/field/Sparse_solver.h>
#include <meridian/surface/Closed_model.h>

#include <functional>
#include <string>
#include <vector>

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

  Laplace_system(Closed_model&& graph, const std::vector<double>& weights,
                 Make_solver make_solver = make_symmetric_solver) = delete;
  Laplace_system(const Closed_model& graph, std::vector<double>&& weights,
                 Make_solver make_solver = make_symmetric_solver) = delete;

  const Closed_model& graph() const { return m_graph; }
  // Of the last solution: see `Sparse_solver`
  double residual() const { return m_residual; }
  const std::string& description() const { return m_description; }

  // Writes the solution at the nodes `unknown` to `x`; `known(a)` is the value at any other node next to them.
  // `source`: the right-hand side of each node's equation, 0 if empty.
  void solve(const std::vector<Index>& unknown, const std::function<double(Index)>& known, std::vector<double>& x,
             const std::vector<double>& source = {});

  // The same for several right-hand sides with one factorization.
  void solve(const std::vector<Index>& unknown, int sides, const Known_values& known, const Write& write,
             const std::vector<double>& source = {});

private:
  Sparse_matrix assemble(const std::vector<Index>& unknown, const Known_values& known,
                         std::vector<std::vector<double>>& right);

  const Closed_model& m_graph;
  const std::vector<double>& m_weights;
  Make_solver m_make_solver;
  double m_residual = 0;
  std::string m_description;
  std::vector<Index> m_row; // the equation of a node, -1 where it is known
};

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_FIELD_LAPLACE_SYSTEM_H
