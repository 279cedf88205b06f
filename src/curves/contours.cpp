// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/curves/contours.h>

#include <meridian/base/exceptions.h>
#include <meridian/field/critical_points.h>
#include <meridian/surface/Closed_model.h>

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <queue>
#include <utility>

namespace meridian {

Contour trace_contour(const Ordered_surface& m, Index start, Index level)
{
  Contour c;
  c.level = level;
  Index h = start;
  do {
    c.halfedges.push_back(h);
    const Index o = m.surface.opposite[h];
    h = m.rank[m.surface.apex(o)] > level ? m.surface.next(o) : m.surface.prev(o);
  } while (h != start);
  return c;
}

std::vector<Contour> trace_level(const Ordered_surface& m, Index level)
{
  std::vector<Contour> contours;
  std::vector<char> seen(m.surface.number_of_halfedges(), 0);
  for (Index h = 0; h < m.surface.number_of_halfedges(); ++h)
  {
    if (seen[h] || m.surface.opposite[h] < 0 || !rises_through(m, h, level)) { continue; }
    contours.push_back(trace_contour(m, h, level));
    for (Index crossed : contours.back().halfedges) { seen[crossed] = 1; }
  }
  return contours;
}

double crossing_fraction(const Ordered_surface& m, Index h, Index level)
{
  const Index a = m.graph.node[m.surface.source(h)], b = m.graph.node[m.surface.target(h)];
  const Index below = m.order.nodes[level], above = m.order.nodes[level + 1];
  const Index r = std::max(m.field.region_of(a), m.field.region_of(b));
  const double from = m.field.value_in(r, a), to = m.field.value_in(r, b);
  const double at = (m.field.value_in(r, below) + m.field.value_in(r, above)) / 2;
  if (!(from < to)) { return 0.5; }
  if (!(at > from)) { return 0; }
  if (!(at < to)) { return 1; }
  if (m.placement)
  {
    const double t = m.placement(from, to, at);
    return t >= 0 && t <= 1 ? t : 0.5; // no topology rests on it
  }
  return std::min((at - from) / (to - from), 1.);
}

double length(const Ordered_surface& m, const Contour& c)
{
  Surface_curve curve;
  curve.closed = true;
  for (Index h : c.halfedges) { curve.points.push_back(Curve_point::on_edge(h, crossing_fraction(m, h, c.level))); }
  return length(m.surface, curve);
}

namespace {

// A halfedge that rises through `level`, reached from halfedge `h` by always going on to the highest (lowest) node.
// With no critical node on the way, it lies on the contour that the one through `h` becomes at `level`.
Index climb(const Ordered_surface& m, Index h, Index level, bool up)
{
  while (up ? m.rank[m.surface.target(h)] <= level : m.rank[m.surface.target(h)] > level)
  {
    Index best = -1;
    for_each_around_node(m.surface, m.surface.target(h), [&](Index g) {
      const Index r = m.rank[m.surface.target(g)];
      if (best < 0 || (up ? r > m.rank[m.surface.target(best)] : r < m.rank[m.surface.target(best)])) { best = g; }
    });
    h = best;
  }
  return up ? h : m.surface.opposite[h];
}

} // namespace

std::vector<Contour> trace_saddle_loops(const Ordered_surface& m, double away)
{
  std::vector<Contour> loops;
  const std::vector<Critical_point> critical = find_critical_points(m.surface, m.rank);
  std::vector<Index> ranks;
  for (const Critical_point& p : critical) { ranks.push_back(m.rank[p.vertex]); }
  std::sort(ranks.begin(), ranks.end());
  for (const Critical_point& p : critical)
  {
    if (p.kind != Critical_kind::SADDLE) { continue; }
    const Index rank = m.rank[p.vertex];
    std::array<Index, 2> up{-1, -1}, down{-1, -1}; // a halfedge into each sector
    std::vector<std::pair<Index, bool>> spokes;
    for_each_around_node(m.surface, p.vertex,
                         [&](Index h) { spokes.emplace_back(h, m.rank[m.surface.target(h)] > rank); });
    int ups = 0, downs = 0;
    for (std::size_t i = 0; i < spokes.size(); ++i)
      if (spokes[i].second != spokes[(i + spokes.size() - 1) % spokes.size()].second)
      {
        if (spokes[i].second ? ups == 2 : downs == 2)
        {
          throw Internal_error("trace_saddle_loops: a saddle is not simple");
        }
        (spokes[i].second ? up[ups++] : down[downs++]) = spokes[i].first;
      }
    const auto here = std::lower_bound(ranks.begin(), ranks.end(), rank);
    const Index level_up = rank + static_cast<Index>(away * (*std::next(here) - rank - 1));
    const Index level_down = rank - 1 - static_cast<Index>(away * (rank - 1 - *std::prev(here)));
    const auto pair_at = [&](const std::array<Index, 2>& sectors, Index level, bool is_up) {
      Contour one = trace_contour(m, climb(m, sectors[0], level, is_up), level);
      const Index start = climb(m, sectors[1], level, is_up);
      if (std::find(one.halfedges.begin(), one.halfedges.end(), start) != one.halfedges.end()) { return false; }
      Contour two = trace_contour(m, start, level);
      one.saddle = two.saddle = p.vertex;
      (length(m, one) > length(m, two) ? one : two).is_longer = true;
      loops.push_back(std::move(one));
      loops.push_back(std::move(two));
      return true;
    };
    if (!pair_at(up, level_up, true) && !pair_at(down, level_down, false))
      throw Internal_error("trace_saddle_loops: the contours of a saddle do not part");
  }
  std::vector<std::array<Index, 4>> key; // level, smallest halfedge, longer or not, place
  for (std::size_t i = 0; i < loops.size(); ++i)
    key.push_back({loops[i].level, *std::min_element(loops[i].halfedges.begin(), loops[i].halfedges.end()),
                   static_cast<Index>(loops[i].is_longer), static_cast<Index>(i)});
  std::sort(key.begin(), key.end());
  std::vector<char> is_repeated(loops.size(), 0);
  for (std::size_t i = 1; i < key.size(); ++i)
    is_repeated[key[i][3]] = key[i][0] == key[i - 1][0] && key[i][1] == key[i - 1][1];
  std::vector<Contour> unique;
  for (std::size_t i = 0; i < loops.size(); ++i)
  {
    if (!is_repeated[i]) { unique.push_back(std::move(loops[i])); }
  }
  return unique;
}

Contour find_tightest_contour(const Ordered_surface& m, const Contour& loop, const std::vector<char>& is_critical,
                              int samples)
{
  Contour best = loop;
  double shortest = length(m, loop);
  for (const bool up : {true, false})
  {
    // The nodes that the contour passes one after the other, up to the first critical one.
    std::priority_queue<Index, std::vector<Index>, std::greater<Index>> next; // ranks, or below their opposites
    const auto reach = [&](Index v) {
      const Index r = m.rank[v];
      if (up ? r > loop.level : r <= loop.level) { next.push(up ? r : -r); }
    };
    for (Index h : loop.halfedges) { reach(up ? m.surface.target(h) : m.surface.source(h)); }
    std::vector<Index> passed;
    while (!next.empty())
    {
      const Index r = up ? next.top() : -next.top(), node = m.order.nodes[r];
      next.pop();
      if (!passed.empty() && r == passed.back()) { continue; } // it was reached from several sides
      if (is_critical[node]) { break; }
      passed.push_back(r);
      for_each_around_node(m.surface, m.graph.representative[node], [&](Index h) {
        if (up ? m.rank[m.surface.target(h)] > r : m.rank[m.surface.target(h)] < r) { reach(m.surface.target(h)); }
      });
    }
    for (int i = 1; i <= samples; ++i)
    {
      const std::size_t k = passed.size() * i / samples;
      if (k == 0 || k == passed.size() * (i - 1) / samples) { continue; }
      const Index level = up ? passed[k - 1] : passed[k - 1] - 1;
      const Index h = loop.halfedges.front();
      Contour c = trace_contour(m, climb(m, up ? h : m.surface.opposite[h], level, up), level);
      c.saddle = loop.saddle;
      c.is_longer = loop.is_longer;
      const double l = length(m, c);
      if (!(l < shortest)) { continue; }
      shortest = l;
      best = std::move(c);
    }
  }
  return best;
}

} // namespace meridian
