// SPDX-License-Identifier: GPL-3.0-or-later
#include "bound_spectral_norm.h"

#include <meridian/field/largest_eigenpairs.h>

#include <algorithm>
#include <cmath>

namespace meridian {

namespace internal {

double bound_spectral_norm(const Eigen::SparseMatrix<double>& a)
{
  using Matrix = Eigen::SparseMatrix<double>;
  double gershgorin = 0;
  for (Eigen::Index j = 0; j < a.cols(); ++j)
  {
    double sum = 0;
    for (Matrix::InnerIterator i(a, j); i; ++i) { sum += std::abs(i.value()); }
    gershgorin = std::max(gershgorin, sum);
  }
  const Eigen::Index n = a.rows();
  if (n < 3 || !(gershgorin > 0) || !std::isfinite(gershgorin)) { return gershgorin; }

  const Matrix unit = a / gershgorin; // so that units do not matter
  const auto product = [&](const double* in, double* out) {
    Eigen::Map<Eigen::VectorXd>(out, n).noalias() =
      unit.selfadjointView<Eigen::Lower>() * Eigen::Map<const Eigen::VectorXd>(in, n);
  };
  const Eigenpairs top =
    largest_eigenpairs(static_cast<Index>(n), product, 1, static_cast<Index>(std::min<Eigen::Index>(n, 24)), 300, 5e-4);
  if (top.values.empty()) { return gershgorin; }
  const Eigen::VectorXd x = Eigen::Map<const Eigen::VectorXd>(top.vectors.front().data(), n);
  const double value = top.values.front(), residual = (unit * x - value * x).norm() / x.norm();
  const double estimate = value + residual;
  for (double margin : {1e-4, 1e-3, 1e-2})
  {
    const double bound = estimate * (1 + margin);
    if (!(bound < 1)) { break; }
    Matrix shifted = -unit;
    for (Eigen::Index i = 0; i < n; ++i) { shifted.coeffRef(i, i) += bound; }
    const Eigen::SimplicialLLT<Matrix> factors(shifted);
    if (factors.info() == Eigen::Success) { return bound * gershgorin; }
  }
  return gershgorin;
}

} // namespace internal

} // namespace meridian
