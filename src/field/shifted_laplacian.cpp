// SPDX-License-Identifier: GPL-3.0-or-later
#include "shifted_laplacian.h"

#include <meridian/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace meridian {

namespace internal {

Shifted_laplacian::Shifted_laplacian(const Closed_model& g, const std::vector<double>& weights,
                                     const std::vector<double>& mass, Make_solver make_solver)
  : m_root(g.number_of_nodes), m_solver(make_solver()), m_right(g.number_of_nodes)
{
  const Index n = g.number_of_nodes;
  std::vector<double> diagonal(n, 0);
  for (Index a = 0; a < n; ++a)
  {
    for (Index i = g.begin[a]; i < g.begin[a + 1]; ++i)
    {
      if (g.neighbor[i] != a) { diagonal[a] += weights[g.halfedge[i]]; }
    }
    m_total_mass += mass[a];
  }
  std::vector<double> sorted = diagonal;
  std::nth_element(sorted.begin(), sorted.begin() + n / 2, sorted.end());
  const double unit = sorted[n / 2];
  if (!(unit > 0) || !std::isfinite(unit) || !(m_total_mass > 0) || !std::isfinite(m_total_mass))
    throw Solver_error("the weights of the Laplacian are not positive or the masses are not; the symmetric positive "
                       "weights are the safest");

  Sparse_matrix a(n);
  for (Index row = 0; row < n; ++row)
  {
    const double m = mass[row] / m_total_mass;
    m_root[row] = std::sqrt(m);
    for (Index i = g.begin[row]; i < g.begin[row + 1]; ++i)
      if (g.neighbor[i] != row) { a.add(g.neighbor[i], -weights[g.halfedge[i]] / unit); }
    a.add(row, diagonal[row] / unit + shift * m);
    a.end_row();
  }
  if (!m_solver->factor(a))
    throw Solver_error("the Laplacian of " + std::to_string(n)
                       + " nodes cannot be factorized; the symmetric positive weights are the safest");
  m_excluded.push_back(m_root.normalized());
}

void Shifted_laplacian::perform_op(const double* in, double* out) const
{
  Eigen::Map<Eigen::VectorXd> y(out, rows());
  y = Eigen::Map<const Eigen::VectorXd>(in, rows());
  project(y);
  y = m_root.cwiseProduct(solve(m_root.cwiseProduct(y)));
  project(y);
}

std::vector<double> Shifted_laplacian::function_of(const Eigen::VectorXd& y) const
{
  const Eigen::VectorXd x = solve(m_root.cwiseProduct(y));
  return std::vector<double>(x.data(), x.data() + x.size());
}

Eigen::VectorXd Shifted_laplacian::solve(const Eigen::VectorXd& right) const
{
  for (Eigen::Index i = 0; i < rows(); ++i) { m_right[i] = right[i]; }
  bool is_solved = m_solver->solve(m_right, m_solution);
  Eigen::VectorXd x(rows());
  for (Eigen::Index i = 0; i < rows() && is_solved; ++i)
  {
    x[i] = m_solution[i];
    is_solved = std::isfinite(x[i]);
  }
  if (!is_solved)
  {
    throw Solver_error(
      "the solution with the shifted Laplacian is not finite; the symmetric positive weights are the safest");
  }
  return x;
}

} // namespace internal

} // namespace meridian
