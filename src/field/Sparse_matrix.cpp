// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/field/Sparse_matrix.h>

#include <algorithm>
#include <numeric>

namespace meridian {

namespace {

constexpr std::size_t short_row = 32;

// Sorts a long row by columns; values of one column stay in their order.
void sort_row(Index* columns, double* values, std::size_t size)
{
  std::vector<std::size_t> order(size);
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return columns[i] < columns[j]; });
  const std::vector<Index> old_columns(columns, columns + size);
  const std::vector<double> old_values(values, values + size);
  for (std::size_t i = 0; i < size; ++i)
  {
    columns[i] = old_columns[order[i]];
    values[i] = old_values[order[i]];
  }
}

} // namespace

void Sparse_matrix::end_row()
{
  const std::size_t first = m_begin.back(), size = m_columns.size() - first;
  if (size > short_row) { sort_row(&m_columns[first], &m_values[first], size); }
  std::size_t last = first; // before it the row is in order
  for (std::size_t i = first; i < m_columns.size(); ++i)
  {
    const Index column = m_columns[i];
    const double value = m_values[i];
    std::size_t k = last; // where it goes
    while (k > first && m_columns[k - 1] > column) { --k; }
    if (k > first && m_columns[k - 1] == column)
    {
      m_values[k - 1] += value;
      continue;
    }
    std::copy_backward(m_columns.begin() + k, m_columns.begin() + last, m_columns.begin() + last + 1);
    std::copy_backward(m_values.begin() + k, m_values.begin() + last, m_values.begin() + last + 1);
    m_columns[k] = column;
    m_values[k] = value;
    ++last;
  }
  m_columns.resize(last);
  m_values.resize(last);
  m_begin.push_back(static_cast<Index>(last));
}

Index Sparse_matrix::place(Index row, Index column) const
{
  const auto begin = m_columns.begin() + m_begin[row], end = m_columns.begin() + m_begin[row + 1];
  return static_cast<Index>(std::lower_bound(begin, end, column) - m_columns.begin());
}

} // namespace meridian
