// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FIELD_INTERNAL_SHIFTED_LAPLACIAN_H
#define MERIDIAN_FIELD_INTERNAL_SHIFTED_LAPLACIAN_H

#include <meridian/field/Sparse_solver.h>
#include <meridian/surface/Closed_model.h>

#include <Eigen/Core>

#include <cmath>
#include <string>

namespace meridian {
namespace internal {

// The inverse of M^(-1/2) L M^(-1/2) + shift, on the complement of the constant function and of what was excluded. The
// matrix operation of Spectra's symmetric solvers. Weights and masses are divided by the median diagonal of L and the
// sum of the masses: so the lowest eigenvalue of a round surface is about 10 (4 pi^2 on a flat torus of squares with
// weights 1), and the shift lies well below it.
class Shifted_laplacian
{
public:
  using Scalar = double;
  static constexpr double shift = 1e-2;

  Shifted_laplacian(const Closed_model& g, const std::vector<double>& weights, const std::vector<double>& mass,
                    Make_solver make_solver)
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
        if (g.neighbor[i] != row) { a.add(row, g.neighbor[i], -weights[g.halfedge[i]] / unit); }
      a.add(row, row, diagonal[row] / unit + shift * m);
    }
    if (!m_solver->factor(a))
      throw Solver_error("the Laplacian of " + std::to_string(n)
                         + " nodes cannot be factorized; the symmetric positive weights are the safest");
    m_excluded.push_back(m_root.normalized());
  }

  Eigen::Index rows() const { return m_root.size(); }
  Eigen::Index cols() const { return m_root.size(); }
  void set_shift(double) {} // it is fixed, so that one factorization serves several solvers
  double total_mass() const { return m_total_mass; }

  void perform_op(const double* in, double* out) const
  {
    Eigen::Map<Eigen::VectorXd> y(out, rows());
    y = Eigen::Map<const Eigen::VectorXd>(in, rows());
    project(y);
    y = m_root.cwiseProduct(solve(m_root.cwiseProduct(y)));
    project(y);
  }

  // Lets the operation work on the complement of a unit vector.
  void exclude(const Eigen::VectorXd& y) { m_excluded.push_back(y); }

  // The function on the nodes that belongs to a vector, up to its length. It is solved for once more rather than
  // divided by roots of masses, which may be tiny.
  std::vector<double> function_of(const Eigen::VectorXd& y) const
  {
    const Eigen::VectorXd x = solve(m_root.cwiseProduct(y));
    return std::vector<double>(x.data(), x.data() + x.size());
  }

private:
  void project(Eigen::Map<Eigen::VectorXd>& y) const
  {
    for (const auto& x : m_excluded) { y -= x.dot(y) * x; }
  }

  Eigen::VectorXd solve(const Eigen::VectorXd& right) const
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

  Eigen::VectorXd m_root; // of the masses
  double m_total_mass = 0;
  std::vector<Eigen::VectorXd> m_excluded; // orthonormal
  std::unique_ptr<Sparse_solver> m_solver;
  mutable std::vector<double> m_right, m_solution; // Spectra's operations are const
};

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_FIELD_INTERNAL_SHIFTED_LAPLACIAN_H
