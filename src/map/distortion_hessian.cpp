// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/map/internal/distortion_hessian.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace meridian {

namespace internal {

void Distortion_hessian::reset(const std::vector<Rest_triangle>& triangles, const std::vector<Rest_triangle>& others)
{
  std::vector<Index> begin(static_cast<std::size_t>(m_rows) + 1, 0),
    lower; // of each row, the rows before it, or itself
  const auto for_each_pair = [&](const auto& f) {
    for (const auto* all : {&triangles, &others})
      for (const Rest_triangle& t : *all)
        for (int k = 0; k < 3; ++k)
        {
          const Index a = m_row[t.corners[k]], b = m_row[t.corners[(k + 1) % 3]];
          if (a >= 0 && b >= 0) { f(std::max(a, b), std::min(a, b)); }
        }
  };
  for_each_pair([&](Index row, Index) { ++begin[row + 1]; });
  for (Index i = 0; i < m_rows; ++i) { begin[i + 1] += begin[i]; }
  lower.resize(begin[m_rows]);
  std::vector<Index> next(begin.begin(), begin.end() - 1);
  for_each_pair([&](Index row, Index other) { lower[next[row]++] = other; });

  m_matrix = Sparse_matrix(2 * m_rows, 2 * lower.size() + 6 * static_cast<std::size_t>(m_rows));
  for (Index i = 0; i < m_rows; ++i)
  {
    const auto first = lower.begin() + begin[i];
    std::sort(first, lower.begin() + begin[i + 1]);
    const auto last = std::unique(first, lower.begin() + begin[i + 1]);
    for (int k = 0; k < 2; ++k)
    {
      for (auto j = first; j != last; ++j)
      {
        m_matrix.add(2 * *j, 0);
        m_matrix.add(2 * *j + 1, 0);
      }
      for (int l = 0; l <= k; ++l) { m_matrix.add(2 * i + l, 0); }
      m_matrix.end_row();
    }
  }
  m_downwards.assign(number_of_unknowns(), 0);
  m_trace = 0;
}

void Distortion_hessian::add(const Rest_triangle& t, const Energy_derivatives& d)
{
  std::array<std::array<double, 6>, 4> scaled; // each mode times its eigenvalue
  for (int m = 0; m < 4; ++m)
    for (int k = 0; k < 6; ++k) { scaled[m][k] = d.modes[m].lambda * d.modes[m].q[k]; }
  const auto entry = [&](int k, int l) {
    double sum = 0;
    for (int m = 0; m < 4; ++m) { sum += scaled[m][k] * d.modes[m].q[l]; }
    return t.weight * sum;
  };
  for (int a = 0; a < 3; ++a)
  {
    const Index row = unknown(t.corners[a]);
    if (row < 0) { continue; }
    for (int k = 0; k < 2; ++k) { m_downwards[row + k] -= t.weight * d.gradient[2 * a + k]; }
    for (int b = 0; b < 3; ++b)
    {
      const Index column = unknown(t.corners[b]);
      if (column < 0 || column > row) { continue; }
      for (int k = 0; k < 2; ++k)
      {
        const Index first = a == b ? m_matrix.end(row + k) - k - 1 : m_matrix.place(row + k, column);
        for (int l = 0; l < (a == b ? k + 1 : 2); ++l)
        {
          const double x = entry(2 * a + k, 2 * b + l);
          m_matrix.value(first + l) += x;
          if (a == b && k == l) { m_trace += x; }
        }
      }
    }
  }
}

void Distortion_hessian::add_to_vertex(Index v, double x, const Plane_point& downwards)
{
  const Index row = unknown(v);
  for (int k = 0; k < 2; ++k)
  {
    m_matrix.value(m_matrix.end(row + k) - 1) += x;
    m_downwards[row + k] += downwards[k];
  }
}

void Distortion_hessian::add_to_diagonal(double x)
{
  for (Index i = 0; i < m_matrix.rows(); ++i) { m_matrix.value(m_matrix.end(i) - 1) += x; }
}

} // namespace internal

} // namespace meridian
