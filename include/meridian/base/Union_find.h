// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_BASE_UNION_FIND_H
#define MERIDIAN_BASE_UNION_FIND_H

#include <meridian/base/vectors.h>

#include <numeric>
#include <utility>
#include <vector>

namespace meridian {

/// \ingroup PkgMeridianSurface
/// disjoint sets of the numbers 0 to `n` - 1 (\cite tarjan1975). The proof has one of its own, on purpose.
class Union_find
{
public:
  /// each number in a set of its own. \param n how many there are
  explicit Union_find(Index n) : m_parent(n), m_size(n, 1) { std::iota(m_parent.begin(), m_parent.end(), Index(0)); }

  /// \param a a number \returns the number that stands for its set
  Index find(Index a)
  {
    while (m_parent[a] != a) { a = m_parent[a] = m_parent[m_parent[a]]; }
    return a;
  }
  /// joins two sets. \param a, b a number of each \returns whether they were different
  bool unite(Index a, Index b)
  {
    a = find(a);
    b = find(b);
    if (a == b) { return false; }
    if (m_size[a] < m_size[b]) { std::swap(a, b); }
    m_parent[b] = a;
    m_size[a] += m_size[b];
    return true;
  }

private:
  std::vector<Index> m_parent, m_size;
};

} // namespace meridian

#endif // MERIDIAN_BASE_UNION_FIND_H
