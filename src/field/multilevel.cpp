// SPDX-License-Identifier: GPL-3.0-or-later
#include "multilevel.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace meridian {

namespace internal {

void Unit_matrix::reserve(Index n, std::size_t values)
{
  begin.reserve(static_cast<std::size_t>(n) + 1);
  middle.reserve(n);
  column.reserve(values);
  value.reserve(values);
}

void Unit_matrix::add_row(std::vector<std::pair<Index, double>>& row)
{
  const Index i = rows();
  begin.push_back(begin.back() + static_cast<Index>(row.size()));
  middle.push_back(0);
  column.resize(begin.back());
  value.resize(begin.back());
  set_row(i, row);
}

void Unit_matrix::set_row(Index i, std::vector<std::pair<Index, double>>& row)
{
  std::sort(row.begin(), row.end(), [](const auto& x, const auto& y) { return x.first < y.first; });
  Index place = begin[i];
  middle[i] = place;
  for (const auto& [j, x] : row)
  {
    middle[i] += j < i;
    column[place] = j;
    value[place++] = x;
  }
}

namespace {

template <class T> void append(std::vector<T>& to, const std::vector<T>& what)
{
  to.insert(to.end(), what.begin(), what.end());
}

} // namespace

void Sparse_rows::append(const Sparse_rows& rows)
{
  const Index before = begin.back();
  for (std::size_t i = 1; i < rows.begin.size(); ++i) { begin.push_back(before + rows.begin[i]); }
  internal::append(column, rows.column);
  internal::append(value, rows.value);
}

Index half_of(Index rows)
{
  constexpr Index least = 50000; // rows that are worth a thread
  return rows < least ? rows : rows / 2;
}

void Sparse_rows::reserve(Index n, std::size_t values)
{
  begin.reserve(static_cast<std::size_t>(n) + 1);
  column.reserve(values);
  value.reserve(values);
}

namespace {

// Writes rows of which values come in any order: those of one column are summed.
class Row_sum
{
public:
  explicit Row_sum(Sparse_rows& rows) : m_rows(rows), m_place(rows.columns, -1) {}

  void add(Index column, double x)
  {
    Index& place = m_place[column];
    if (place < m_rows.begin.back()) // of a row before
    {
      place = static_cast<Index>(m_rows.column.size());
      m_rows.column.push_back(column);
      m_rows.value.push_back(x);
    }
    else { m_rows.value[place] += x; }
  }
  void end_row() { m_rows.begin.push_back(static_cast<Index>(m_rows.column.size())); }

private:
  Sparse_rows& m_rows;
  std::vector<Index> m_place; // of each column, the last
};

// Which unknowns depend on which. How much `i` depends on `j` is how much `j` counts in the mean that `i` is of its
// neighbours: this tells by each row alone, so that an unknown beside a very short edge still depends on something.
class Dependence
{
public:
  Dependence(const Unit_matrix& a, const std::vector<double>& smooth)
    : m_matrix(a), m_smooth(smooth), m_least(a.rows(), 0)
  {
    constexpr double strong = 0.15; // of the most that a row depends on anything
    for (Index i = 0; i < a.rows(); ++i)
    {
      for (Index k = a.begin[i]; k < a.begin[i + 1]; ++k) { m_least[i] = std::max(m_least[i], degree(k)); }
      m_least[i] *= strong;
    }
  }

  // How much the row of a place depends on its column.
  double degree(Index place) const { return -m_matrix.value[place] * m_smooth[m_matrix.column[place]]; }
  bool is_strong(Index row, Index place) const { return degree(place) > m_least[row]; }
  // Whether the column depends as strongly on the row too.
  bool is_mutual(Index row, Index place) const
  {
    return is_strong(row, place) && -m_matrix.value[place] * m_smooth[row] > m_least[m_matrix.column[place]];
  }

private:
  const Unit_matrix& m_matrix;
  const std::vector<double>& m_smooth;
  std::vector<double> m_least; // of each row: what is more is strong
};

// Puts unknowns into groups that stand for one each on the next level.
class Aggregation
{
public:
  Aggregation(const Unit_matrix& a, const Dependence& dependence)
    : m_matrix(a), m_dependence(dependence), m_group(a.rows(), open)
  {
    make_whole_groups();
    join(true);
    join(false);
    make_remaining_groups();
  }

