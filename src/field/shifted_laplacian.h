// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_SRC_FIELD_SHIFTED_LAPLACIAN_H
#define MERIDIAN_SRC_FIELD_SHIFTED_LAPLACIAN_H

#include <meridian/base/vectors.h>
#include <meridian/field/Sparse_solver.h>
#include <meridian/surface/Closed_model.h>

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace meridian {
namespace internal {

// The inverse of M^(-1/2) L M^(-1/2) + shift, on the complement of the constant function and of what was excluded.
// Weights and masses are divided by the median diagonal of L and the sum of the masses: so the lowest eigenvalue of a
// round surface is about 10 (4 pi^2 on a flat torus of squares with weights 1), and the shift lies well below it.
class Shifted_laplacian
{
public:
  static constexpr double shift = 1e-2;

  Shifted_laplacian(const Closed_model& g, const std::vector<double>& weights, const std::vector<double>& mass,
                    Make_solver make_solver);

  Eigen::Index rows() const { return m_root.size(); }
  double total_mass() const { return m_total_mass; }

  void perform_op(const double* in, double* out) const;

  // Lets the operation work on the complement of a unit vector.
  void exclude(const Eigen::VectorXd& y) { m_excluded.push_back(y); }

  // The function on the nodes that belongs to a vector, up to its length. It is solved for once more rather than
  // divided by roots of masses, which may be tiny.
  std::vector<double> function_of(const Eigen::VectorXd& y) const;

private:
  void project(Eigen::Map<Eigen::VectorXd>& y) const
  {
    for (const auto& x : m_excluded) { y -= x.dot(y) * x; }
  }

  Eigen::VectorXd solve(const Eigen::VectorXd& right) const;

  Eigen::VectorXd m_root; // of the masses
  double m_total_mass = 0;
  std::vector<Eigen::VectorXd> m_excluded; // orthonormal
  std::unique_ptr<Sparse_solver> m_solver;
  mutable std::vector<double> m_right, m_solution;
};

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_SRC_FIELD_SHIFTED_LAPLACIAN_H
