// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_PROOF_INTERNAL_VERIFY_COUNTS_H
#define MERIDIAN_PROOF_INTERNAL_VERIFY_COUNTS_H

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace meridian {
namespace verification {

using Id = std::int32_t;

inline Id next_side(Id s) { return s % 3 == 2 ? s - 2 : s + 1; }

class Union_find
{
public:
  explicit Union_find(std::size_t n) : m_parent(n) { std::iota(m_parent.begin(), m_parent.end(), Id(0)); }
  Id find(Id a);
  void join(Id a, Id b);

private:
  std::vector<Id> m_parent;
};

// Calls f(first, last) for each group of sides with the same two ends; sides with an end below 0 are left out.
template <class Ends, class Function> void for_each_edge(Id sides, Id vertices, const Ends& ends, Function f)
{
  std::vector<Id> begin(vertices + 1, 0), bucket(sides), high(sides, -1);
  for (Id s = 0; s < sides; ++s)
  {
    const auto [a, b] = ends(s);
    if (a < 0 || b < 0) { continue; }
    high[s] = std::max(a, b);
    ++begin[std::min(a, b) + 1];
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<Id> fill(begin.begin(), begin.end() - 1);
  for (Id s = 0; s < sides; ++s)
    if (high[s] >= 0)
    {
      const auto [a, b] = ends(s);
      bucket[fill[std::min(a, b)]++] = s;
    }
  for (Id v = 0; v < vertices; ++v)
  {
    const auto first = bucket.begin() + begin[v], last = bucket.begin() + begin[v + 1];
    std::sort(first, last, [&](Id a, Id b) { return high[a] != high[b] ? high[a] < high[b] : a < b; });
    for (auto i = first, j = first; i != last; i = j)
    {
      while (j != last && high[*j] == high[*i]) { ++j; }
      f(i, j);
    }
  }
}

// Euler characteristics and boundary loops of triangles glued along `twin`, by classes of faces.
struct Counts
{
  std::vector<int> vertices, edges, faces, loops;
};

template <class Class_of>
Counts count_glued(Id faces, const std::vector<Id>& twin, int classes, const Class_of& class_of, Union_find& fans)
{
  Counts c{std::vector<int>(classes, 0), std::vector<int>(classes, 0), std::vector<int>(classes, 0),
           std::vector<int>(classes, 0)};
  Union_find loops(3 * static_cast<std::size_t>(faces));
  std::vector<char> is_on_boundary(3 * static_cast<std::size_t>(faces), 0);
  for (Id s = 0; s < 3 * faces; ++s)
  {
    c.edges[class_of(s / 3)] += twin[s] < s; // an edge counts with its higher side, or its only one
    if (fans.find(s) == s) { ++c.vertices[class_of(s / 3)]; }
    if (twin[s] < 0)
    {
      loops.join(fans.find(s), fans.find(next_side(s)));
      is_on_boundary[fans.find(s)] = is_on_boundary[fans.find(next_side(s))] = 1;
    }
  }
  for (Id f = 0; f < faces; ++f) { ++c.faces[class_of(f)]; }
  for (Id s = 0; s < 3 * faces; ++s) { c.loops[class_of(s / 3)] += is_on_boundary[s] && loops.find(s) == s; }
  return c;
}

} // namespace verification
} // namespace meridian

#endif // MERIDIAN_PROOF_INTERNAL_VERIFY_COUNTS_H
