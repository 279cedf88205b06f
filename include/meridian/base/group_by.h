// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_BASE_GROUP_BY_H
#define MERIDIAN_BASE_GROUP_BY_H

#include <meridian/base/vectors.h>

#include <vector>

namespace meridian {

/// \ingroup PkgMeridianSurface
/// numbers in groups: group `g` has the elements `element[begin[g]]` to `element[begin[g + 1] - 1]`, ascending.
struct Groups
{
  std::vector<Index> begin;   ///< where each group begins in `element`, and after the last where it ends
  std::vector<Index> element; ///< the numbers, group after group
};

/// \ingroup PkgMeridianSurface
/// \returns the numbers 0 to `count` - 1 grouped by `key`, by counting sort
/// \param groups the number of groups
/// \param count the number of elements
/// \param key called twice for each number: its group, or -1 to leave it out
/// \par Complexity
/// Linear.
template <class Key> Groups group_by(Index groups, Index count, const Key& key)
{
  Groups g;
  g.begin.assign(groups + 1, 0);
  for (Index i = 0; i < count; ++i)
  {
    const Index k = key(i);
    if (k >= 0) { ++g.begin[k + 1]; }
  }
  for (Index k = 0; k < groups; ++k) { g.begin[k + 1] += g.begin[k]; }
  g.element.resize(g.begin.back());
  std::vector<Index> next(g.begin.begin(), g.begin.end() - 1);
  for (Index i = 0; i < count; ++i)
  {
    const Index k = key(i);
    if (k >= 0) { g.element[next[k]++] = i; }
  }
  return g;
}

} // namespace meridian

#endif // MERIDIAN_BASE_GROUP_BY_H
