// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/field/Laplace_system.h>

#include <meridian/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace meridian {

namespace internal {

void Laplace_system::solve(const std::vector<Index>& unknown, const std::function<double(Index)>& known,
                           std::vector<double>& x, const std::vector<double>& source)
{
  solve(
    unknown, 1, [&](Index a, double* value) { *value = known(a); }, [&](Index a, int, double value) { x[a] = value; },
    source);
}

void Laplace_system::solve(const std::vector<Index>& unknown, int sides, const Known_values& known, const Write& write,
                           const std::vector<double>& source)
{
  if (unknown.empty()) { return; }
  const std::size_t n = unknown.size();
  std::vector<std::vector<double>> right(sides, std::vector<double>(n));
  const auto solver = m_make_solver();
  const bool is_factored = solver->factor(assemble(unknown, known, right)); // the matrix is gone before solving
  std::vector<double> solution;
  for (int k = 0; k < sides; ++k)
  {
    for (std::size_t i = 0; i < n && !source.empty(); ++i) { right[k][i] += source[unknown[i]]; }
    if (!is_factored || !solver->solve(right[k], solution))
      throw Solver_error("the system of " + std::to_string(n)
                         + " equations cannot be factorized; the symmetric positive weights are the safest");
    for (std::size_t i = 0; i < n; ++i)
    {
      if (!std::isfinite(solution[i]))
        throw Solver_error("the solution of the system is not finite; the symmetric positive weights are the safest");
      write(unknown[i], k, solution[i]);
    }
    m_residual = solver->residual();
    m_description = solver->description();
  }
}

Sparse_matrix Laplace_system::assemble(const std::vector<Index>& unknown, const Known_values& known,
                                       std::vector<std::vector<double>>& right)
{
  const Index n = static_cast<Index>(unknown.size());
  for (Index i = 0; i < n; ++i) { m_row[unknown[i]] = i; }
  std::size_t most = 0; // values
  for (Index node : unknown) { most += m_graph.begin[node + 1] - m_graph.begin[node] + 1; }
  Sparse_matrix a(n, most);
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
        a.add(m_row[neighbor], -w);
        continue;
      }
      known(neighbor, value.data());
      for (std::size_t k = 0; k < right.size(); ++k) { sum[k] += w * value[k]; }
    }
    a.add(i, diagonal);
    a.end_row();
    for (std::size_t k = 0; k < right.size(); ++k) { right[k][i] = sum[k]; }
  }
  for (Index node : unknown) { m_row[node] = -1; }
  return a;
}

} // namespace internal

} // namespace meridian
