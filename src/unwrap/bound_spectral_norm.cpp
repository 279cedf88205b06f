// SPDX-License-Identifier: GPL-3.0-or-later
#include "bound_spectral_norm.h"

#include <Spectra/MatOp/SparseSymMatProd.h>
#include <Spectra/SymEigsSolver.h>

#include <algorithm>
#include <cmath>
#include <exception>

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
  double estimate = 1;
  try
  {
    Spectra::SparseSymMatProd<double> product(unit);
    Spectra::SymEigsSolver<Spectra::SparseSymMatProd<double>> solver(product, 1, std::min<Eigen::Index>(n, 24));
    solver.init(); // from a fixed seed
    solver.compute(Spectra::SortRule::LargestAlge, 300, 5e-4);
    if (solver.info() != Spectra::CompInfo::Successful) { return gershgorin; }
    const Eigen::VectorXd x = solver.eigenvectors().col(0);
    const double value = solver.eigenvalues()[0], residual = (unit * x - value * x).norm() / x.norm();
    estimate = value + residual;
  }
  // Spectra's own: the small matrix of a subspace had no eigenvalues
  catch (const std::exception&)
  {
    return gershgorin;
  }
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
