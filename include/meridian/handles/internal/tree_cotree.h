// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_HANDLES_INTERNAL_TREE_COTREE_H
#define MERIDIAN_HANDLES_INTERNAL_TREE_COTREE_H

#include <meridian/base/Euler_tour.h>
#include <meridian/base/vectors.h>
#include <meridian/surface/Triangle_surface.h>

#include <utility>
#include <vector>

namespace meridian {

namespace internal {

// A spanning tree of the vertices of a connected surface, and one of its faces that crosses no edge of the first
// (Eppstein 2003). On a surface with boundary, all its boundary loops together are one face more. Each edge in neither
// has a loop through faces that crosses it; how often a closed walk crosses these loops is its class in first homology.
class Tree_cotree
{
public:
  explicit Tree_cotree(const Triangle_surface& s);

  // The edges in neither tree: twice the genus, and one less than the boundary loops if there are any.
  const std::vector<Index>& edges() const { return m_edges; }
  // For each of `edges()`, the sum of a flow over its loop through faces, which crosses the edge from the face of its
  // halfedge to the other and returns through the tree. `flow`: halfedges `surface.edge(h)`, each with
  // what crossing it from its own face counts; what is said of one several times adds up.
  std::vector<int> integrate(const std::vector<std::pair<Index, int>>& flow) const;

private:
  // When the tour comes to the face on one side of an edge.
  struct Visit
  {
    Index time, edge; // by its place among `edges()`
    int sign;
  };

  const Triangle_surface& m_surface;
  Index m_outside; // the face beyond all boundary loops
  std::vector<Index> m_edges;
  std::vector<Visit> m_visits; // in order of time
  Euler_tour m_tour;           // of the faces' tree; its steps are the halfedges by which a face is entered
};

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_HANDLES_INTERNAL_TREE_COTREE_H
