// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FIELD_ADAPT_SOLVER_H
#define MERIDIAN_FIELD_ADAPT_SOLVER_H

#include <meridian/field/Sparse_solver.h>

#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace meridian {
namespace internal {

template <class SolverTraits, class = void> struct Can_factor : std::false_type
{};
template <class SolverTraits>
struct Can_factor<SolverTraits,
                  std::void_t<decltype(std::declval<SolverTraits&>().factor(
                    std::declval<typename SolverTraits::Matrix&>(), std::declval<typename SolverTraits::NT&>()))>>
  : std::true_type
{};

template <class SolverTraits> class Adapted_solver : public Sparse_solver
{
public:
  bool factor(const Sparse_matrix& a) override
  {
    m_matrix = std::make_unique<typename SolverTraits::Matrix>(a.rows());
    for (Index row = 0; row < a.rows(); ++row)
      for (Index k = a.begin(row); k < a.end(row); ++k) { m_matrix->add_coef(row, a.column(k), a.value(k)); }
    return m_solver.factor(*m_matrix, m_denominator);
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

  std::string description() const override { return "a solver of the caller's"; }

private:
  std::unique_ptr<typename SolverTraits::Matrix> m_matrix; // iterative solvers go on reading it
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
  static_assert(internal::Can_factor<SolverTraits>::value,
                "the solver has no factor(): a model of SparseLinearAlgebraWithFactorTraits_d is needed, such as "
                "CGAL::Eigen_solver_traits of one of Eigen's direct solvers");
  return std::make_unique<internal::Adapted_solver<SolverTraits>>();
}

} // namespace meridian

#endif // MERIDIAN_FIELD_ADAPT_SOLVER_H
