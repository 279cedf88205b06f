// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_SRC_UNWRAP_BOUND_SPECTRAL_NORM_H
#define MERIDIAN_SRC_UNWRAP_BOUND_SPECTRAL_NORM_H

#include <Eigen/SparseCholesky>

namespace meridian {
namespace internal {

// An upper bound of the largest eigenvalue of a symmetric positive semidefinite matrix, both triangles stored, and so
// of its 2-norm: less than a thousandth more than the norm as a rule, never more than Gershgorin's bound.
//
// The Lanczos method, from a fixed vector, gives a Ritz value and its residual. An eigenvalue lies that near, but a
// larger one may have been missed. So a Cholesky factorization of bound * I - A decides; if there is none after some
// margin, Gershgorin's bound stands.
double bound_spectral_norm(const Eigen::SparseMatrix<double>& a);

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_SRC_UNWRAP_BOUND_SPECTRAL_NORM_H
