// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CURVES_PASSINGS_H
#define MERIDIAN_CURVES_PASSINGS_H

#include <meridian/base/vectors.h>
#include <meridian/curves/Normal_curves.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/edge_places.h>

#include <vector>

namespace meridian {

namespace internal {

// Where a curve crosses edges, by the halfedges by which it leaves faces.
std::vector<Edge_place> places_of(const Normal_curves& curves, Index c);

// Takes crossings out of a closed sequence that are taken back at once.
template <class Sequence> void cancel(const Triangle_surface& s, Sequence& crossings)
{
  Sequence kept;
  for (const auto& c : crossings)
  {
    if (!kept.empty() && s.opposite[kept.back().halfedge] == c.halfedge) { kept.pop_back(); }
    else { kept.push_back(c); }
  }
  std::size_t first = 0, last = kept.size();
  while (last - first >= 2 && s.opposite[kept[last - 1].halfedge] == kept[first].halfedge)
  {
    ++first;
    --last;
  }
  crossings = {kept.begin() + first, kept.begin() + last};
}

} // namespace internal

} // namespace meridian

#endif // MERIDIAN_CURVES_PASSINGS_H
