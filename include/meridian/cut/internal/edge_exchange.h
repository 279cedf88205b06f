// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_INTERNAL_EDGE_EXCHANGE_H
#define MERIDIAN_CUT_INTERNAL_EDGE_EXCHANGE_H

#include <meridian/base/vectors.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/shortest_ways.h>

#include <array>
#include <cstddef>
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
// a cell from every side, all at once: where two cells touch there is one. Without a path its own two cells are free,
// and the others grow on into them.
class Edge_exchange
{
public:
  // `is_cut`: for each halfedge, equal on twins; the edges leave one disc.
  Edge_exchange(const Triangle_surface& s, std::vector<char>& is_cut);

  // Straightens every path, and then exchanges what there is to exchange, the most gainful first. Returns how many
  // paths.
  int run();

  // The length of the cut graph.
  double length() const;

private:
  using Path = std::vector<Index>; // of halfedges, or vertices

  // A stretch of the rim between two nodes: one side of a path, or a part of the boundary of the surface.
  struct Side
  {
    Path halfedges;
    Index mate; // the other side of the path; -1 on the boundary
    double length;
  };
  // A corner of the rim: the place of a side among all sides, and that of the halfedge from the corner in it.
  struct Place
  {
    Index rank, index;
  };
  // What the growth of the cells knows of a vertex.
  struct Reached
  {
    double distance = std::numeric_limits<double>::infinity();
    Index by = -1;   // the halfedge to it
    Index root = -1; // the first halfedge of the way to it, which leaves the rim
  };
  // The halfedges that leave a cell, and whether it or one beside it grew since they were last known.
  struct Cell
  {
    Path border;
    bool is_new = false;
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

  // Goes round the rim. False if nothing is cut.
  bool begin();
  int straighten_all();
  int exchange_all();
  double length(const Path& path) const;

  // Goes round the rim from one of its halfedges on, at a node. Returns how many there are.
  Index walk(Index first);
  // Says of each side where in the order it stands, if that is not known.
  void number_sides();
  // The halfedge of the rim that begins at the corner that a halfedge lies in.
  Index corner(Index h) const;
  Place place(Index h) const { return {m_rank[m_side[corner(h)]], m_index[corner(h)]}; }

  // Cells grow from the whole rim; or, once they have, where paths were exchanged since.
  void grow();
  // Takes back what was reached from a path that is no more. Returns the free vertices that nothing reaches.
  Path forget_lost_ways();
  // Says of each vertex in whose cell it lies.
  void name_cells();
  // The shortest way where the cells of two sides touch, for all sides, and the borders of the cells.
  void find_candidates();
  double distance_of(Index v) const { return is_used(v) ? 0 : m_reached[v].distance; }
  // One side of the longest path that a way may replace, if that is longer than the way; or -1.
  Index longest_replaced(const Path& path) const;
  // The way over a halfedge; empty if it is no more.
  Path path_over(Index h) const;
  // Puts a way in the place of the path that has some side, if it parts the two sides.
  bool exchange(const Path& path, Index side);
  // Without the path of a side the rim falls into two; a way joins the one that it begins at with the one that it ends
  // at. False if these are one. `from`, `to`: the sides that begin there. The way's own will be the next two.
  bool join_rims(Index side, Index from, Index to);

  // Puts the shortest way through the cells of a path in its place, if that is shorter.
  bool straighten(Index side);
  // With the path taken out, grows the other cells through its own. Returns where the shortest way passes that parts
  // its two sides, if it is shorter than `limit`.
  Candidate search_cells(Index side, double limit);
  // Whether a vertex lies in the cells of the path that is taken out, or on it.
  bool is_free(Index v) const { return m_cell[v] == m_taken_out[0] || m_cell[v] == m_taken_out[1]; }
  // What is known of a vertex beside such cells, or in them.
  Reached reached_beside(Index h) const;
  // Whether a way that begins with a halfedge comes from between a side and its mate, along the rim.
  bool comes_from_between(Index root, Index side) const;
  Reached reached(Index v) const;
  void set(const Path& path, bool is_cut);
  Index add_side(const Path& halfedges, Index mate);
  void extend(Index side, const Path& halfedges);
  // Divides a path, or a part of the boundary, where a halfedge of the rim begins.
  void split(Index h);
  void divide(Index side, std::size_t size);
  // Makes one path of two that meet at a vertex, or takes out the one that dangles there.
  void tidy(Index v);
  void append(Index side, Index next);

  const Triangle_surface& m_surface;
  std::vector<char>& m_is_cut;
  std::vector<Index> m_degree; // of each vertex in the cut graph
  std::vector<float> m_length; // of each halfedge; in single precision: they are many, and only compared
  double m_mean_length = 0;
  std::vector<Side> m_sides;      // and some that are no more
  std::vector<Index> m_order;     // of the sides along the rim
  std::vector<Index> m_rank;      // of each side in this order,
  bool m_is_numbered = false;     // if it is
  std::vector<Index> m_side;      // of each halfedge on the rim: its side,
  std::vector<Index> m_index;     // and its place there
  std::vector<char> m_is_changed; // of each side: since the cells were grown
  Path m_exchanged;               // halfedges of paths taken out or put in since then
  double m_farthest = -1;         // how far cells grow, once they have
  std::vector<char> m_is_new;     // of each vertex: whether it was reached anew
  std::vector<Reached> m_reached;
  std::vector<Index> m_cell;                // of each vertex: the side in whose cell it lies, or -1
  std::vector<Cell> m_cells;                // of each side
  std::array<Index, 2> m_taken_out{-2, -2}; // the sides of a path that is taken out
  std::vector<Reached> m_local;             // in its cells, if
  std::vector<Index> m_search;              // the search that reached a vertex
  Index m_searches = 0;                     // is the last one
  Nearest_first<Index> m_queue;
  std::map<std::pair<Index, Index>, Candidate> m_candidates; // of two sides
};

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_CUT_INTERNAL_EDGE_EXCHANGE_H
