// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_INTERNAL_EDGE_EXCHANGE_H
#define MERIDIAN_CUT_INTERNAL_EDGE_EXCHANGE_H

#include <meridian/base/vectors.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/shortest_ways.h>

#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace meridian {
namespace internal {

// Puts shorter paths of edges in the place of others in a cut graph, wherever they lie.
//
// The cut graph leaves a disc, and the rim of the disc passes every path twice. A way through the disc parts the rim in
// two, and may take the place of a path that has one side on each. The shortest ways between sides are found by growing
// a cell from every side, all at once: where two cells touch there is one.
class Edge_exchange
{
public:
  // `is_cut`: for each halfedge, equal on twins; the edges leave one disc.
  Edge_exchange(const Triangle_surface& s, std::vector<char>& is_cut);

  // Exchanges what there is to exchange at present, the most gainful first. Returns how many paths.
  int run();

private:
  using Path = std::vector<Index>; // of halfedges

  // A stretch of the rim between two nodes: one side of a path, or a part of the boundary of the surface.
  struct Side
  {
    Index begin, end; // places along the rim
    Index mate;       // the other side of the path; -1 on the boundary
    double length;
  };
  // What the growth of the cells knows of a vertex.
  struct Reached
  {
    double distance = std::numeric_limits<double>::infinity();
    Index by = -1;   // the halfedge to it
    Index root = -1; // the first halfedge of the way to it, which leaves the rim
  };
  // The way from one cell to another over a halfedge.
  struct Candidate
  {
    double length = std::numeric_limits<double>::infinity();
    Index over = -1;
  };

  bool is_wall(Index h) const { return m_surface.opposite[h] < 0 || m_is_cut[h]; }
  bool is_used(Index v) const { return m_degree[v] > 0 || m_surface.is_boundary_vertex(v); }
  bool is_node(Index v) const;

  // Goes round the rim and notes its corners and its sides. False if there is no path.
  bool walk();
  void find_sides();

  void grow();
  // Goes on along a halfedge from a vertex at some distance.
  void take(Index h, double distance, Index root, double farthest);
  // The place on the rim where the way begins that leads to the source of a halfedge and over it.
  Index begin_of(Index h) const;

  // One side of the longest path that a way between two places of the rim may replace, or -1.
  Index longest_between(Index from, Index to) const;
  // The way over a halfedge; empty if it is no more.
  Path path_over(Index h) const;
  bool try_exchange(Index over);
  void set(Index h, bool is_cut);
  // Takes out what dangles from a vertex.
  void prune(Index v);

  const Triangle_surface& m_surface;
  std::vector<char>& m_is_cut;
  std::vector<Index> m_degree; // of each vertex in the cut graph
  std::vector<Index> m_rim;    // the halfedges along it
  std::vector<Index> m_place;  // of each halfedge on the rim or away from it: the place of its corner
  std::vector<Side> m_sides;
  std::vector<Index> m_side; // of each place
  std::vector<Reached> m_reached;
  Nearest_first<Index> m_queue;
  std::map<std::pair<Index, Index>, Candidate> m_candidates; // of two sides
};

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_CUT_INTERNAL_EDGE_EXCHANGE_H
