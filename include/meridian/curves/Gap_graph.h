// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CURVES_GAP_GRAPH_H
#define MERIDIAN_CURVES_GAP_GRAPH_H

#include <meridian/base/vectors.h>
#include <meridian/curves/Normal_curves.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/distance_rings.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace meridian {
namespace internal {

// The gaps between normal curves as nodes of a graph, and two cells that grow in it, from two sides. Two nodes are
// neighbours, as far apart as the middles of their gaps, if they lie on one region of a face. Nodes get numbers, and
// regions are traced, where and when a search comes to them; both stay until curves change there.
class Gap_graph
{
public:
  using Node = Index;
  enum Side : Index
  {
    LEFT,
    RIGHT
  };

  explicit Gap_graph(const Normal_curves& curves);
  explicit Gap_graph(Normal_curves&& curves) = delete;

  // The node of a gap that lies inside the surface.
  Node node(const Gap& g);
  Gap gap(Node n) const { return {m_nodes[n].edge, n - m_first[m_nodes[n].edge]}; }
  // The middle of the gap.
  const Point& point(Node n) const { return m_nodes[n].point; }

  // What the last search found: how far a node is from where a cell begins, infinite if the cell did not come to it;
  // the node before it on the shortest way, -1 where the cell begins; the face that the way crosses in between.
  double distance_from(Side side, Node n) { return known(n).distance[side]; }
  Node before(Side side, Node n) const { return m_nodes[n].arrival[side] >> 1; }
  Index face_before(Side side, Node n) const { return m_members[m_nodes[n].regions[m_nodes[n].arrival[side] & 1]]; }

  // Forgets everything.
  void forget();
  // Forgets what a curve changes that was added, or is to be removed.
  void forget_around(Index curve);

  // Begins another search.
  void clear() { ++m_run; }

  // The cell of a side begins at a node.
  void start(Side side, Node n) { reach(known(n), side, n, 0, -1, true); }

  // Grows both cells, neither farther than `farthest` (delta-stepping, Meyer and Sanders 2003). Where they meet,
  // `meet(n, length)` is told the node, and how long the way through it is from one beginning to the other; it may make
  // `farthest` less. The shortest of all ways is told, if it is at most twice as long as `farthest`.
  template <class Meet> void grow(double& farthest, const Meet& meet)
  {
    m_rings.search([&](Index label) { return m_nodes[label >> 1].distance[label & 1]; },
                   [&](Index label) { leave(static_cast<Side>(label & 1), label >> 1, farthest, meet); });
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  struct alignas(64) Gap_node // one cache line
  {
    Point point;
    std::array<double, 2> distance; // from the two sides
    std::array<Index, 2> arrival;   // twice the node before it, and 1 if it came through the second region; or -1
    std::array<Index, 2> regions;   // in the face of the edge, and on its other side; -1 if not traced
    Index edge;
    std::uint32_t run; // the search that distances and arrivals belong to
  };

  Gap_node& known(Node n)
  {
    Gap_node& of = m_nodes[n];
    if (std::exchange(of.run, m_run) != m_run)
    {
      of.distance.fill(infinity);
      of.arrival.fill(-1);
    }
    return of;
  }

  bool reach(Gap_node& there, Side side, Node n, double distance, Index arrival, bool goes_on)
  {
    if (!(distance < there.distance[side])) { return false; }
    there.distance[side] = distance;
    there.arrival[side] = arrival;
    if (goes_on) { m_rings.reach(distance, 2 * n + side); }
    return true;
  }

  template <class Meet> void leave(Side side, Node n, const double& farthest, const Meet& meet)
  {
    const double at = m_nodes[n].distance[side];
    if (at > farthest) { return; }
    const Point from = m_nodes[n].point;
    const Index arrival = m_nodes[n].arrival[side];
    for (Index is_opposite : {0, 1})
    {
      if (arrival >= 0 && (arrival & 1) == is_opposite) { continue; } // what lies there was reached from where this was
      const Index r = region(n, is_opposite), end = r + 2 + m_members[r + 1];
      for (Index i = r + 2; i < end; ++i)
      {
        const Node to = m_members[i];
        Gap_node& there = known(to);
        const double d = at + distance(from, there.point), opposite = there.distance[1 - side];
        const bool is_shorter = reach(there, side, to, d, 2 * n + (there.regions[0] != r), d <= farthest);
        if (is_shorter && opposite < infinity) { meet(to, d + opposite); }
      }
    }
  }

  // The region that a node lies on in the face of its edge, or on the other side.
  Index region(Node n, bool is_opposite);
  Index trace_region(Node n, Index face);
  void forget_edge(Index edge);

  const Normal_curves& m_curves;
  const Triangle_surface& m_surface;
  std::vector<Node> m_first; // of each edge: the node of its first gap, or -1
  std::vector<Gap_node> m_nodes;
  std::vector<Index> m_members; // of each region: its face, how many nodes it has, and these
  std::size_t m_forgotten = 0;  // nodes that are no more
  std::uint32_t m_run = 0;
  Distance_rings m_rings; // of labels: twice a node, and 1 for the right side
};

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_CURVES_GAP_GRAPH_H
