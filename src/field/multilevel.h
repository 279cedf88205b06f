// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_SRC_FIELD_MULTILEVEL_H
#define MERIDIAN_SRC_FIELD_MULTILEVEL_H

#include <meridian/base/run_both.h>
#include <meridian/base/vectors.h>

#include <Eigen/Cholesky>

#include <cstddef>
#include <utility>
#include <vector>

namespace meridian {
namespace internal {

// A symmetric matrix with ones on its diagonal, which are left out: the rest in compressed rows.
struct Unit_matrix
{
  std::vector<Index> begin{0}; // of each row, and the end
  std::vector<Index> middle;   // of each row: the first place behind the diagonal
  std::vector<Index> column;   // ascending in each row
  std::vector<double> value;

  Index rows() const { return static_cast<Index>(middle.size()); }
  void reserve(Index n, std::size_t values);
  // Appends a row, of which columns are given in any order.
  void add_row(std::vector<std::pair<Index, double>>& row);
  // The same for row `i` of those for which `begin` was set, and room was made.
  void set_row(Index i, std::vector<std::pair<Index, double>>& row);
};

// Any matrix in compressed rows, whose columns are in no order.
struct Sparse_rows
{
  std::vector<Index> begin{0}, column;
  std::vector<double> value;
  Index columns = 0;

  Index rows() const { return static_cast<Index>(begin.size()) - 1; }
  void reserve(Index n, std::size_t values);
  void append(const Sparse_rows& rows);
};

// Rows from here on are the second half of a system, which is worked on beside the first: all of a small one are in the
// first. It does not depend on how many threads there are, so that neither does what comes out.
Index half_of(Index rows);

// Calls `f(first, last)` for both halves of some rows, side by side.
template <class Function> void for_both_halves(Index rows, const Function& f)
{
  const Index half = half_of(rows);
  if (half == rows) { f(Index(0), rows); }
  else
  {
    run_both([&] { f(half, rows); }, [&] { f(Index(0), half); });
  }
}

// Makes rows half by half: `make(first, last, part)` appends those from `first` to `last` to a part. `values`: how many
// there are likely to be.
template <class Rows, class Make> void make_by_halves(Rows& all, Index rows, std::size_t values, const Make& make)
{
  all.reserve(rows, values);
  const Index half = half_of(rows);
  if (half == rows)
  {
    make(Index(0), rows, all);
    return;
  }
  Rows second(all);
  second.reserve(rows - half, values / 2);
  run_both([&] { make(half, rows, second); }, [&] { make(Index(0), half, all); });
  all.append(second);
}

// Systems of fewer and fewer unknowns, by smoothed aggregation. One cycle through them is close to solving, and is the
// same as multiplying by a symmetric positive definite matrix.
class Multilevel
{
public:
  // `smooth`: what the matrix takes to next to nothing. The matrix must outlive this.
  Multilevel(const Unit_matrix& matrix, std::vector<double> smooth);
  Multilevel(Unit_matrix&& matrix, std::vector<double> smooth) = delete;

  // Writes to `x` what is close to the solution with right-hand side `b`.
  void solve(const std::vector<double>& b, std::vector<double>& x) { cycle(0, b, x); }

private:
  // A place of the matrix whose row and column are in different halves.
  struct Bridge
  {
    Index row, column;
    double value;
  };
  struct Level
  {
    Unit_matrix matrix;                  // of all but the first
    std::vector<Bridge> bridges;         // row by row
    Sparse_rows to_next;                 // how its values are made of those of the next level
    std::vector<double> right, solution; // of the next level
    std::vector<double> right_of_second; // what the second half adds
  };

  const Unit_matrix& matrix(std::size_t level) const { return level == 0 ? m_finest : m_levels[level].matrix; }
  void factor_last();
  void find_bridges(std::size_t level);
  // A value of the solution with what the next level adds to it.
  double corrected(const Level& level, Index i, const std::vector<double>& x) const;
  void smooth_and_restrict(std::size_t level, const std::vector<double>& b, std::vector<double>& x);
  void correct_and_smooth(std::size_t level, const std::vector<double>& b, std::vector<double>& x);
  void cycle(std::size_t level, const std::vector<double>& b, std::vector<double>& x);

  const Unit_matrix& m_finest;
  std::vector<Level> m_levels;
  Eigen::LLT<Eigen::MatrixXd> m_last; // of the last level, if it is small
  bool m_is_last_factored = false;
};

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_SRC_FIELD_MULTILEVEL_H
