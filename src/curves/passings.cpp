// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/curves/passings.h>

namespace meridian {

namespace internal {

std::vector<Edge_place> places_of(const Normal_curves& curves, Index c)
{
  std::vector<Edge_place> passings;
  for (Index x : curves.crossings(c))
    passings.push_back({curves[x].halfedge, turn_fraction(curves.surface(), curves[x].halfedge, curves[x].t)});
  return passings;
}

} // namespace internal

} // namespace meridian
