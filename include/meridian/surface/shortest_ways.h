// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_SURFACE_SHORTEST_WAYS_H
#define MERIDIAN_SURFACE_SHORTEST_WAYS_H

#include <meridian/base/vectors.h>

#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace meridian {
namespace internal {

// The places that a search of shortest ways has come to and not yet left (Dijkstra 1959): the nearest first, and in
// their order `<` where they are equally far.
//
// What a search notes of a place is its own. A place that it comes to again on a shorter way is left once for each, so
// `leave` passes over what it knows better.
template <class Place> class Nearest_first
{
public:
  void reach(double distance, const Place& place) { m_queue.push({distance, place}); }

  bool is_empty() const { return m_queue.empty(); }
  void clear() { m_queue = {}; }
  double nearest() const { return m_queue.top().distance; }

  // Takes the nearest out.
  std::pair<double, Place> pop()
  {
    const Entry next = m_queue.top();
    m_queue.pop();
    return {next.distance, next.place};
  }

  // Calls `leave(distance, place)`, which may reach more, until it returns true or nothing is left. Returns whether it
  // did.
  template <class Leave> bool search(const Leave& leave)
  {
    while (!is_empty())
    {
      const auto [distance, place] = pop();
      if (leave(distance, place)) { return true; }
    }
    return false;
  }

private:
  struct Entry
  {
    double distance;
    Place place;
    // the queue has its greatest in front
    bool operator<(const Entry& e) const
    {
      return distance > e.distance || (!(distance < e.distance) && e.place < place);
    }
  };
  std::priority_queue<Entry> m_queue;
};

// The distance of each of some elements from the nearest start, infinite where no way leads.
//
// `for_each_neighbor(v, reach)` calls `reach(w, length)` for every neighbour `w` of `v`, which returns whether the way
// over `v` is the shortest to `w` so far.
template <class For_each_neighbor>
std::vector<double> find_shortest_ways(Index elements, const std::vector<std::pair<double, Index>>& starts,
                                       const For_each_neighbor& for_each_neighbor)
{
  std::vector<double> d(elements, std::numeric_limits<double>::infinity());
  Nearest_first<Index> queue;
  const auto reach_at = [&](Index v, double at) {
    if (!(at < d[v])) { return false; }
    d[v] = at;
    queue.reach(at, v);
    return true;
  };
  for (const auto& [at, v] : starts) { reach_at(v, at); }
  queue.search([&](double at, Index v) {
    if (at <= d[v])
    {
      for_each_neighbor(v, [&](Index w, double length) { return reach_at(w, at + length); });
    }
    return false;
  });
  return d;
}

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_SURFACE_SHORTEST_WAYS_H