  Index number_of_groups() const { return m_groups; }
  // Of each unknown: its group, or -1 if it depends on no other.
  const std::vector<Index>& groups() const { return m_group; }

private:
  static constexpr Index none = -1, open = -2;

  template <class Function> void for_each_mutual(Index i, const Function& f) const
  {
    for (Index k = m_matrix.begin[i]; k < m_matrix.begin[i + 1]; ++k)
      if (m_dependence.is_mutual(i, k)) { f(m_matrix.column[k]); }
  }

  // An unknown whose neighbours are all open, with them.
  void make_whole_groups()
  {
    for (Index i = 0; i < m_matrix.rows(); ++i)
    {
      if (m_group[i] != open) { continue; }
      if (m_matrix.begin[i] == m_matrix.begin[i + 1]) { m_group[i] = none; }
      bool is_alone = true, is_free = true;
      for_each_mutual(i, [&](Index j) {
        is_alone = false;
        is_free = is_free && m_group[j] == open;
      });
      if (is_alone || !is_free) { continue; }
      m_group[i] = m_groups;
      for_each_mutual(i, [&](Index j) { m_group[j] = m_groups; });
      ++m_groups;
    }
  }

  // What is left joins the group that it depends on most, of those that there were before.
  void join(bool is_mutual)
  {
    std::vector<std::pair<Index, Index>> joined;
    for (Index i = 0; i < m_matrix.rows(); ++i)
    {
      if (m_group[i] != open) { continue; }
      double most = 0;
      Index to = open;
      for (Index k = m_matrix.begin[i]; k < m_matrix.begin[i + 1]; ++k)
      {
        const Index g = m_group[m_matrix.column[k]];
        const bool is_near = is_mutual ? m_dependence.is_mutual(i, k) : m_dependence.is_strong(i, k);
        if (g < 0 || !is_near || !(m_dependence.degree(k) > most)) { continue; }
        most = m_dependence.degree(k);
        to = g;
      }
      if (to >= 0) { joined.emplace_back(i, to); }
    }
    for (const auto& [i, to] : joined) { m_group[i] = to; }
  }

  void make_remaining_groups()
  {
    for (Index i = 0; i < m_matrix.rows(); ++i)
    {
      if (m_group[i] != open) { continue; }
      m_group[i] = m_groups;
      for_each_mutual(i, [&](Index j) {
        if (m_group[j] == open) { m_group[j] = m_groups; }
      });
      ++m_groups;
    }
  }

