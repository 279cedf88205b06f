// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FIELD_SOLVER_TRAITS_H
#define MERIDIAN_FIELD_SOLVER_TRAITS_H

#include <CGAL/Eigen_matrix.h>
#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Eigen_vector.h>

#include <Eigen/Sparse>
#ifdef MERIDIAN_HAS_CHOLMOD
#include <Eigen/CholmodSupport>
#endif

namespace meridian {

/// \ingroup PkgMeridianOrder
/// the default solver for symmetric systems, a model of CGAL's `SparseLinearAlgebraWithFactorTraits_d`.
///
/// A Cholesky factorization with approximate minimum degree ordering: CHOLMOD's supernodal one where
/// SuiteSparse is found, Eigen's own otherwise.
class Symmetric_solver_traits
{
public:
  using NT = double;
  using Matrix = CGAL::Eigen_sparse_symmetric_matrix<double>;
  using Vector = CGAL::Eigen_vector<double>;

  Symmetric_solver_traits()
  {
#ifdef MERIDIAN_HAS_CHOLMOD
    auto& common = m_solver.cholmod();
    common.nmethods = 1;
    common.method[0].ordering = CHOLMOD_AMD;
    common.print = 0;
#endif
  }
  /// factorizes `a`. \returns `false` if `a` is not positive definite
  bool factor(const Matrix& a, NT& d)
  {
    d = 1;
    m_solver.compute(a.eigen_object());
    return m_solver.info() == Eigen::Success;
  }
  /// solves with the matrix that was factorized. \returns `true` on success
  bool linear_solver(const Vector& b, Vector& x)
  {
    x = m_solver.solve(b.eigen_object());
    return m_solver.info() == Eigen::Success;
  }
  bool linear_solver(const Matrix& a, const Vector& b, Vector& x, NT& d) { return factor(a, d) && linear_solver(b, x); }

private:
#ifdef MERIDIAN_HAS_CHOLMOD
  Eigen::CholmodSupernodalLLT<Matrix::EigenType, Eigen::Lower> m_solver;
#else
  Eigen::SimplicialLDLT<Matrix::EigenType, Eigen::Lower> m_solver;
#endif
};

/// \ingroup PkgMeridianOrder
/// the default solver for unsymmetric systems (mean-value weights), a model of CGAL's
/// `SparseLinearAlgebraWithFactorTraits_d`.
using General_solver_traits =
  CGAL::Eigen_solver_traits<Eigen::SparseLU<CGAL::Eigen_sparse_matrix<double>::EigenType, Eigen::COLAMDOrdering<int>>>;

} // namespace meridian

#endif // MERIDIAN_FIELD_SOLVER_TRAITS_H
