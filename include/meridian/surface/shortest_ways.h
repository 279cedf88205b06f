// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_SURFACE_SHORTEST_WAYS_H
#define MERIDIAN_SURFACE_SHORTEST_WAYS_H

#include <meridian/base/vectors.h>

#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace meridian {
namespace internal {

// The distance of each vertex from the nearest source, infinity where none was found (Dijkstra 1959).
//
// `for_each_neighbor(v, reach)` calls `reach(w, length)` for every neighbour `w` of `v`, which returns whether the way
// over `v` is the shortest to `w` so far.
template <class For_each_neighbor>
std::vector<double> find_shortest_ways(Index vertices, const std::vector<Index>& sources,
                                       const For_each_neighbor& for_each_neighbor)
{
  std::vector<double> d(vertices, std::numeric_limits<double>::infinity());
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  const auto reach_at = [&](Index v, double at) {
    if (!(at < d[v])) { return false; }
    d[v] = at;
    queue.emplace(at, v);
    return true;
  };
  for (Index v : sources) { reach_at(v, 0); }
  while (!queue.empty())
  {
    const Entry next = queue.top();
    queue.pop();
    const double at = next.first;
    if (at > d[next.second]) { continue; }
    for_each_neighbor(next.second, [&](Index w, double length) { return reach_at(w, at + length); });
  }
  return d;
}

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_SURFACE_SHORTEST_WAYS_H