  const Unit_matrix& m_matrix;
  const Dependence& m_dependence;
  std::vector<Index> m_group;
  Index m_groups = 0;
};

// How values are made of those of the groups: what is smooth is met exactly, and one damped Jacobi step makes it
// smoother. Receives what is smooth on the groups.
Sparse_rows interpolate(const Unit_matrix& a, const Dependence& dependence, const Aggregation& aggregation,
                        std::vector<double>& smooth)
{
  constexpr double damping = 2. / 3; // 4/3 of what the largest eigenvalue is at most
  const std::vector<Index>& group = aggregation.groups();
  std::vector<double> size(aggregation.number_of_groups(), 0); // of what is smooth
  for (Index i = 0; i < a.rows(); ++i)
    if (group[i] >= 0) { size[group[i]] += smooth[i] * smooth[i]; }
  for (double& x : size) { x = std::sqrt(x); }
  Sparse_rows p;
  p.columns = aggregation.number_of_groups();
  make_by_halves(p, a.rows(), 3 * static_cast<std::size_t>(a.rows()), [&](Index first, Index last, Sparse_rows& part) {
    Row_sum sum(part);
    for (Index i = first; i < last; ++i)
    {
      double diagonal = 1; // with what is weak, so that the row still takes what is smooth to the same
      for (Index k = a.begin[i]; k < a.begin[i + 1]; ++k)
        if (!dependence.is_strong(i, k)) { diagonal -= dependence.degree(k) / smooth[i]; }
      if (!(diagonal > 0.1)) { diagonal = 1; }
      const auto add = [&](Index j, double x) {
        if (group[j] >= 0) { sum.add(group[j], x * smooth[j] / size[group[j]]); }
      };
      add(i, 1 - damping);
      for (Index k = a.begin[i]; k < a.begin[i + 1]; ++k)
        if (dependence.is_strong(i, k)) { add(a.column[k], -damping / diagonal * a.value[k]); }
      sum.end_row();
    }
  });
  smooth = std::move(size);
  return p;
}

// A P, for a matrix with ones on its diagonal
Sparse_rows multiply(const Unit_matrix& a, const Sparse_rows& p)
{
  Sparse_rows product;
  product.columns = p.columns;
  make_by_halves(product, a.rows(), 2 * p.column.size(), [&](Index first, Index last, Sparse_rows& part) {
    Row_sum sum(part);
    for (Index i = first; i < last; ++i)
    {
      for (Index l = p.begin[i]; l < p.begin[i + 1]; ++l) { sum.add(p.column[l], p.value[l]); }
      for (Index k = a.begin[i]; k < a.begin[i + 1]; ++k)
        for (Index l = p.begin[a.column[k]]; l < p.begin[a.column[k] + 1]; ++l)
        {
          sum.add(p.column[l], a.value[k] * p.value[l]);
        }
      sum.end_row();
    }
  });
  return product;
}

Sparse_rows transpose(const Sparse_rows& p)
{
  const Index n = p.rows(), m = p.columns;
  Sparse_rows t;
  t.columns = n;
  t.begin.assign(static_cast<std::size_t>(m) + 1, 0);
  t.column.resize(p.column.size());
  t.value.resize(p.column.size());
  for (Index c : p.column) { ++t.begin[c + 1]; }
  for (Index c = 0; c < m; ++c) { t.begin[c + 1] += t.begin[c]; }
  std::vector<Index> next(t.begin.begin(), t.begin.end() - 1);
  for (Index i = 0; i < n; ++i)
    for (Index l = p.begin[i]; l < p.begin[i + 1]; ++l)
    {
      const Index at = next[p.column[l]]++;
      t.column[at] = i;
      t.value[at] = p.value[l];
    }
  return t;
}

Sparse_rows multiply(const Sparse_rows& a, const Sparse_rows& b)
{
  Sparse_rows product;
  product.columns = b.columns;
  make_by_halves(product, a.rows(), b.column.size(), [&](Index first, Index last, Sparse_rows& part) {
    Row_sum sum(part);
    for (Index i = first; i < last; ++i)
    {
      for (Index k = a.begin[i]; k < a.begin[i + 1]; ++k)
        for (Index l = b.begin[a.column[k]]; l < b.begin[a.column[k] + 1]; ++l)
        {
          sum.add(b.column[l], a.value[k] * b.value[l]);
        }
      sum.end_row();
    }
  });
  return product;
}

// Ones on the diagonal of a symmetric matrix, by a scale of each unknown, which is written to `scale`.
Unit_matrix scale_to_ones(const Sparse_rows& a, std::vector<double>& scale)
{
  scale.assign(a.rows(), 1);
  for (Index i = 0; i < a.rows(); ++i)
    for (Index k = a.begin[i]; k < a.begin[i + 1]; ++k)
      if (a.column[k] == i && a.value[k] > 0) { scale[i] = 1 / std::sqrt(a.value[k]); }
  Unit_matrix result;
  result.reserve(a.rows(), a.column.size());
  std::vector<std::pair<Index, double>> row;
  for (Index i = 0; i < a.rows(); ++i)
  {
    row.clear();
    for (Index k = a.begin[i]; k < a.begin[i + 1]; ++k)
      if (a.column[k] != i) { row.emplace_back(a.column[k], a.value[k] * scale[i] * scale[a.column[k]]); }
    result.add_row(row);
  }
  return result;
}

// The matrix of the next level, in units of its own: `p` and `smooth` are changed to them.
Unit_matrix coarsen(const Unit_matrix& a, Sparse_rows& p, std::vector<double>& smooth)
{
  std::vector<double> scale;
  const Sparse_rows product = multiply(transpose(p), multiply(a, p)); // whose factors are gone in the next line
  Unit_matrix coarse = scale_to_ones(product, scale);
  for (std::size_t l = 0; l < p.value.size(); ++l) { p.value[l] *= scale[p.column[l]]; }
  for (std::size_t c = 0; c < scale.size(); ++c) { smooth[c] /= scale[c]; }
  return coarse;
}

} // namespace

Multilevel::Multilevel(const Unit_matrix& matrix, std::vector<double> smooth) : m_finest(matrix)
{
  constexpr Index few = 400;        // unknowns, which are solved for directly
  constexpr double too_slow = 0.75; // a level that is not smaller than this is not made
  m_levels.emplace_back();
  for (std::size_t i = 0; this->matrix(i).rows() > few; ++i)
  {
    const Unit_matrix& a = this->matrix(i);
    const Dependence dependence(a, smooth);
    const Aggregation aggregation(a, dependence);
    const Index groups = aggregation.number_of_groups();
    if (groups == 0 || groups > too_slow * a.rows()) { break; }
    Level next;
    m_levels[i].to_next = interpolate(a, dependence, aggregation, smooth);
    next.matrix = coarsen(a, m_levels[i].to_next, smooth);
    m_levels[i].right.resize(groups);
    if (half_of(a.rows()) < a.rows()) { m_levels[i].right_of_second.resize(groups); }
    m_levels[i].solution.resize(groups);
    m_levels.push_back(std::move(next));
  }
  for (std::size_t i = 0; i < m_levels.size(); ++i) { find_bridges(i); }
  if (this->matrix(m_levels.size() - 1).rows() <= few) { factor_last(); }
}

void Multilevel::factor_last()
{
  const Unit_matrix& a = matrix(m_levels.size() - 1);
  Eigen::MatrixXd dense = Eigen::MatrixXd::Identity(a.rows(), a.rows());
  for (Index i = 0; i < a.rows(); ++i)
    for (Index k = a.begin[i]; k < a.begin[i + 1]; ++k) { dense(i, a.column[k]) = a.value[k]; }
  m_last.compute(dense);
  m_is_last_factored = m_last.info() == Eigen::Success;
}

void Multilevel::find_bridges(std::size_t level)
{
  const Unit_matrix& a = matrix(level);
  const Index half = half_of(a.rows());
  for (Index i = 0; i < a.rows() && half < a.rows(); ++i)
  {
    if (a.begin[i] == a.begin[i + 1]) { continue; }
    if (i < half ? a.column[a.begin[i + 1] - 1] < half : a.column[a.begin[i]] >= half) { continue; }
    for (Index k = a.begin[i]; k < a.begin[i + 1]; ++k)
      if ((a.column[k] < half) != (i < half)) { m_levels[level].bridges.push_back({i, a.column[k], a.value[k]}); }
  }
}

// Gauss and Seidel's iteration, once forwards from zero in each half. What is then left of a row is what the places
// behind its diagonal take away, and those of the other half; the next level is asked for that.
void Multilevel::smooth_and_restrict(std::size_t level, const std::vector<double>& b, std::vector<double>& x)
{
  const Unit_matrix& a = matrix(level);
  Level& l = m_levels[level];
  const Sparse_rows& p = l.to_next;
  const auto restrict_to = [&](std::vector<double>& right, Index i, double residual) {
    for (Index k = p.begin[i]; k < p.begin[i + 1]; ++k) { right[p.column[k]] += p.value[k] * residual; }
  };
  for_both_halves(a.rows(), [&](Index first, Index last) {
    for (Index i = first; i < last; ++i)
    {
      double sum = b[i];
      Index k = a.begin[i];
      while (k < a.middle[i] && a.column[k] < first) { ++k; }
      for (; k < a.middle[i]; ++k) { sum -= a.value[k] * x[a.column[k]]; }
      x[i] = sum;
    }
    if (p.rows() == 0) { return; }
    std::vector<double>& right = first == 0 ? l.right : l.right_of_second;
    std::fill(right.begin(), right.end(), 0.);
    for (Index i = first; i < last; ++i)
    {
      double residual = 0;
      for (Index k = a.middle[i]; k < a.begin[i + 1] && a.column[k] < last; ++k)
      {
        residual -= a.value[k] * x[a.column[k]];
      }
      restrict_to(right, i, residual);
    }
  });
  if (p.rows() == 0) { return; }
  for (std::size_t c = 0; c < l.right_of_second.size(); ++c) { l.right[c] += l.right_of_second[c]; }
  for (const Bridge& bridge : l.bridges) { restrict_to(l.right, bridge.row, -bridge.value * x[bridge.column]); }
}

double Multilevel::corrected(const Level& level, Index i, const std::vector<double>& x) const
{
  const Sparse_rows& p = level.to_next;
  double sum = x[i];
  if (p.rows() == 0) { return sum; }
  for (Index k = p.begin[i]; k < p.begin[i + 1]; ++k) { sum += p.value[k] * level.solution[p.column[k]]; }
  return sum;
}

// Adds what the next level says, and iterates once backwards in each half, with what the other half has by then.
void Multilevel::correct_and_smooth(std::size_t level, const std::vector<double>& b, std::vector<double>& x)
{
  const Unit_matrix& a = matrix(level);
  Level& l = m_levels[level];
  std::vector<double> across(l.bridges.size());
  for (std::size_t i = 0; i < across.size(); ++i)
  {
    across[i] = l.bridges[i].value * corrected(l, l.bridges[i].column, x);
  }
  for_both_halves(a.rows(), [&](Index first, Index last) {
    for (Index i = first; i < last; ++i) { x[i] = corrected(l, i, x); }
    std::size_t bridge =
      std::partition_point(l.bridges.begin(), l.bridges.end(), [&](const Bridge& other) { return other.row < last; })
      - l.bridges.begin();
    for (Index i = last; i-- > first;)
    {
      double sum = b[i];
      for (; bridge > 0 && l.bridges[bridge - 1].row == i; --bridge) { sum -= across[bridge - 1]; }
      for (Index k = a.begin[i]; k < a.begin[i + 1]; ++k)
      {
        if (a.column[k] >= first && a.column[k] < last) { sum -= a.value[k] * x[a.column[k]]; }
      }
      x[i] = sum;
    }
  });
}

void Multilevel::cycle(std::size_t level, const std::vector<double>& b, std::vector<double>& x)
{
  const Unit_matrix& a = matrix(level);
  if (level + 1 == m_levels.size() && m_is_last_factored)
  {
    Eigen::Map<Eigen::VectorXd>(x.data(), a.rows()) =
      m_last.solve(Eigen::Map<const Eigen::VectorXd>(b.data(), a.rows()));
    return;
  }
  smooth_and_restrict(level, b, x);
  if (level + 1 < m_levels.size()) { cycle(level + 1, m_levels[level].right, m_levels[level].solution); }
  correct_and_smooth(level, b, x);
}

} // namespace internal

} // namespace meridian
