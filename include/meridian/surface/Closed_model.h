// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_SURFACE_CLOSED_MODEL_H
#define MERIDIAN_SURFACE_CLOSED_MODEL_H

#include <meridian/base/vectors.h>
#include <meridian/surface/Triangle_surface.h>

#include <vector>

namespace meridian {

/// \ingroup PkgMeridianOrder
/// the closed model of a surface: each interior vertex is a node, and each boundary loop is one node.
///
/// Shrinking a loop to a point is glueing a disc to it, so the theory of closed surfaces holds for the nodes
/// word for word. Interior vertices keep their order; the loops come last.
struct Closed_model
{
  Index number_of_nodes = 0;         ///< interior vertices and boundary loops
  Index first_loop_node = 0;         ///< nodes from here on are boundary loops
  std::vector<Index> node;           ///< of each vertex
  std::vector<Index> representative; ///< a vertex of each node
  std::vector<Index> begin;          ///< node `a` has the edges `begin[a]` to `begin[a+1]-1`
  std::vector<Index> halfedge;       ///< each edge as a halfedge that leaves the node
  std::vector<Index> neighbor;       ///< the node at its other end

  /// \param a a node \returns whether it is a boundary loop
  bool is_loop(Index a) const { return a >= first_loop_node; }
};

/// \ingroup PkgMeridianOrder
/// \returns the closed model of `s`
/// \param s the surface
/// \par Complexity
/// Linear.
Closed_model make_closed_model(const Triangle_surface& s);

/// \ingroup PkgMeridianOrder
/// \returns the interior edges that join a boundary loop to itself. Dividing them makes the closed model a
///          triangulated surface, in which every node has a circle for a link.
/// \param s the surface
/// \param g its closed model
std::vector<Index> chords_of_loops(const Triangle_surface& s, const Closed_model& g);

/// \ingroup PkgMeridianOrder
/// calls `f(h)` for the halfedges that leave the node of vertex `v` inside the surface, in their circular order
/// \param s the surface
/// \param v a vertex, if on the boundary any of its loop
/// \param f the function
template <class Function> void for_each_around_node(const Triangle_surface& s, Index v, Function f)
{
  if (!s.is_boundary_vertex(v))
  {
    s.for_each_outgoing(v, f);
    return;
  }
  std::vector<Index> loop;
  Index u = v;
  do {
    loop.push_back(u);
    u = s.target(s.outgoing[u]);
  } while (u != v);
  for (std::size_t i = loop.size(); i-- > 0;) // counterclockwise around the disc that closes the loop
    s.for_each_outgoing(loop[i], [&](Index h) {
      if (s.opposite[h] >= 0) { f(h); }
    });
}

} // namespace meridian

#endif // MERIDIAN_SURFACE_CLOSED_MODEL_H
