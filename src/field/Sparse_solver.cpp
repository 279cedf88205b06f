// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/field/Sparse_solver.h>

#ifdef MERIDIAN_HAS_CHOLMOD
#include "Cholmod_solver.h"
#endif

#include <Eigen/Sparse>

#include <algorithm>
#include <numeric>
#include <vector>

namespace meridian {

namespace {

using Matrix = Eigen::SparseMatrix<double>;

// Writes a matrix by columns: all of it, or its lower triangle.
void copy_columns(const Sparse_matrix& a, bool is_lower, Matrix& to)
{
  const Index n = a.rows();
  to.resize(n, n);
  int* begin = to.outerIndexPtr();
  std::fill(begin, begin + n + 1, 0);
  for (Index row = 0; row < n; ++row)
    for (Index k = a.begin(row); k < a.end(row) && !(is_lower && a.column(k) > row); ++k) { ++begin[a.column(k) + 1]; }
  std::partial_sum(begin, begin + n + 1, begin);
  to.resizeNonZeros(begin[n]);
  std::vector<int> next(begin, begin + n);
  for (Index row = 0; row < n; ++row)
    for (Index k = a.begin(row); k < a.end(row) && !(is_lower && a.column(k) > row); ++k)
    {
      const int place = next[a.column(k)]++;
      to.innerIndexPtr()[place] = row;
      to.valuePtr()[place] = a.value(k);
    }
}

bool have_same_pattern(const Matrix& a, const Matrix& b)
{
  return a.rows() == b.rows() && a.nonZeros() == b.nonZeros()
         && std::equal(a.outerIndexPtr(), a.outerIndexPtr() + a.rows() + 1, b.outerIndexPtr())
         && std::equal(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros(), b.innerIndexPtr());
}

template <class Solver, bool is_symmetric> class Eigen_solver : public Sparse_solver
{
public:
  bool factor(const Sparse_matrix& a) override
  {
    m_matrix.swap(m_last);
    copy_columns(a, is_symmetric, m_matrix);
    if (!m_is_ordered || !have_same_pattern(m_matrix, m_last)) { m_solver.analyzePattern(m_matrix); }
    m_is_ordered = true;
    m_solver.factorize(m_matrix);
    return m_solver.info() == Eigen::Success;
  }
  bool solve(const std::vector<double>& right, std::vector<double>& solution) override
  {
    const auto n = static_cast<Eigen::Index>(right.size());
    const Eigen::VectorXd b = Eigen::Map<const Eigen::VectorXd>(right.data(), n);
    solution.resize(right.size());
    Eigen::Map<Eigen::VectorXd>(solution.data(), n) = m_solver.solve(b);
    return m_solver.info() == Eigen::Success;
  }

private:
  Solver m_solver;
  Matrix m_matrix, m_last; // and that of the last factorization
  bool m_is_ordered = false;
};

} // namespace

std::unique_ptr<Sparse_solver> make_symmetric_solver()
{
#ifdef MERIDIAN_HAS_CHOLMOD
  return internal::make_cholmod_solver();
#else
  return std::make_unique<Eigen_solver<Eigen::SimplicialLDLT<Matrix, Eigen::Lower>, true>>();
#endif
}

std::unique_ptr<Sparse_solver> make_general_solver()
{
  return std::make_unique<Eigen_solver<Eigen::SparseLU<Matrix, Eigen::COLAMDOrdering<int>>, false>>();
}

} // namespace meridian
