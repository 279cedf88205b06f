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

// A system whose unknowns are put in an order of their own, and scaled so that the matrix has ones on its diagonal.
class Scaled_system
{
public:
  // Returns false if the diagonal is not positive.
  bool take(const Sparse_matrix& a)
  {
    m_order = order_by_distance(a);
    const Index n = a.rows();
    m_scale.resize(n);
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
    copy(a, place);
    return true;
  }

  const internal::Unit_matrix& matrix() const { return m_matrix; }

  // The matrix with its diagonal.
  Sparse_matrix whole_matrix() const
  {
    const Index n = m_matrix.rows();
    Sparse_matrix a(n, m_matrix.column.size() + n);
    for (Index i = 0; i < n; ++i)
    {
      for (Index k = m_matrix.begin[i]; k < m_matrix.begin[i + 1]; ++k)
      {
        a.add(m_matrix.column[k], m_matrix.value[k]);
      }
      a.add(i, 1);
      a.end_row();
    }
    return a;
  }

  // What is one in units of the unknowns, times a constant: the matrix takes it to next to nothing.
  std::vector<double> smooth() const
  {
    const double unit = *std::min_element(m_scale.begin(), m_scale.end());
    std::vector<double> one(m_scale.size());
    for (std::size_t i = 0; i < one.size(); ++i) { one[i] = unit / m_scale[i]; }
    return one;
  }

  std::vector<double> scale(const std::vector<double>& right) const
  {
    std::vector<double> b(m_order.size());
    for (std::size_t i = 0; i < b.size(); ++i) { b[i] = m_scale[i] * right[m_order[i]]; }
    return b;
  }

  void scale_back(const std::vector<double>& x, std::vector<double>& solution) const
  {
    solution.resize(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) { solution[m_order[i]] = m_scale[i] * x[i]; }
  }

private:
  void copy(const Sparse_matrix& a, const std::vector<Index>& place)
  {
    const Index n = a.rows();
    m_matrix.begin.resize(static_cast<std::size_t>(n) + 1);
    m_matrix.middle.resize(n);
    for (Index i = 0; i < n; ++i)
    {
      m_matrix.begin[i + 1] = m_matrix.begin[i] + (a.end(m_order[i]) - a.begin(m_order[i])) - 1; // without the diagonal
    }
    m_matrix.column.resize(m_matrix.begin[n]);
    m_matrix.value.resize(m_matrix.begin[n]);
    internal::for_both_halves(n, [&](Index first, Index last) {
      std::vector<std::pair<Index, double>> row;
      for (Index i = first; i < last; ++i)
      {
        row.clear();
        for (Index k = a.begin(m_order[i]); k < a.end(m_order[i]); ++k)
        {
          const Index j = place[a.column(k)];
          if (j != i) { row.emplace_back(j, a.value(k) * m_scale[i] * m_scale[j]); }
        }
        m_matrix.set_row(i, row);
      }
    });
  }

  std::vector<Index> m_order;
  std::vector<double> m_scale; // of each unknown, in the new order
  internal::Unit_matrix m_matrix;
};

constexpr double tolerance = 1e-8; // what may be left, as a part of the right-hand side

// The method of conjugate gradients, with a cycle through levels as its preconditioner.
class Conjugate_gradients
{
public:
  explicit Conjugate_gradients(const Scaled_system& system)
    : m_matrix(system.matrix()), m_cycle(m_matrix, system.smooth())
  {}

  // Returns false if it does not converge. `x`: zero, to begin at.
  bool solve(const std::vector<double>& b, std::vector<double>& x)
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
      m_cycle.solve(r, z);
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

private:
  void multiply(const std::vector<double>& x, std::vector<double>& y) const
  {
    internal::for_both_halves(m_matrix.rows(), [&](Index first, Index last) {
      for (Index i = first; i < last; ++i)
      {
        double sum = x[i];
        for (Index k = m_matrix.begin[i]; k < m_matrix.begin[i + 1]; ++k)
        {
          sum += m_matrix.value[k] * x[m_matrix.column[k]];
        }
        y[i] = sum;
      }
    });
  }

  const internal::Unit_matrix& m_matrix;
  internal::Multilevel m_cycle;
};

class Laplace_solver : public Sparse_solver
{
public:
  bool factor(const Sparse_matrix& a) override
  {
    m_iterative.reset();
    m_direct.reset();
    m_system = std::make_unique<Scaled_system>();
    m_is_iterative = a.rows() >= least_rows && m_system->take(a);
    if (m_is_iterative) { return true; }
    m_system.reset();
    m_direct = make_symmetric_solver();
    return m_direct->factor(a);
  }

  bool solve(const std::vector<double>& right, std::vector<double>& solution) override
  {
    if (!m_system) { return m_direct->solve(right, solution); }
    const std::vector<double> b = m_system->scale(right);
    std::vector<double> x(b.size(), 0.);
    m_is_iterative = m_is_iterative && iterate(b, x);
    if (!m_is_iterative && !solve_directly(b, x)) { return false; }
    m_system->scale_back(x, solution);
    return true;
  }

  double residual() const override { return m_is_iterative ? tolerance : 0; }
  std::string description() const override
  {
    return m_is_iterative ? "conjugate gradients with smoothed aggregation" : "direct";
  }

private:
  static constexpr Index least_rows = 20000; // fewer are solved as fast directly

  // The levels are made when they are first needed, so that the matrix that was given may be gone by then.
  bool iterate(const std::vector<double>& b, std::vector<double>& x)
  {
    if (!m_iterative) { m_iterative = std::make_unique<Conjugate_gradients>(*m_system); }
    return m_iterative->solve(b, x);
  }

  bool solve_directly(const std::vector<double>& b, std::vector<double>& x)
  {
    m_iterative.reset();
    if (!m_direct)
    {
      m_direct = make_symmetric_solver();
      if (!m_direct->factor(m_system->whole_matrix())) { return false; }
    }
    return m_direct->solve(b, x);
  }

  std::unique_ptr<Scaled_system> m_system; // unless it is small
  std::unique_ptr<Conjugate_gradients> m_iterative;
  std::unique_ptr<Sparse_solver> m_direct; // if the system is small, or the other did not converge
  bool m_is_iterative = false;
};

} // namespace

std::unique_ptr<Sparse_solver> make_laplace_solver() { return std::make_unique<Laplace_solver>(); }

} // namespace meridian
