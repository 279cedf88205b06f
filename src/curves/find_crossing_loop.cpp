// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/curves/find_crossing_loop.h>

#include <meridian/base/exceptions.h>
#include <meridian/curves/chords.h>

#include <algorithm>
#include <cstddef>

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
  const Way way = search(m);
  if (way.node < 0) { throw Internal_error("find_crossing_loop: the two sides of a curve cannot be joined"); }
  double length = 0;
  const Gap_walk walk = walk_along(way, length);
  const std::vector<Index> crossings = m_curves.crossings(m);
  const auto crossing_beside = [&](const Gap& g, bool is_left) {
    return *std::find_if(crossings.begin(), crossings.end(),
                         [&](Index x) { return gap_beside(m_curves, x, is_left) == g; });
  };
  return close(walk, length, crossing_beside(walk.stops.front().gap, true),
               crossing_beside(walk.stops.back().gap, false));
}

Crossing_loop_search::Way Crossing_loop_search::search(Index m)
{
  m_graph.clear();
  Way way;
  for (const Gap_graph::Side side : {Gap_graph::LEFT, Gap_graph::RIGHT})
    for (Index x : m_curves.crossings(m))
    {
      const Gap_graph::Node n = m_graph.node(gap_beside(m_curves, x, side == Gap_graph::LEFT));
      m_graph.start(side, n);
      if (side == Gap_graph::RIGHT && !(m_graph.distance_from(Gap_graph::LEFT, n) > 0))
      {
        way = {0, n}; // where the curve turns back on an edge
      }
    }
  double farthest = way.length / 2;
  m_graph.grow(farthest, [&](Gap_graph::Node n, double length) {
    if (!(length < way.length)) { return; }
    way = {length, n};
    farthest = length / 2;
  });
  return way;
}

Gap_walk Crossing_loop_search::walk_along(const Way& way, double& length)
{
  Gap_walk walk;
  const auto add = [&](Gap_graph::Node n, Index face_after) { walk.stops.push_back({m_graph.gap(n), face_after}); };
  length = 0;
  const auto go = [&](Gap_graph::Side side, const auto& visit) {
    for (Gap_graph::Node n = way.node; m_graph.before(side, n) >= 0; n = m_graph.before(side, n))
    {
      length += distance(m_graph.point(n), m_graph.point(m_graph.before(side, n)));
      visit(m_graph.before(side, n), m_graph.face_before(side, n));
    }
  };
  go(Gap_graph::LEFT, add);
  std::reverse(walk.stops.begin(), walk.stops.end());
  add(way.node, -1);
  go(Gap_graph::RIGHT, [&](Gap_graph::Node n, Index face) {
    walk.stops.back().face_after = face;
    add(n, -1);
  });
  return walk;
}

Crossing_loop Crossing_loop_search::close(Gap_walk walk, double across, Index first, Index last)
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

  Crossing_loop loop{{}, across, across + std::min(onward, backward)};
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
