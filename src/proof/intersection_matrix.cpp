// SPDX-License-Identifier: GPL-3.0-or-later
// Where curves meet, counted with signs, and whether the matrix of these numbers is the symplectic one.
#include <meridian/proof/internal/Generator_verifier.h>

#include <algorithm>
#include <tuple>
#include <utility>

namespace meridian {

namespace verification {

void Generator_verifier::find_intersections()
{
  std::vector<std::pair<Id, Pass>> passes; // by vertex
  std::vector<std::pair<Id, Id>> edges;    // higher side, curve
  for (std::size_t c = 0; c < m_read.size(); ++c)
  {
    const auto& walk = m_read[c].walk;
    if (m_read[c].kind == BOUNDARY) { continue; }
    const auto& points = m_curves[c].points;
    for (std::size_t i = 0; i < walk.size(); ++i)
    {
      passes.push_back({points[i], {static_cast<Id>(c), points[(i + walk.size() - 1) % walk.size()], points[i + 1]}});
      edges.emplace_back(std::max(walk[i].first, m_result_twin[walk[i].first]), static_cast<Id>(c));
    }
  }
  std::sort(edges.begin(), edges.end());
  for (std::size_t i = 1; i < edges.size(); ++i)
    if (edges[i].first == edges[i - 1].first) { m_touches.insert({edges[i - 1].second, edges[i].second}); }
  for (const auto& [a, b] : m_touches) { complain(name(a) + " and " + name(b) + " run along one edge"); }
  std::sort(passes.begin(), passes.end(), [](const auto& a, const auto& b) {
    return std::tie(a.first, a.second.curve) < std::tie(b.first, b.second.curve);
  });
  for (std::size_t i = 0, j; i < passes.size(); i = j)
  {
    for (j = i; j < passes.size() && passes[j].first == passes[i].first; ++j) {}
    if (j - i < 2) { continue; }
    std::map<Id, int> place; // of the neighbours around the vertex
    for (Id s : rotation(passes[i].first))
    {
      place.emplace(corner(next_side(s)), static_cast<int>(place.size()));
      if (m_result_twin[next_side(next_side(s))] < 0)
      {
        place.emplace(corner(next_side(next_side(s))), static_cast<int>(place.size()));
      }
    }
    for (std::size_t a = i; a < j; ++a)
      for (std::size_t b = a + 1; b < j; ++b) { meet(passes[i].first, passes[a].second, passes[b].second, place); }
  }
}

void Generator_verifier::meet(Id v, const Pass& a, const Pass& b, const std::map<Id, int>& place)
{
  const auto key = std::make_pair(a.curve, b.curve);
  const int in = place.at(a.from), out = place.at(a.to);
  const auto is_right = [&](Id neighbor) { // counterclockwise from where `a` comes to where it goes
    const int p = place.at(neighbor);
    return in < out ? in < p && p < out : p > in || p < out;
  };
  const bool from_right = is_right(b.from), to_right = is_right(b.to);
  Meeting& m = m_meetings[key];
  ++m.vertices;
  m.vertex = v;
  if (from_right != to_right)
  {
    ++m.crossings;
    m.number += from_right ? 1 : -1;
  }
}

void Generator_verifier::fill_matrix(int component, const std::vector<Id>& curves, bool are_pairs)
{
  const std::size_t before = m_report.failures.size();
  Curve_count& count = m_counts[component];
  std::map<Id, int> row;
  for (std::size_t i = 0; i < curves.size(); ++i) { row[curves[i]] = static_cast<int>(i); }
  for (const auto& [key, m] : m_meetings)
  {
    const auto a = row.find(key.first), b = row.find(key.second);
    if (a == row.end() || b == row.end() || m.number == 0) { continue; }
    count.intersections[{a->second, b->second}] = m.number;
    count.intersections[{b->second, a->second}] = -m.number;
  }
  count.is_symplectic = count.intersections.size() == curves.size();
  for (std::size_t i = 0; i < curves.size(); i += 2)
  {
    const auto entry = count.intersections.find({static_cast<int>(i), static_cast<int>(i) + 1});
    count.is_symplectic = count.is_symplectic && entry != count.intersections.end() && entry->second == 1;
  }
  if (!are_pairs) { return; }
  std::set<std::pair<Id, Id>> seen;
  for (const auto& [key, m] : m_meetings)
  {
    if (!row.count(key.first) || m_touches.count(key)) { continue; }
    const bool is_pair = m_read[key.first].number == m_read[key.second].number;
    const std::string both = name(key.first) + " and " + name(key.second);
    if (!is_pair)
    {
      complain(both + (m.crossings == 0 ? " touch" : " cross") + ", at " + std::to_string(m.vertices)
               + " vertices (last: " + std::to_string(m.vertex) + ")");
      continue;
    }
    seen.insert(key);
    const int forward = m_read[key.first].kind == MERIDIAN ? m.number : -m.number;
    if (m.vertices != 1) { complain(both + " share " + std::to_string(m.vertices) + " vertices, not one"); }
    else if (m.crossings == 0)
    {
      complain(both + " touch at vertex " + std::to_string(m.vertex) + " without crossing");
    }
    else if (forward != 1) { complain(both + " cross with the intersection number -1: one of them is reversed"); }
  }
  for (std::size_t i = 0; i + 1 < curves.size(); i += 2)
    if (!seen.count(std::minmax(curves[i], curves[i + 1])))
    {
      complain(name(curves[i]) + " and " + name(curves[i + 1]) + " do not meet");
    }
  if (!count.is_symplectic && m_report.failures.size() == before)
    complain("the intersection matrix of component " + std::to_string(component)
             + " is not the standard symplectic one");
}

} // namespace verification

} // namespace meridian
