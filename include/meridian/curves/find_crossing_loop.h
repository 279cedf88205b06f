// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CURVES_FIND_CROSSING_LOOP_H
#define MERIDIAN_CURVES_FIND_CROSSING_LOOP_H

#include <meridian/curves/Normal_curves.h>

#include <limits>
#include <map>
#include <queue>
#include <unordered_map>

namespace meridian {
namespace internal {

// A way through gaps, each with the face by which the next one is reached.
struct Gap_walk
{
  struct Stop
  {
    Normal_curves::Gap gap;
    Index face_after;
  };
  std::vector<Stop> stops;
};

// Takes out of a closed walk what goes back the way it came: a gap left into the face it was reached from, and two gaps
// in a row on one edge.
inline void reduce(Gap_walk& walk)
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

struct Crossing_loop
{
  std::vector<Normal_curves::Step> steps;
  double length;
};

// Searches for loops; keeps its memory from one search to the next.
class Crossing_loop_search
{
public:
  explicit Crossing_loop_search(const Normal_curves& curves)
    : m_curves(curves), m_surface(curves.surface()), m_plain(m_surface.number_of_halfedges())
  {}

  // The shortest closed walk that crosses curve `m` once, from right to left, and no other curve: from the left side of
  // the curve through gaps to its right side, and along that side back to where it began. If the curve does not
  // separate the surface cut along the others there is one.
  Crossing_loop find(Index m)
  {
    std::map<Gap, Index> source, target; // the crossing of `m` beside it
    for (Index x : m_curves.crossings(m))
    {
      source.emplace(m_curves.beside(x, true), x);
      target.emplace(m_curves.beside(x, false), x);
    }
    const Gap end = search(source, target);
    if (end.edge < 0) { throw Internal_error("find_crossing_loop: the two sides of a curve cannot be joined"); }
    return close(end, source.at(walk_to(end).stops.front().gap), target.at(end));
  }

private:
  using Gap = Normal_curves::Gap;
  struct Reached
  {
    double distance = std::numeric_limits<double>::infinity();
    Gap from{-1, -1};
    Index face = -1;
    std::uint32_t run = 0; // the search that this belongs to
    bool is_done = false;
  };

  Reached& reached(const Gap& g)
  {
    Reached& r = m_curves.on(g.edge).empty()
                   ? m_plain[g.edge]
                   : m_crowded[static_cast<std::uint64_t>(g.edge) << 32 | static_cast<std::uint32_t>(g.place)];
    if (r.run != m_run)
    {
      r = Reached{};
      r.run = m_run;
    }
    return r;
  }
  Point point(const Gap& g) const { return m_surface.point_on(g.edge, m_curves.middle(g)); }

  // Dijkstra's algorithm on gaps; two are neighbours if they lie on one region of a face.
  Gap search(const std::map<Gap, Index>& source, const std::map<Gap, Index>& target)
  {
    ++m_run;
    m_crowded.clear();
    using Entry = std::tuple<double, Index, Index>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    for (const auto& [gap, x] : source)
    {
      reached(gap).distance = 0;
      queue.emplace(0., gap.edge, gap.place);
    }
    while (!queue.empty())
    {
      const Gap gap{std::get<1>(queue.top()), std::get<2>(queue.top())};
      queue.pop();
      Reached& here = reached(gap);
      if (here.is_done) { continue; }
      here.is_done = true;
      if (target.count(gap)) { return gap; }
      const double at = here.distance;
      const Point from = point(gap);
      for (Index h : {gap.edge, m_surface.opposite[gap.edge]})
      {
        // what lies in the face before was reached from there
        if (h < 0 || m_surface.face(h) == here.face) { continue; }
        m_curves.for_each_gap_around(gap, m_surface.face(h), [&](const Gap& to, Index) {
          if (m_surface.opposite[to.edge] < 0 || to == gap) { return; }
          Reached& there = reached(to);
          const double d = at + distance(from, point(to));
          if (there.is_done || !(d < there.distance)) { return; }
          there = {d, gap, m_surface.face(h), m_run, false};
          queue.emplace(d, to.edge, to.place);
        });
      }
    }
    return {-1, -1};
  }

  Gap_walk walk_to(const Gap& end)
  {
    Gap_walk walk;
    auto& stops = walk.stops;
    for (Gap g = end;; g = reached(g).from)
    {
      stops.push_back({g, reached(g).face}); // for now the face before it
      if (reached(g).face < 0) { break; }
    }
    std::reverse(stops.begin(), stops.end());
    for (std::size_t i = 0; i + 1 < stops.size(); ++i) { stops[i].face_after = stops[i + 1].face_after; }
    return walk;
  }

  // Goes back from beside crossing `last` to beside crossing `first` along the right side of their curve, the shorter
  // way round.
  Crossing_loop close(const Gap& end, Index first, Index last)
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
      stops.back().face_after = forward ? m_curves.face_after(x) : m_curves.face_after(y);
      if (y != first) { stops.push_back({m_curves.beside(y, false), -1}); }
      x = y;
    }
    reduce(walk);

    Crossing_loop loop{{}, reached(end).distance + std::min(onward, backward)};
    for (std::size_t i = 0; i < stops.size(); ++i)
    {
      const Index face = stops[(i + stops.size() - 1) % stops.size()].face_after;
      Index h = 3 * face;
      while (h < 3 * face + 3 && m_surface.edge(h) != stops[i].gap.edge) { ++h; }
      if (h == 3 * face + 3)
      {
        throw Internal_error("find_crossing_loop: a walk leaves a face through an edge of another");
      }
      loop.steps.push_back({h, stops[i].gap.place, m_curves.middle(stops[i].gap)});
    }
    return loop;
  }

  const Normal_curves& m_curves;
  const Triangle_surface& m_surface;
  std::vector<Reached> m_plain;                         // of edges without crossings
  std::unordered_map<std::uint64_t, Reached> m_crowded; // of gaps on the others
  std::uint32_t m_run = 0;
};

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_CURVES_FIND_CROSSING_LOOP_H
