// SPDX-License-Identifier: GPL-3.0-or-later
#ifdef MERIDIAN_HAS_CHOLMOD
#include "Cholmod_solver.h"

#include <meridian/base/vectors.h>
#include <meridian/field/Sparse_matrix.h>

#include <cholmod.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <new>
#include <utility>
#include <vector>

namespace meridian {

namespace internal {

namespace {

// The places of values by column, each with its rows in order: the upper triangle of a symmetric matrix.
struct Upper_pattern
{
  std::vector<int> begin{0}, rows;

  int size() const { return static_cast<int>(begin.size()) - 1; }
  bool operator==(const Upper_pattern& p) const { return begin == p.begin && rows == p.rows; }
};

// As CHOLMOD reads it, without copying.
cholmod_sparse view(Upper_pattern& p, std::vector<double>* values)
{
  cholmod_sparse a{};
  a.nrow = a.ncol = static_cast<std::size_t>(p.size());
  a.nzmax = p.rows.size();
  a.p = p.begin.data();
  a.i = p.rows.data();
  a.x = values ? values->data() : nullptr;
  a.stype = 1;
  a.itype = CHOLMOD_INT;
  a.xtype = values ? CHOLMOD_REAL : CHOLMOD_PATTERN;
  a.dtype = CHOLMOD_DOUBLE;
  a.sorted = a.packed = 1;
  return a;
}

// The pattern of pairs, if unknowns 2i and 2i + 1 have the same neighbours for all i; empty otherwise.
Upper_pattern find_pairs(const Upper_pattern& p)
{
  Upper_pattern pairs;
  if (p.size() % 2 != 0) { return {}; }
  for (int j = 0; j < p.size(); j += 2)
  {
    const auto first = p.rows.begin() + p.begin[j], middle = p.rows.begin() + p.begin[j + 1],
               last = p.rows.begin() + p.begin[j + 2];
    if (middle - first < 1 || *(middle - 1) != j || last - middle != middle - first + 1 || *(last - 1) != j + 1
        || !std::equal(first, middle, middle))
    {
      return {};
    }
    for (auto i = first; i != middle - 1; i += 2)
    {
      if (i + 1 == middle - 1 || *i % 2 != 0 || *(i + 1) != *i + 1) { return {}; }
      pairs.rows.push_back(*i / 2);
    }
    pairs.rows.push_back(j / 2);
    pairs.begin.push_back(static_cast<int>(pairs.rows.size()));
  }
  return pairs;
}

class Cholmod_solver : public Sparse_solver
{
public:
  Cholmod_solver()
  {
    cholmod_start(&m_common);
    m_common.final_asis = 1;
    m_common.supernodal = CHOLMOD_SUPERNODAL;
    m_common.nmethods = 1;
    m_common.print = 0;
  }
  Cholmod_solver(const Cholmod_solver&) = delete;
  Cholmod_solver& operator=(const Cholmod_solver&) = delete;
  ~Cholmod_solver() override
  {
    cholmod_free_factor(&m_factor, &m_common);
    cholmod_finish(&m_common);
  }

  bool factor(const Sparse_matrix& a) override
  {
    std::vector<double> values;
    Upper_pattern pattern = read(a, values);
    if (!m_factor || !(pattern == m_pattern))
    {
      m_pattern = std::move(pattern);
      analyze();
    }
    require_memory();
    if (!m_factor) { return false; }
    cholmod_sparse matrix = view(m_pattern, &values);
    std::array<double, 2> added{0, 0};
    const bool is_done = cholmod_factorize_p(&matrix, added.data(), nullptr, 0, m_factor, &m_common) != 0;
    require_memory();
    return is_done && m_factor->minor == m_factor->n;
  }

  bool solve(const std::vector<double>& right, std::vector<double>& solution) override
  {
    if (!m_factor) { return false; }
    cholmod_dense b{};
    b.nrow = b.d = b.nzmax = right.size();
    b.ncol = 1;
    b.x = const_cast<double*>(right.data()); // it is read only
    b.xtype = CHOLMOD_REAL;
    b.dtype = CHOLMOD_DOUBLE;
    cholmod_dense* x = cholmod_solve(CHOLMOD_A, m_factor, &b, &m_common);
    require_memory();
    if (!x) { return false; }
    const double* values = static_cast<const double*>(x->x);
    solution.assign(values, values + right.size());
    cholmod_free_dense(&x, &m_common);
    return true;
  }

private:
  // What there is no memory for has no other way: a result must not depend on how much there is.
  void require_memory() const
  {
    if (m_common.status == CHOLMOD_OUT_OF_MEMORY || m_common.status == CHOLMOD_TOO_LARGE) { throw std::bad_alloc(); }
  }

  // The lower triangle by rows is the upper one by columns.
  static Upper_pattern read(const Sparse_matrix& a, std::vector<double>& values)
  {
    Upper_pattern pattern;
    pattern.begin.reserve(static_cast<std::size_t>(a.rows()) + 1);
    for (Index row = 0; row < a.rows(); ++row)
    {
      for (Index k = a.begin(row); k < a.end(row) && a.column(k) <= row; ++k)
      {
        pattern.rows.push_back(a.column(k));
        values.push_back(a.value(k));
      }
      pattern.begin.push_back(static_cast<int>(pattern.rows.size()));
    }
    return pattern;
  }

  // Orders the unknowns, and finds where the factor has values.
  void analyze()
  {
    cholmod_free_factor(&m_factor, &m_common);
    cholmod_sparse matrix = view(m_pattern, nullptr);
    std::vector<int> order;
    m_common.method[0].ordering = CHOLMOD_AMD;
    Upper_pattern pairs = find_pairs(m_pattern);
    if (pairs.size() > 0)
    {
      std::vector<int> order_of_pairs(pairs.size());
      cholmod_sparse graph = view(pairs, nullptr);
      if (cholmod_amd(&graph, nullptr, 0, order_of_pairs.data(), &m_common) == 0) { return; }
      for (int i : order_of_pairs) { order.insert(order.end(), {2 * i, 2 * i + 1}); }
      m_common.method[0].ordering = CHOLMOD_GIVEN;
    }
    m_factor = cholmod_analyze_p(&matrix, order.empty() ? nullptr : order.data(), nullptr, 0, &m_common);
  }

  cholmod_common m_common{};
  cholmod_factor* m_factor = nullptr;
  Upper_pattern m_pattern; // of the last matrix that was analyzed
};

} // namespace

std::unique_ptr<Sparse_solver> make_cholmod_solver() { return std::make_unique<Cholmod_solver>(); }

} // namespace internal

} // namespace meridian
#endif // MERIDIAN_HAS_CHOLMOD
