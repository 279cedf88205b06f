// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/field/largest_eigenpairs.h>

#include <meridian/base/exceptions.h>

#include <Spectra/SymEigsSolver.h>

#include <exception>
#include <new>

namespace meridian {

namespace {

// A matrix operation as Spectra asks for it.
struct Operation
{
  using Scalar = double;
  Eigen::Index rows() const { return n; }
  Eigen::Index cols() const { return n; }
  void perform_op(const double* in, double* out) const { apply(in, out); }

  Index n;
  const std::function<void(const double*, double*)>& apply;
};

} // namespace

Eigenpairs largest_eigenpairs(Index n, const std::function<void(const double* in, double* out)>& operation, Index count,
                              Index subspace, Index restarts, double tolerance)
{
  Eigenpairs result;
  try
  {
    Operation matrix{n, operation};
    Spectra::SymEigsSolver<Operation> solver(matrix, count, subspace);
    solver.init(); // from a fixed seed
    solver.compute(Spectra::SortRule::LargestMagn, restarts, tolerance);
    if (solver.info() != Spectra::CompInfo::Successful) { return result; }
    const Eigen::VectorXd values = solver.eigenvalues();
    const Eigen::MatrixXd vectors = solver.eigenvectors();
    for (Eigen::Index i = 0; i < values.size(); ++i)
    {
      result.values.push_back(values[i]);
      result.vectors.emplace_back(vectors.col(i).begin(), vectors.col(i).end());
    }
  }
  catch (const Solver_error&)
  {
    throw;
  }
  catch (const std::bad_alloc&)
  {
    throw;
  }
  catch (const std::exception&)
  {} // Spectra's own: the small matrix of a subspace had no eigenvalues
  return result;
}

} // namespace meridian
