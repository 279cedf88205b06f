// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FIELD_SPARSE_MATRIX_H
#define MERIDIAN_FIELD_SPARSE_MATRIX_H

#include <meridian/base/vectors.h>

#include <cstddef>
#include <vector>

namespace meridian {

/// \ingroup PkgMeridianOrder
/// a square sparse matrix in compressed rows, put together row by row.
class Sparse_matrix
{
public:
  /// nothing yet, and room for what is to come.
  /// \param rows, values how many are expected
  explicit Sparse_matrix(Index rows = 0, std::size_t values = 0)
  {
    m_begin.reserve(static_cast<std::size_t>(rows) + 1);
    m_columns.reserve(values);
    m_values.reserve(values);
    m_begin.push_back(0);
  }

  /// adds a value to the row that is being written; those of one place are summed in the order in which they come.
  /// \param column its place \param value the value
  void add(Index column, double value)
  {
    m_columns.push_back(column);
    m_values.push_back(value);
  }
  /// ends the row, whose values are then in the order of their columns.
  void end_row();

  /// \returns how many rows were ended
  Index rows() const { return static_cast<Index>(m_begin.size()) - 1; }
  /// \param row a row \returns the place of its first value; that of the row after it is where it ends
  Index begin(Index row) const { return m_begin[row]; }
  /// \param row a row \returns the place after its last value
  Index end(Index row) const { return m_begin[row + 1]; }
  /// \param place a place \returns the column of the value there
  Index column(Index place) const { return m_columns[place]; }
  /// \param place a place \returns the value there
  double value(Index place) const { return m_values[place]; }
  /// \param place a place \returns the value there, to be changed
  double& value(Index place) { return m_values[place]; }
  /// \param row, column where a value is \returns its place. \pre there is one
  Index place(Index row, Index column) const;

private:
  std::vector<Index> m_begin; // of each row, and the end
  std::vector<Index> m_columns;
  std::vector<double> m_values;
};

} // namespace meridian

#endif // MERIDIAN_FIELD_SPARSE_MATRIX_H
