// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/curves/find_crossing_loop.h>

#include <meridian/base/exceptions.h>
#include <meridian/curves/chords.h>
#include <meridian/surface/shortest_ways.h>

#include <algorithm>

namespace meridian {

namespace internal {

namespace {

// Takes out of a closed walk what goes back the way it came: a gap left into the face it was reached from, and two gaps
// in a row on one edge.
void reduce(Gap_walk& walk)
{
  auto& stops = walk.stops;
  for (std::size_t i = 0, still = 0; still < stops.size() && !stops.empty();)
  {
    const std::size_t n = stops.size();
    i %= n;
    const std::size_t before = (i + n - 1) % n;
    if (stops[before].face_after == stops[i].face_after)
    {
      stops.erase(stops.begin() + i);
      still = 0;
      i = i > 1 ? i - 2 : i + stops.size();
    }
    else if (n > 1 && stops[before].gap.edge == stops[i].gap.edge)
    {
      stops.erase(stops.begin() + std::max(i, before));
      stops.erase(stops.begin() + std::min(i, before));
      still = 0;
      i = i > 2 ? i - 3 : i + stops.size();
    }
    else
    {
      ++still;
      ++i;
    }
  }
}

} // namespace

Crossing_loop Crossing_loop_search::find(Index m)
{
  std::map<Gap, Index> source, target; // the crossing of `m` beside it
  for (Index x : m_curves.crossings(m))
  {
    source.emplace(gap_beside(m_curves, x, true), x);
    target.emplace(gap_beside(m_curves, x, false), x);
  }
  const Gap end = search(source, target);
  if (end.edge < 0) { throw Internal_error("find_crossing_loop: the two sides of a curve cannot be joined"); }
  return close(end, source.at(walk_to(end).stops.front().gap), target.at(end));
}

Gap Crossing_loop_search::search(const std::map<Gap, Index>& source, const std::map<Gap, Index>& target)
{
  m_reached.forget();
  Nearest_first<Gap> queue;
  for (const auto& [gap, x] : source)
  {
    m_reached[gap].distance = 0;
    queue.reach(0, gap);
  }
  Gap end{-1, -1};
  queue.search([&](double at, const Gap& gap) {
    Reached& here = m_reached[gap];
    if (here.is_done) { return false; }
    here.is_done = true;
    if (target.count(gap))
    {
      end = gap;
      return true;
    }
    const Point from = point(gap);
    for (Index h : {gap.edge, m_surface.opposite[gap.edge]})
    {
      // what lies in the face before was reached from there
      if (h < 0 || m_surface.face(h) == here.face) { continue; }
      for_each_gap_around(m_curves, gap, m_surface.face(h), [&](const Gap& to, Index) {
        if (m_surface.opposite[to.edge] < 0 || to == gap) { return; }
        Reached& there = m_reached[to];
        const double d = at + distance(from, point(to));
        if (there.is_done || !(d < there.distance)) { return; }
        there = {d, gap, m_surface.face(h), m_reached.run(), false};
        queue.reach(d, to);
      });
    }
    return false;
  });
  return end;
}

Gap_walk Crossing_loop_search::walk_to(const Gap& end)
{
  Gap_walk walk;
  auto& stops = walk.stops;
  for (Gap g = end;; g = m_reached[g].from)
  {
    stops.push_back({g, m_reached[g].face}); // for now the face before it
    if (m_reached[g].face < 0) { break; }
  }
  std::reverse(stops.begin(), stops.end());
  for (std::size_t i = 0; i + 1 < stops.size(); ++i) { stops[i].face_after = stops[i + 1].face_after; }
  return walk;
}

Crossing_loop Crossing_loop_search::close(const Gap& end, Index first, Index last)
{
  const auto way = [&](bool forward) {
    double length = 0;
    for (Index x = last; x != first;)
    {
      const Index y = forward ? m_curves[x].next : m_curves[x].prev;
      length += distance(m_surface.point_on(m_curves.edge(x), m_curves[x].t),
                         m_surface.point_on(m_curves.edge(y), m_curves[y].t));
      x = y;
    }
    return length;
  };
  Gap_walk walk = walk_to(end);
  auto& stops = walk.stops;
  const double onward = way(true), backward = way(false);
  const bool forward = onward <= backward;
  if (first == last) { stops.pop_back(); } // the walk ends across from where it began
  for (Index x = last; x != first;)
  {
    const Index y = forward ? m_curves[x].next : m_curves[x].prev;
    stops.back().face_after = forward ? face_after(m_curves, x) : face_after(m_curves, y);
    if (y != first) { stops.push_back({gap_beside(m_curves, y, false), -1}); }
    x = y;
  }
  reduce(walk);

  Crossing_loop loop{{}, m_reached[end].distance + std::min(onward, backward)};
  for (std::size_t i = 0; i < stops.size(); ++i)
  {
    const Index face = stops[(i + stops.size() - 1) % stops.size()].face_after;
    Index h = 3 * face;
    while (h < 3 * face + 3 && m_surface.edge(h) != stops[i].gap.edge) { ++h; }
    if (h == 3 * face + 3)
    {
      throw Internal_error("find_crossing_loop: a walk leaves a face through an edge of another");
    }
    loop.steps.push_back({h, stops[i].gap.place, middle_of(m_curves, stops[i].gap)});
  }
  return loop;
}

} // namespace internal

} // namespace meridian
