// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/field/Sparse_solver.h>

#include <Eigen/Sparse>
#ifdef MERIDIAN_HAS_CHOLMOD
#include <Eigen/CholmodSupport>
#endif

namespace meridian {

namespace {

using Matrix = Eigen::SparseMatrix<double>;

template <class Solver> class Eigen_solver : public Sparse_solver
{
public:
  bool factor(const Sparse_matrix& a) override
  {
    Matrix matrix(a.rows(), a.rows());
    matrix.setFromTriplets(a.entries().begin(), a.entries().end());
    m_solver.compute(matrix);
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

protected:
  Solver m_solver;
};

#ifdef MERIDIAN_HAS_CHOLMOD
class Symmetric_solver : public Eigen_solver<Eigen::CholmodSupernodalLLT<Matrix, Eigen::Lower>>
{
public:
  Symmetric_solver()
  {
    auto& common = m_solver.cholmod();
    common.nmethods = 1;
    common.method[0].ordering = CHOLMOD_AMD;
    common.print = 0;
  }
};
#else
using Symmetric_solver = Eigen_solver<Eigen::SimplicialLDLT<Matrix, Eigen::Lower>>;
#endif

} // namespace

std::unique_ptr<Sparse_solver> make_symmetric_solver() { return std::make_unique<Symmetric_solver>(); }

std::unique_ptr<Sparse_solver> make_general_solver()
{
  return std::make_unique<Eigen_solver<Eigen::SparseLU<Matrix, Eigen::COLAMDOrdering<int>>>>();
}

} // namespace meridian
