// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CURVES_GAP_GRAPH_H
#define MERIDIAN_CURVES_GAP_GRAPH_H

#include <meridian/base/vectors.h>
#include <meridian/curves/Normal_curves.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/shortest_ways.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace meridian {
namespace internal {

// The gaps between normal curves as nodes of a graph, and cells that grow in it: two nodes are neighbours, as far apart
// as the middles of their gaps, if they lie on one region of a face. Nodes get numbers, and regions are traced, where
// and when a search comes to them; both stay until curves change there.
class Gap_graph
{
public:
  using Node = Index;

  // What the last search notes of a node.
  struct Reached
  {
    double distance = std::numeric_limits<double>::infinity(); // from its root
    Node from = -1;                                            // the node before it; -1 where a cell begins
    Index region = -1;                                         // that it was reached through
    Index root = -1;                                           // of its cell
  };

  explicit Gap_graph(const Normal_curves& curves)
    : m_curves(curves), m_surface(curves.surface()), m_first(curves.surface().number_of_halfedges(), -1)
  {}
  explicit Gap_graph(Normal_curves&& curves) = delete;

  // The node of a gap that lies inside the surface.
  Node node(const Gap& g);
  const Gap& gap(Node n) const { return m_nodes[n].gap; }
  // The middle of the gap.
  const Point& point(Node n) const { return m_nodes[n].point; }
  Index face(Index region) const { return m_members[region]; }
  const Reached& reached(Node n) { return record(n); }

  // Forgets everything.
  void forget();
  // Forgets what a curve changes that was added, or is to be removed.
  void forget_around(Index curve);

  // Begins another search.
  void clear();

  // The cell of a root begins at a node, so far away from the root, unless another is nearer. Returns whether it does.
  bool start(Node n, double distance, Index root) { return reach(n, {distance, -1, -1, root}); }

  // Grows all cells at once, none farther than `farthest` (Dijkstra's algorithm). Where two touch,
  // `touch(n, to, region, length)` is told the nodes on the two sides, the region that they lie on, and how far their
  // roots are apart that way; it may make `farthest` less. Of all ways between two cells' roots the shortest is told,
  // if it is at most twice as long as `farthest`.
  template <class Touch> void grow(double& farthest, const Touch& touch)
  {
    m_queue.search([&](double d, Node n) {
      if (d > farthest) { return true; }
      if (d <= record(n).distance) { leave(n, farthest, touch); }
      return false;
    });
  }

private:
  struct alignas(64) Gap_node // one cache line
  {
    Point point;
    Gap gap;
    std::array<Index, 2> regions; // in the face of the edge, and on its other side
    Reached reached;
    std::uint32_t run; // the search that this belongs to
  };

  Reached& record(Node n)
  {
    Gap_node& of = m_nodes[n];
    if (std::exchange(of.run, m_run) != m_run) { of.reached = Reached{}; }
    return of.reached;
  }

  bool reach(Node n, const Reached& r)
  {
    Reached& old = record(n);
    if (!(r.distance < old.distance)) { return false; }
    old = r;
    m_queue.reach(r.distance, n);
    return true;
  }

  template <class Touch> void leave(Node n, const double& farthest, const Touch& touch)
  {
    const Reached here = record(n);
    const Point from = point(n);
    for (bool is_opposite : {false, true})
    {
      const Index r = region(n, is_opposite);
      if (r == here.region) { continue; } // what lies there was reached from where this was
      const Index end = r + 2 + m_members[r + 1];
      for (Index i = r + 2; i < end; ++i)
      {
        const Node to = m_members[i];
        if (to == n) { continue; }
        const Reached& there = record(to);
        const double d = here.distance + distance(from, point(to));
        const bool is_for_good = there.distance <= here.distance;
        if (is_for_good && there.root != here.root && there.region != r) { touch(n, to, r, d + there.distance); }
        if (d <= farthest) { reach(to, {d, n, r, here.root}); }
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
  Nearest_first<Node> m_queue;
};

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_CURVES_GAP_GRAPH_H
