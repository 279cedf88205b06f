// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_SURFACE_DISTANCE_RINGS_H
#define MERIDIAN_SURFACE_DISTANCE_RINGS_H

#include <meridian/base/vectors.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace meridian {
namespace internal {

// Places by distance, in rings of one width: those of the innermost ring come in any order, and may come again while
// there are shorter ways to them inside it (delta-stepping, Meyer and Sanders 2003).
class Distance_rings
{
public:
  explicit Distance_rings(double width) : m_rings_per_length(width > 0 ? 1 / width : 1) {}

  void reach(double distance, Index place)
  {
    const std::uint64_t ring = ring_of(distance) - m_first;
    if (ring < m_near.size()) { m_near[ring].push_back(place); }
    else { m_far.push_back(place); }
  }

  // Calls `leave(place)`, which may reach more, for each place, until nothing is left. `distance_of(place)`: so far.
  template <class Distance_of, class Leave> void search(const Distance_of& distance_of, const Leave& leave)
  {
    do {
      for (std::size_t ring = 0; ring < m_near.size(); ++ring)
      {
        std::vector<Index>& places = m_near[ring];
        for (std::size_t i = 0; i < places.size(); ++i)
        {
          const Index place = places[i];
          if (ring_of(distance_of(place)) == m_first + ring) { leave(place); } // not one that was left before
        }
        places.clear();
      }
    } while (take_far(distance_of));
    m_first = 0;
  }

private:
  std::uint64_t ring_of(double distance) const { return static_cast<std::uint64_t>(distance * m_rings_per_length); }

  // Goes on at the innermost of what is far. Returns false if there is nothing.
  template <class Distance_of> bool take_far(const Distance_of& distance_of)
  {
    const std::uint64_t done = m_first + m_near.size();
    const auto is_left = [&](Index place) { return ring_of(distance_of(place)) < done; };
    m_far.erase(std::remove_if(m_far.begin(), m_far.end(), is_left), m_far.end());
    if (m_far.empty()) { return false; }
    const auto is_nearer = [&](Index a, Index b) { return distance_of(a) < distance_of(b); };
    m_first = ring_of(distance_of(*std::min_element(m_far.begin(), m_far.end(), is_nearer)));
    std::vector<Index> far;
    far.swap(m_far);
    for (Index place : far) { reach(distance_of(place), place); }
    return true;
  }

  double m_rings_per_length;
  std::uint64_t m_first = 0; // the innermost ring that is near
  std::array<std::vector<Index>, 256> m_near;
  std::vector<Index> m_far;
};

// The distance of each of some elements from the nearest start, infinite where no way leads: what
// `find_shortest_ways()` finds, bit for bit, since a sum of floating-point numbers does not get smaller with a summand.
// Nothing is said of the ways, and in return no heap is kept. `width`: about the length from one element to the next.
// Elements beyond `limit` are infinitely far.
template <class For_each_neighbor>
std::vector<double> find_distances(Index elements, const std::vector<std::pair<double, Index>>& starts, double width,
                                   const For_each_neighbor& for_each_neighbor,
                                   double limit = std::numeric_limits<double>::infinity())
{
  std::vector<double> d(elements, std::numeric_limits<double>::infinity());
  Distance_rings rings(width);
  const auto reach = [&](Index v, double at) {
    if (!(at < d[v]) || at > limit) { return; }
    d[v] = at;
    rings.reach(at, v);
  };
  for (const auto& [at, v] : starts) { reach(v, at); }
  rings.search(
    [&](Index v) { return d[v]; },
    [&](Index v) { for_each_neighbor(v, [&, at = d[v]](Index w, double length) { reach(w, at + length); }); });
  return d;
}

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_SURFACE_DISTANCE_RINGS_H
