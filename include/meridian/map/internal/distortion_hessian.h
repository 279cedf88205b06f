// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MAP_INTERNAL_DISTORTION_HESSIAN_H
#define MERIDIAN_MAP_INTERNAL_DISTORTION_HESSIAN_H

#include <meridian/base/vectors.h>
#include <meridian/field/Sparse_matrix.h>
#include <meridian/map/internal/distortion_energy.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace meridian {
namespace internal {

// The second derivatives of an energy of triangles, for two coordinates of each vertex that moves: the lower triangle,
// and the slope downwards beside it.
class Distortion_hessian
{
public:
  // `row[v]`: the number of vertex `v` among those that move, or -1.
  explicit Distortion_hessian(std::vector<Index> row)
    : m_row(std::move(row)),
      m_rows(static_cast<Index>(m_row.size() - std::count(m_row.begin(), m_row.end(), Index(-1))))
  {}

  // Zero, with places for the entries of these triangles.
  void reset(const std::vector<Rest_triangle>& triangles, const std::vector<Rest_triangle>& others);

  // Adds one of them.
  void add(const Rest_triangle& t, const Energy_derivatives& d);

  void add_to_diagonal(double x);
  // Adds to the diagonal at a vertex that moves, and to the slope there.
  void add_to_vertex(Index v, double x, const Plane_point& downwards);

  Index number_of_unknowns() const { return 2 * m_rows; }
  // The first of the two unknowns of a vertex, or -1.
  Index unknown(Index v) const { return m_row[v] < 0 ? -1 : 2 * m_row[v]; }
  const Sparse_matrix& matrix() const { return m_matrix; }
  const std::vector<double>& downwards() const { return m_downwards; }
  double trace() const { return m_trace; }

private:
  const std::vector<Index> m_row;
  const Index m_rows;
  Sparse_matrix m_matrix;
  std::vector<double> m_downwards;
  double m_trace = 0;
};

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_MAP_INTERNAL_DISTORTION_HESSIAN_H
