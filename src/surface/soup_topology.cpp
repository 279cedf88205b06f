// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/surface/internal/soup_topology.h>

#include <meridian/base/exceptions.h>
#include <meridian/base/group_by.h>

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
  t.triangles.reserve(soup.number_of_polygons());
  t.index.reserve(soup.number_of_polygons());
  t.polygon.reserve(soup.number_of_polygons());
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
  std::vector<std::array<Index, 2>> key(sides); // lower end, higher end
  Index highest = 0;
  for (Index side = 0; side < sides; ++side)
  {
    const auto [u, v] = t.ends(side);
    key[side] = {std::min(u, v), std::max(u, v)};
    highest = std::max(highest, key[side][1]);
  }
  Groups bucket = group_by(highest + 1, sides, [&](Index side) { return key[side][0]; });
  t.twin.assign(sides, -1);
  std::vector<std::pair<Index, Index>> crowded;
  for (Index u = 0; u <= highest; ++u)
  {
    const auto first = bucket.element.begin() + bucket.begin[u], last = bucket.element.begin() + bucket.begin[u + 1];
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

namespace {

void make_unique(std::vector<Index>& list)
{
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

// Turns the faces of a soup over, component by component.
class Orienter
{
public:
  explicit Orienter(Soup_topology& t) : m_soup(t), m_known(t.triangles.size(), 0), m_turned(t.triangles.size(), 0) {}

  void orient(std::vector<std::string>& repairs)
  {
    for (Index f = 0; f < static_cast<Index>(m_soup.triangles.size()); ++f)
    {
      if (!m_known[f]) { orient_component(f); }
    }
    refuse_conflicts();
    if (m_flipped.empty()) { return; }
    make_unique(m_flipped);
    repairs.push_back(list_elements("faces turned over to agree with their neighbours", m_flipped));
  }

private:
  // Walks over the component of face `f` and turns over the fewer of its faces.
  void orient_component(Index f)
  {
    m_known[f] = 1;
    m_part.assign(1, f);
    bool has_conflict = false;
    for (std::size_t i = 0; i < m_part.size(); ++i)
      for (Index k = 0; k < 3; ++k)
      {
        if (!agree_across(3 * m_part[i] + k)) { has_conflict = true; }
      }
    m_one_sided += has_conflict;
    std::size_t count = 0;
    for (Index g : m_part) { count += m_turned[g]; }
    const bool invert = 2 * count > m_part.size();
    for (Index g : m_part)
    {
      if (static_cast<bool>(m_turned[g]) != invert) { turn_over(g); }
    }
  }

  // Tells the face across a side whether it is to be turned. Returns false if it was told otherwise before, the first
  // time that is seen.
  bool agree_across(Index side)
  {
    const Index f = side / 3, o = m_soup.twin[side];
    if (o < 0) { return true; }
    const bool same_direction = m_soup.ends(side).first == m_soup.ends(o).first;
    const char wanted = static_cast<char>(m_turned[f] ^ static_cast<char>(same_direction));
    if (!m_known[o / 3])
    {
      m_known[o / 3] = 1;
      m_turned[o / 3] = wanted;
      m_part.push_back(o / 3);
    }
    else if (m_turned[o / 3] != wanted && side < o)
    {
      m_conflicts.push_back(m_soup.polygon[f]);
      return false;
    }
    return true;
  }

  // Sides 0 and 2 of the face change places.
  void turn_over(Index g)
  {
    std::swap(m_soup.triangles[g][1], m_soup.triangles[g][2]);
    m_soup.is_flipped[g] = 1;
    m_flipped.push_back(m_soup.polygon[g]);
    const Index a = 3 * g, b = 3 * g + 2;
    std::swap(m_soup.twin[a], m_soup.twin[b]);
    for (Index side : {a, b, 3 * g + 1})
      if (m_soup.twin[side] >= 0 && m_soup.twin[side] / 3 != g) { m_soup.twin[m_soup.twin[side]] = side; }
    for (auto& sides : m_soup.crowded)
      for (Index& side : sides)
      {
        if (side == a || side == b) { side = a + b - side; }
      }
  }

  void refuse_conflicts()
  {
    if (m_conflicts.empty()) { return; }
    make_unique(m_conflicts);
    throw Invalid_input_error(
      "the surface is not orientable (" + std::to_string(m_one_sided) + " component" + (m_one_sided == 1 ? "" : "s")
      + " like a Moebius strip or Klein bottle): walking over the surface changes sides at "
      + list_elements("faces", m_conflicts) + "; only orientable surfaces have meridians. Cut it open first");
  }

  Soup_topology& m_soup;
  std::vector<char> m_known, m_turned;
  std::vector<Index> m_part; // the component at hand
  std::vector<Index> m_flipped, m_conflicts;
  Index m_one_sided = 0;
};

} // namespace

void orient(Soup_topology& t, std::vector<std::string>& repairs) { Orienter(t).orient(repairs); }

namespace {

// The fan of each corner, named by its first corner.
std::vector<Index> find_fans(const Soup_topology& t)
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
  for (Index c = 0; c < corners; ++c) { fan[c] = find(c); }
  return fan;
}

// Gives each fan a vertex: the first at a point keeps it, others get new ones. Returns the points that are divided.
std::vector<Index> divide_points(Soup_topology& t, std::size_t points, std::vector<Index>& added)
{
  const std::vector<Index> fan = find_fans(t);
  const Index corners = static_cast<Index>(fan.size());
  std::vector<Index> vertex(corners, -1), pinched;
  std::vector<char> is_kept(points, 0);
  for (Index c = 0; c < corners; ++c)
  {
    const Index point = t.triangles[c / 3][c % 3];
    if (fan[c] != c) { vertex[c] = vertex[fan[c]]; }
    else if (!is_kept[point])
    {
      is_kept[point] = 1;
      vertex[c] = point;
    }
    else
    {
      vertex[c] = static_cast<Index>(points + added.size());
      added.push_back(point);
      pinched.push_back(point);
    }
  }
  for (Index c = 0; c < corners; ++c) { t.triangles[c / 3][c % 3] = vertex[c]; }
  make_unique(pinched);
  return pinched;
}

// Glues the sides of a crowded edge that are alone with each other now, and notes those that are not.
void glue_crowded(Soup_topology& t, const std::vector<Index>& sides, std::vector<std::pair<Index, Index>>& stuck)
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

} // namespace

void separate_fans(Soup_topology& t, std::size_t points, std::vector<Index>& added, std::vector<std::string>& repairs)
{
  const std::vector<Index> pinched = divide_points(t, points, added);
  std::vector<std::pair<Index, Index>> stuck;
  for (const auto& sides : t.crowded) { glue_crowded(t, sides, stuck); }
  if (!stuck.empty())
    throw Invalid_input_error(
      list_elements("edges with three or more faces cannot be split, because the faces still share both ends", stuck)
      + "; remove the extra faces");
  if (!pinched.empty())
  {
    repairs.push_back(list_elements("vertices divided where several fans of faces meet", pinched));
  }
}

} // namespace internal

} // namespace meridian
