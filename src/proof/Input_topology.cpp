// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/proof/internal/Input_topology.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>
#include <vector>

namespace meridian {

namespace verification {

Input_topology::Input_topology(const Polygon_soup& input)
{
  take_triangles(input);
  const Id n = static_cast<Id>(triangles.size());
  twin.assign(3 * static_cast<std::size_t>(n), -1);
  Union_find fans(3 * static_cast<std::size_t>(n));
  for (const auto& sides : glue_pairs(static_cast<Id>(input.points.size()), fans)) { glue_crowded(sides, fans); }
  count_components(number_components(), fans);
}

void Input_topology::take_triangles(const Polygon_soup& input)
{
  std::vector<char> is_dropped(input.number_of_polygons(), 0);
  std::vector<Id> sorted;
  for (std::size_t i = 0; i < input.number_of_polygons(); ++i)
  {
    sorted.assign(input.corners.begin() + input.begin[i], input.corners.begin() + input.begin[i + 1]);
    std::sort(sorted.begin(), sorted.end());
    is_dropped[i] = sorted.size() < 3 || std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
    if (!sorted.empty() && (sorted.front() < 0 || sorted.back() >= static_cast<Id>(input.points.size())))
    {
      is_dropped[i] = 1;
      damaged.push_back(static_cast<Id>(i));
    }
  }
  first_triangle.assign(input.number_of_polygons() + 1, 0);
  triangles.reserve(input.number_of_polygons());
  is_used.reserve(input.number_of_polygons());
  for_each_triangle(input, [&](Id, Id polygon, Id a, Id b, Id c) {
    triangles.push_back({a, b, c});
    is_used.push_back(!is_dropped[polygon]);
    ++first_triangle[polygon + 1];
  });
  std::partial_sum(first_triangle.begin(), first_triangle.end(), first_triangle.begin());
}

std::vector<std::vector<Id>> Input_topology::glue_pairs(Id vertices, Union_find& fans)
{
  std::vector<std::vector<Id>> crowded;
  for_each_edge(
    static_cast<Id>(twin.size()), vertices, [&](Id s) { return ends(s); },
    [&](auto i, auto j) {
      if (j - i == 2) { glue(*i, *(i + 1), fans); }
      else if (j - i > 2)
      {
        crowded.emplace_back(i, j);
        const auto [a, b] = ends(*i);
        crowded_edges.insert({std::min(a, b), std::max(a, b)});
      }
    });
  return crowded;
}

void Input_topology::glue_crowded(const std::vector<Id>& sides, Union_find& fans)
{
  std::vector<std::array<Id, 3>> key;
  for (Id s : sides)
  {
    const Id a = fans.find(s), b = fans.find(next_side(s));
    const bool low_first = ends(s).first < ends(s).second;
    key.push_back({low_first ? a : b, low_first ? b : a, s});
  }
  std::sort(key.begin(), key.end());
  for (std::size_t i = 0, j; i < key.size(); i = j)
  {
    for (j = i; j < key.size() && key[j][0] == key[i][0] && key[j][1] == key[i][1]; ++j) {}
    if (j - i == 2) { glue(key[i][2], key[i + 1][2], fans); }
  }
}

int Input_topology::number_components()
{
  const Id n = static_cast<Id>(triangles.size());
  Union_find parts(n);
  for (Id s = 0; s < 3 * n; ++s)
  {
    if (twin[s] >= 0) { parts.join(s / 3, twin[s] / 3); }
  }
  component.assign(n, -1);
  int components = 0;
  for (Id t = 0; t < n; ++t)
  {
    if (!is_used[t]) { continue; }
    component[t] = parts.find(t) == t ? components++ : component[parts.find(t)];
  }
  return components;
}

void Input_topology::count_components(int components, Union_find& fans)
{
  counts.resize(components);
  const Counts c = count_glued(
    static_cast<Id>(triangles.size()), twin, components + 1,
    [&](Id t) { return component[t] < 0 ? components : component[t]; }, fans);
  for (int i = 0; i < components; ++i)
  {
    Component_count& count = counts[i];
    count.vertices = c.vertices[i];
    count.edges = c.edges[i];
    count.faces = c.faces[i];
    count.euler_characteristic = c.vertices[i] - c.edges[i] + c.faces[i];
    count.boundary_loops = c.loops[i];
    count.genus = (2 - count.euler_characteristic - count.boundary_loops) / 2;
  }
}

std::pair<Id, Id> Input_topology::ends(Id s) const
{
  if (!is_used[s / 3]) { return {-1, -1}; }
  return {triangles[s / 3][s % 3], triangles[s / 3][next_side(s) % 3]};
}

void Input_topology::glue(Id a, Id b, Union_find& fans)
{
  twin[a] = b;
  twin[b] = a;
  const bool opposite = ends(a).first == ends(b).second;
  fans.join(a, opposite ? next_side(b) : b);
  fans.join(next_side(a), opposite ? b : next_side(b));
}

} // namespace verification

} // namespace meridian
