// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/surface/internal/soup_topology.h>

#include <meridian/base/exceptions.h>

#include <cmath>
#include <cstdint>
#include <numeric>
#include <tuple>

namespace meridian {

namespace internal {

std::pair<Index, Index> Soup_topology::ends(Index side) const
{
  const auto& t = triangles[side / 3];
  return {t[side % 3], t[(side + 1) % 3]};
}

void check_indices_and_points(const Polygon_soup& soup)
{
  std::vector<Index> bad, not_finite;
  std::vector<char> seen(soup.points.size(), 0);
  for (std::size_t i = 0; i < soup.number_of_polygons(); ++i)
  {
    bool is_bad = false;
    for (std::size_t k = 0; k < soup.size(i); ++k)
    {
      const std::int32_t v = soup.corner(i, k);
      if (v < 0 || v >= static_cast<Index>(soup.points.size()))
      {
        is_bad = true;
        continue;
      }
      seen[v] = 1;
    }
    if (is_bad) { bad.push_back(static_cast<Index>(i)); }
  }
  if (!bad.empty())
    throw Invalid_input_error(list_elements("faces name a vertex that the file does not have", bad)
                              + "; the file is damaged: export it again");
  const auto is_usable = [](double x) { return std::abs(x) <= 1e300; };
  for (std::size_t v = 0; v < soup.points.size(); ++v)
    if (seen[v] && !(is_usable(soup.points[v][0]) && is_usable(soup.points[v][1]) && is_usable(soup.points[v][2])))
      not_finite.push_back(static_cast<Index>(v));
  if (!not_finite.empty())
    throw Invalid_input_error(
      list_elements("vertices of faces have a coordinate that is not a finite number, or beyond 1e300", not_finite)
      + "; give them positions, or remove their faces");
}

double bring_to_scale(std::vector<Point>& points)
{
  double largest = 0;
  for (const Point& p : points)
    for (double x : p) { largest = std::max(largest, std::abs(x)); }
  if (!(largest > 0) || (largest < 1e50 && largest > 1e-50)) { return 1; }
  int exponent = 0;
  std::frexp(largest, &exponent);
  for (Point& p : points)
    for (double& x : p) { x = std::ldexp(x, -exponent); }
  return std::ldexp(1., exponent);
}

Soup_topology gather_triangles(const Polygon_soup& soup, std::vector<std::string>& repairs)
{
  Soup_topology t;
  std::vector<char> is_dropped(soup.number_of_polygons(), 0), is_used(soup.points.size(), 0);
  std::vector<Index> dropped, divided, unused, sorted;
  for (std::size_t i = 0; i < soup.number_of_polygons(); ++i)
  {
    sorted.assign(soup.corners.begin() + soup.begin[i], soup.corners.begin() + soup.begin[i + 1]);
    std::sort(sorted.begin(), sorted.end());
    if (sorted.size() < 3 || std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
    {
      is_dropped[i] = 1;
      dropped.push_back(static_cast<Index>(i));
    }
    else if (sorted.size() > 3) { divided.push_back(static_cast<Index>(i)); }
  }
  for_each_triangle(soup, [&](Index triangle, Index polygon, Index a, Index b, Index c) {
    if (is_dropped[polygon]) { return; }
    t.triangles.push_back({a, b, c});
    t.index.push_back(triangle);
    t.polygon.push_back(polygon);
    is_used[a] = is_used[b] = is_used[c] = 1;
  });
  t.is_flipped.assign(t.triangles.size(), 0);
  for (std::size_t v = 0; v < is_used.size(); ++v)
  {
    if (!is_used[v]) { unused.push_back(static_cast<Index>(v)); }
  }
  if (!divided.empty())
  {
    repairs.push_back(list_elements("polygons divided into triangles, by a fan from the lowest vertex", divided));
  }
  if (!dropped.empty())
  {
    repairs.push_back(list_elements("faces left out, which repeat a vertex or have fewer than three", dropped));
  }
  if (!unused.empty()) { repairs.push_back(list_elements("vertices kept that no face uses", unused)); }
  return t;
}

void pair_sides(Soup_topology& t, bool split, std::vector<std::string>& repairs)
{
  const Index sides = 3 * static_cast<Index>(t.triangles.size());
  std::vector<std::array<Index, 3>> key(sides); // lower end, higher end, side
  Index highest = 0;
  for (Index side = 0; side < sides; ++side)
  {
    const auto [u, v] = t.ends(side);
    key[side] = {std::min(u, v), std::max(u, v), side};
    highest = std::max(highest, key[side][1]);
  }
  std::vector<Index> begin(highest + 2, 0), bucket(sides); // counting sort by the lower end, then small sorts
  for (const auto& k : key) { ++begin[k[0] + 1]; }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<Index> fill(begin.begin(), begin.end() - 1);
  for (const auto& k : key) { bucket[fill[k[0]]++] = k[2]; }
  t.twin.assign(sides, -1);
  std::vector<std::pair<Index, Index>> crowded;
  for (Index u = 0; u <= highest; ++u)
  {
    const auto first = bucket.begin() + begin[u], last = bucket.begin() + begin[u + 1];
    std::sort(first, last, [&](Index a, Index b) { return std::tie(key[a][1], a) < std::tie(key[b][1], b); });
    for (auto i = first, j = first; i != last; i = j)
    {
      while (j != last && key[*j][1] == key[*i][1]) { ++j; }
      if (j - i == 2)
      {
        t.twin[*i] = *(i + 1);
        t.twin[*(i + 1)] = *i;
      }
      else if (j - i > 2)
      {
        crowded.emplace_back(u, key[*i][1]);
        t.crowded.emplace_back(i, j);
      }
    }
  }
  if (crowded.empty()) { return; }
  if (!split)
    throw Invalid_input_error(list_elements("edges have three or more faces", crowded)
                              + "; the surface is not a manifold there. Repairing (--repair) splits these edges");
  repairs.push_back(list_elements("edges split that have three or more faces", crowded));
}

void orient(Soup_topology& t, std::vector<std::string>& repairs)
{
  const Index n = static_cast<Index>(t.triangles.size());
  std::vector<char> known(n, 0), turned(n, 0);
  std::vector<Index> flipped, conflicts, part;
  Index one_sided = 0;
  for (Index f = 0; f < n; ++f)
  {
    if (known[f]) { continue; }
    known[f] = 1;
    part.assign(1, f);
    bool has_conflict = false;
    std::size_t count = 0;
    for (std::size_t i = 0; i < part.size(); ++i)
      for (Index k = 0; k < 3; ++k)
      {
        const Index side = 3 * part[i] + k, o = t.twin[side];
        if (o < 0) { continue; }
        const bool same_direction = t.ends(side).first == t.ends(o).first;
        const char wanted = static_cast<char>(turned[part[i]] ^ static_cast<char>(same_direction));
        if (!known[o / 3])
        {
          known[o / 3] = 1;
          turned[o / 3] = wanted;
          part.push_back(o / 3);
        }
        else if (turned[o / 3] != wanted && side < o)
        {
          has_conflict = true;
          conflicts.push_back(t.polygon[part[i]]);
        }
      }
    one_sided += has_conflict;
    for (Index g : part) { count += turned[g]; }
    const bool invert = 2 * count > part.size(); // turn over the fewer
    for (Index g : part)
      if (static_cast<bool>(turned[g]) != invert)
      {
        std::swap(t.triangles[g][1], t.triangles[g][2]);
        t.is_flipped[g] = 1;
        flipped.push_back(t.polygon[g]);
        // Sides 0 and 2 change places.
        const Index a = 3 * g, b = 3 * g + 2;
        std::swap(t.twin[a], t.twin[b]);
        for (Index side : {a, b, 3 * g + 1})
          if (t.twin[side] >= 0 && t.twin[side] / 3 != g) { t.twin[t.twin[side]] = side; }
        for (auto& sides : t.crowded)
          for (Index& side : sides)
          {
            if (side == a || side == b) { side = a + b - side; }
          }
      }
  }
  if (!conflicts.empty())
  {
    std::sort(conflicts.begin(), conflicts.end());
    conflicts.erase(std::unique(conflicts.begin(), conflicts.end()), conflicts.end());
    throw Invalid_input_error(
      "the surface is not orientable (" + std::to_string(one_sided) + " component" + (one_sided == 1 ? "" : "s")
      + " like a Moebius strip or Klein bottle): walking over the surface changes sides at "
      + list_elements("faces", conflicts) + "; only orientable surfaces have meridians. Cut it open first");
  }
  if (!flipped.empty())
  {
    std::sort(flipped.begin(), flipped.end());
    flipped.erase(std::unique(flipped.begin(), flipped.end()), flipped.end());
    repairs.push_back(list_elements("faces turned over to agree with their neighbours", flipped));
  }
}

void separate_fans(Soup_topology& t, std::size_t points, std::vector<Index>& added, std::vector<std::string>& repairs)
{
  const Index corners = 3 * static_cast<Index>(t.triangles.size());
  std::vector<Index> fan(corners);
  std::iota(fan.begin(), fan.end(), Index(0));
  const auto find = [&](Index c) {
    while (fan[c] != c) { c = fan[c] = fan[fan[c]]; }
    return c;
  };
  const auto join = [&](Index a, Index b) {
    a = find(a);
    b = find(b);
    if (a != b) { fan[std::max(a, b)] = std::min(a, b); }
  };
  const auto next = [](Index side) { return side % 3 == 2 ? side - 2 : side + 1; };
  for (Index side = 0; side < corners; ++side)
  {
    const Index o = t.twin[side];
    if (o < side) { continue; }
    join(side, next(o)); // glued sides run in opposite directions
    join(next(side), o);
  }
  // A fan is named by its first corner; the first fan at a point keeps it.
  std::vector<Index> keeper(points, -1), vertex(corners, -1), pinched;
  for (Index c = 0; c < corners; ++c)
  {
    const Index point = t.triangles[c / 3][c % 3];
    if (find(c) != c)
    {
      vertex[c] = vertex[find(c)];
      continue;
    }
    if (keeper[point] < 0)
    {
      keeper[point] = c;
      vertex[c] = point;
      continue;
    }
    vertex[c] = static_cast<Index>(points + added.size());
    added.push_back(point);
    pinched.push_back(point);
  }
  for (Index c = 0; c < corners; ++c) { t.triangles[c / 3][c % 3] = vertex[c]; }

  std::vector<std::pair<Index, Index>> stuck;
  for (auto& sides : t.crowded)
  {
    std::vector<std::array<Index, 3>> by_ends;
    for (Index side : sides)
    {
      const auto [u, v] = t.ends(side);
      by_ends.push_back({std::min(u, v), std::max(u, v), side});
    }
    std::sort(by_ends.begin(), by_ends.end());
    for (std::size_t i = 0, j; i < by_ends.size(); i = j)
    {
      for (j = i; j < by_ends.size() && by_ends[j][0] == by_ends[i][0] && by_ends[j][1] == by_ends[i][1]; ++j) {}
      if (j - i == 1) { continue; }
      const Index a = by_ends[i][2], b = by_ends[i + 1][2];
      if (j - i == 2 && t.ends(a).first == t.ends(b).second)
      {
        t.twin[a] = b;
        t.twin[b] = a;
      }
      else { stuck.emplace_back(by_ends[i][0], by_ends[i][1]); }
    }
  }
  if (!stuck.empty())
    throw Invalid_input_error(
      list_elements("edges with three or more faces cannot be split, because the faces still share both ends", stuck)
      + "; remove the extra faces");
  if (!pinched.empty())
  {
    std::sort(pinched.begin(), pinched.end());
    pinched.erase(std::unique(pinched.begin(), pinched.end()), pinched.end());
    repairs.push_back(list_elements("vertices divided where several fans of faces meet", pinched));
  }
}

} // namespace internal

} // namespace meridian
