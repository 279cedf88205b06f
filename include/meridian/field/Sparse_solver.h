// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FIELD_SPARSE_SOLVER_H
#define MERIDIAN_FIELD_SPARSE_SOLVER_H

#include <meridian/base/vectors.h>

#include <memory>
#include <vector>

namespace meridian {

/// \ingroup PkgMeridianOrder
/// a square sparse matrix as it is put together: values added at one place are summed in the order they came.
class Sparse_matrix
{
public:
  /// a value at a place.
  class Entry
  {
  public:
    /// \param row, column its place
    /// \param value the value
    Entry(Index row, Index column, double value) : m_row(row), m_column(column), m_value(value) {}
    /// \returns its row
    Index row() const { return m_row; }
    /// \returns its column, by the name that Eigen asks for
    Index col() const { return m_column; }
    /// \returns the value
    double value() const { return m_value; }

  private:
    Index m_row, m_column;
    double m_value;
  };

  /// \param rows how many, and as many columns
  explicit Sparse_matrix(Index rows) : m_rows(rows) {}

  /// \returns how many rows there are
  Index rows() const { return m_rows; }
  /// adds a value at a place.
  /// \param row, column the place \param value the value
  void add(Index row, Index column, double value) { m_entries.emplace_back(row, column, value); }
  /// \returns what was added, in this order
  const std::vector<Entry>& entries() const { return m_entries; }

private:
  Index m_rows;
  std::vector<Entry> m_entries;
};

/// \ingroup PkgMeridianOrder
/// the one door to sparse direct solvers: a matrix is factorized once, and then solved with as often as is needed.
class Sparse_solver
{
public:
  virtual ~Sparse_solver() = default;
  /// factorizes a matrix.
  /// \param a the matrix
  /// \returns `false` if that is not possible
  virtual bool factor(const Sparse_matrix& a) = 0;
  /// solves with the matrix that was factorized.
  /// \param right one value a row
  /// \param solution receives one value a row
  /// \returns `true` on success
  virtual bool solve(const std::vector<double>& right, std::vector<double>& solution) = 0;
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
/// the solvers that a computation uses. `adapt_solver()` makes them of CGAL's models.
struct Solvers
{
  Make_solver symmetric = make_symmetric_solver; ///< for symmetric positive definite systems
  Make_solver general = make_general_solver;     ///< for others
};

} // namespace meridian

#endif // MERIDIAN_FIELD_SPARSE_SOLVER_H
