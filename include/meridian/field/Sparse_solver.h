// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FIELD_SPARSE_SOLVER_H
#define MERIDIAN_FIELD_SPARSE_SOLVER_H

#include <meridian/field/Sparse_matrix.h>

#include <memory>
#include <string>
#include <vector>

namespace meridian {

/// \ingroup PkgMeridianOrder
/// the one door to solvers of sparse systems: a matrix is factorized once, and then solved with as often as is needed.
class Sparse_solver
{
public:
  virtual ~Sparse_solver() = default;
  /// factorizes a matrix. What does not depend on its values is kept for another one with values at the same places.
  /// \param a the matrix, which is not read any more afterwards
  /// \returns `false` if that is not possible
  virtual bool factor(const Sparse_matrix& a) = 0;
  /// solves with the matrix that was factorized.
  /// \param right one value a row
  /// \param solution receives one value a row
  /// \returns `true` on success
  virtual bool solve(const std::vector<double>& right, std::vector<double>& solution) = 0;
  /// \returns what the last solution left of the right-hand side, at most, as a part of it; 0 if only rounding
  virtual double residual() const { return 0; }
  /// \returns how the last solution was found, in a few words
  virtual std::string description() const { return "direct"; }
};

/// \ingroup PkgMeridianOrder
/// makes a solver.
using Make_solver = std::unique_ptr<Sparse_solver> (*)();

/// \ingroup PkgMeridianOrder
/// \returns a solver for symmetric positive definite systems, of which it reads the lower triangle: a Cholesky
///          factorization with approximate minimum degree ordering, CHOLMOD's supernodal one where the library was
///          built with SuiteSparse (\cite chen2008), Eigen's own otherwise
std::unique_ptr<Sparse_solver> make_symmetric_solver();

/// \ingroup PkgMeridianOrder
/// \returns a solver for unsymmetric systems, such as those of mean-value weights: Eigen's LU with column approximate
///          minimum degree ordering
std::unique_ptr<Sparse_solver> make_general_solver();

/// \ingroup PkgMeridianOrder
/// \returns a solver for Laplacians that are solved with once or twice. Systems of 20 000 equations or more are solved
///          by conjugate gradients, preconditioned by smoothed aggregation (\cite vanek1996), to a residual of
///          \f$ 10^{-8} \f$ of the right-hand side; smaller ones, and those on which that does not converge, as
///          `make_symmetric_solver()` does. In each case all digits are the same from run to run.
std::unique_ptr<Sparse_solver> make_laplace_solver();

/// \ingroup PkgMeridianOrder
/// the solvers that a computation uses. `adapt_solver()` makes them of CGAL's models.
struct Solvers
{
  Make_solver symmetric = make_symmetric_solver; ///< for symmetric positive definite systems
  Make_solver general = make_general_solver;     ///< for others
  Make_solver laplace = make_laplace_solver;     ///< for Laplacians with symmetric weights that are solved with once
};

} // namespace meridian

#endif // MERIDIAN_FIELD_SPARSE_SOLVER_H
