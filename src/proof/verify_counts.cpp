// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/proof/internal/verify_counts.h>

namespace meridian {

namespace verification {

Id Union_find::find(Id a)
{
  while (m_parent[a] != a) { a = m_parent[a] = m_parent[m_parent[a]]; }
  return a;
}

void Union_find::join(Id a, Id b)
{
  a = find(a);
  b = find(b);
  if (a != b) { m_parent[std::max(a, b)] = std::min(a, b); }
}

} // namespace verification

} // namespace meridian
