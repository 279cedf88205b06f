// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/curves/passings.h>

namespace meridian {

namespace internal {

std::vector<Passing> passings_of(const Normal_curves& curves, Index c)
{
  std::vector<Passing> passings;
  for (Index x : curves.crossings(c))
    passings.push_back({curves[x].halfedge, curves.edge(x) == curves[x].halfedge ? curves[x].t : 1 - curves[x].t});
  return passings;
}

} // namespace internal

} // namespace meridian
