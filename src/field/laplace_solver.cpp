// SPDX-License-Identifier: GPL-3.0-or-later
#include "multilevel.h"

#include <meridian/field/Sparse_solver.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace meridian {

namespace {

// An order of unknowns in which neighbours are near to each other: breadth first.
std::vector<Index> order_by_distance(const Sparse_matrix& a)
{
  std::vector<Index> order;
  order.reserve(a.rows());
  std::vector<char> is_met(a.rows(), 0);
  for (Index seed = 0; seed < a.rows(); ++seed)
  {
    if (is_met[seed]) { continue; }
    is_met[seed] = 1;
    order.push_back(seed);
    for (std::size_t i = order.size() - 1; i < order.size(); ++i)
      for (Index k = a.begin(order[i]); k < a.end(order[i]); ++k)
      {
        const Index j = a.column(k);
        if (!is_met[j])
        {
          is_met[j] = 1;
          order.push_back(j);
        }
      }
  }
  return order;
}

// A sum of products, always in the same order.
double dot(const std::vector<double>& a, const std::vector<double>& b)
{
  std::array<double, 4> sum{};
  std::size_t i = 0;
  for (; i + 4 <= a.size(); i += 4)
    for (std::size_t k = 0; k < 4; ++k) { sum[k] += a[i + k] * b[i + k]; }
  for (; i < a.size(); ++i) { sum[0] += a[i] * b[i]; }
  return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

// The method of conjugate gradients, with a cycle through levels as its preconditioner. The unknowns are put in an
// order of their own, and scaled so that the matrix has ones on its diagonal.
class Conjugate_gradients
{
public:
  static constexpr double tolerance = 1e-8; // what may be left, as a part of the right-hand side

  // Returns false if the diagonal is not positive.
  bool prepare(const Sparse_matrix& a)
  {
    m_order = order_by_distance(a);
    const Index n = a.rows();
    m_scale.resize(n);
    std::vector<double> smooth(n);
    std::vector<Index> place(n);
    for (Index i = 0; i < n; ++i)
    {
      const Index row = m_order[i];
      place[row] = i;
      double diagonal = 0;
      for (Index k = a.begin(row); k < a.end(row); ++k)
        if (a.column(k) == row) { diagonal = a.value(k); }
      if (!(diagonal > 0) || !std::isfinite(diagonal)) { return false; }
      m_scale[i] = 1 / std::sqrt(diagonal);
    }
    const double unit = *std::min_element(m_scale.begin(), m_scale.end());
    for (Index i = 0; i < n; ++i) { smooth[i] = unit / m_scale[i]; } // constants, scaled
    copy(a, place);
    m_cycle = std::make_unique<internal::Multilevel>(m_matrix, std::move(smooth));
    return true;
  }

  // Returns false if it does not converge.
  bool solve(const std::vector<double>& right, std::vector<double>& solution)
  {
    const std::size_t n = m_order.size();
    std::vector<double> b(n), x(n, 0.);
    for (std::size_t i = 0; i < n; ++i) { b[i] = m_scale[i] * right[m_order[i]]; }
    if (!iterate(b, x)) { return false; }
    solution.resize(n);
    for (std::size_t i = 0; i < n; ++i) { solution[m_order[i]] = m_scale[i] * x[i]; }
    return true;
  }

private:
  void copy(const Sparse_matrix& a, const std::vector<Index>& place)
  {
    m_matrix.reserve(a.rows(), a.end(a.rows() - 1));
    std::vector<std::pair<Index, double>> row;
    for (Index i = 0; i < a.rows(); ++i)
    {
      row.clear();
      for (Index k = a.begin(m_order[i]); k < a.end(m_order[i]); ++k)
      {
        const Index j = place[a.column(k)];
        if (j != i) { row.emplace_back(j, a.value(k) * m_scale[i] * m_scale[j]); }
      }
      m_matrix.add_row(row);
    }
  }

  void multiply(const std::vector<double>& x, std::vector<double>& y) const
  {
    for (Index i = 0; i < m_matrix.rows(); ++i)
    {
      double sum = x[i];
      for (Index k = m_matrix.begin[i]; k < m_matrix.begin[i + 1]; ++k)
      {
        sum += m_matrix.value[k] * x[m_matrix.column[k]];
      }
      y[i] = sum;
    }
  }

  bool iterate(const std::vector<double>& b, std::vector<double>& x)
  {
    constexpr int most = 200;    // iterations
    constexpr int patience = 20; // after which the residual must be a hundredth
    const std::size_t n = b.size();
    const double wanted = tolerance * std::sqrt(dot(b, b));
    std::vector<double> r = b, z(n), p(n, 0.), q(n);
    double rho = 0, norm = std::sqrt(dot(r, r)), before = norm;
    for (int i = 0; norm > wanted; ++i)
    {
      if (i == most || !std::isfinite(norm)) { return false; }
      if (i > 0 && i % patience == 0)
      {
        if (norm > before / 100) { return false; }
        before = norm;
      }
      m_cycle->solve(r, z);
      const double next = dot(r, z), beta = i > 0 ? next / rho : 0;
      rho = next;
      for (std::size_t k = 0; k < n; ++k) { p[k] = z[k] + beta * p[k]; }
      multiply(p, q);
      const double alpha = rho / dot(p, q);
      for (std::size_t k = 0; k < n; ++k)
      {
        x[k] += alpha * p[k];
        r[k] -= alpha * q[k];
      }
      norm = std::sqrt(dot(r, r));
    }
    multiply(x, q); // what is left in truth
    for (std::size_t k = 0; k < n; ++k) { r[k] = b[k] - q[k]; }
    return std::sqrt(dot(r, r)) <= 10 * wanted;
  }

  std::vector<Index> m_order;
  std::vector<double> m_scale; // of each unknown, in the new order
  internal::Unit_matrix m_matrix;
  std::unique_ptr<internal::Multilevel> m_cycle;
};

class Laplace_solver : public Sparse_solver
{
public:
  bool factor(const Sparse_matrix& a) override
  {
    m_direct.reset();
    m_iterative = std::make_unique<Conjugate_gradients>();
    if (a.rows() < least_rows || !m_iterative->prepare(a)) { return factor_directly(a); }
    m_matrix = a;
    return true;
  }
  bool solve(const std::vector<double>& right, std::vector<double>& solution) override
  {
    if (m_iterative && m_iterative->solve(right, solution)) { return true; }
    return (m_direct || factor_directly(m_matrix)) && m_direct->solve(right, solution);
  }

  double residual() const override { return m_iterative ? Conjugate_gradients::tolerance : 0; }
  std::string description() const override
  {
    return m_iterative ? "conjugate gradients with smoothed aggregation" : "direct";
  }

private:
  static constexpr Index least_rows = 20000; // fewer are solved as fast directly

  bool factor_directly(const Sparse_matrix& a)
  {
    m_iterative.reset();
    m_direct = make_symmetric_solver();
    const bool is_factored = m_direct->factor(a);
    m_matrix = Sparse_matrix();
    return is_factored;
  }

  Sparse_matrix m_matrix; // for a direct solver, if the other does not converge
  std::unique_ptr<Conjugate_gradients> m_iterative;
  std::unique_ptr<Sparse_solver> m_direct;
};

} // namespace

std::unique_ptr<Sparse_solver> make_laplace_solver() { return std::make_unique<Laplace_solver>(); }

} // namespace meridian
