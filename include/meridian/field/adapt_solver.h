// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FIELD_ADAPT_SOLVER_H
#define MERIDIAN_FIELD_ADAPT_SOLVER_H

#include <meridian/field/Sparse_solver.h>

#include <memory>
#include <vector>

namespace meridian {
namespace internal {

template <class SolverTraits> class Adapted_solver : public Sparse_solver
{
public:
  bool factor(const Sparse_matrix& a) override
  {
    typename SolverTraits::Matrix matrix(a.rows());
    for (const Sparse_matrix::Entry& e : a.entries()) { matrix.add_coef(e.row(), e.col(), e.value()); }
    return m_solver.factor(matrix, m_denominator);
  }
  bool solve(const std::vector<double>& right, std::vector<double>& solution) override
  {
    const std::size_t n = right.size();
    typename SolverTraits::Vector b(n), x(n);
    for (std::size_t i = 0; i < n; ++i) { b[i] = right[i]; }
    if (!m_solver.linear_solver(b, x)) { return false; }
    solution.resize(n);
    for (std::size_t i = 0; i < n; ++i) { solution[i] = x[i] / m_denominator; }
    return true;
  }

private:
  SolverTraits m_solver;
  typename SolverTraits::NT m_denominator = 1;
};

} // namespace internal

/// \ingroup PkgMeridianOrder
/// \returns a solver made of one of CGAL's, for `Solvers`: `solvers.symmetric = adapt_solver<My_traits>`
/// \tparam SolverTraits a model of CGAL's `SparseLinearAlgebraWithFactorTraits_d`; symmetric storage is enough for
///         `Solvers::symmetric`
template <class SolverTraits> std::unique_ptr<Sparse_solver> adapt_solver()
{
  return std::make_unique<internal::Adapted_solver<SolverTraits>>();
}

} // namespace meridian

#endif // MERIDIAN_FIELD_ADAPT_SOLVER_H
