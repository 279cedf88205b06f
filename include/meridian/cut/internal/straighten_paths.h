// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_INTERNAL_STRAIGHTEN_PATHS_H
#define MERIDIAN_CUT_INTERNAL_STRAIGHTEN_PATHS_H

#include <meridian/base/vectors.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/shortest_ways.h>

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

namespace meridian {
namespace internal {

// Makes the paths of a cut graph of edges shorter, one after the other.
//
// The nodes of a cut graph are its vertices of another degree than 2 and those on the boundary; its paths run between
// them. Without one path the rest slits the surface to an annulus: a disc with two stretches of its rim glued, neither
// next to the other. So the path runs from one boundary of the annulus to the other; and cutting an annulus along any
// simple path that does so, and else touches neither, leaves a disc. One vertex may lie on the boundaries several
// times: each of its sectors between seams is a place of its own, so both ends of a path are told by corners, not by
// vertices.
class Path_straightener
{
public:
  // `is_cut`: for each halfedge, equal on twins. `slide`: whether a path may end elsewhere on its boundary than at its
  // node. `is_open(v)` tells whether a path may go through a vertex.
  Path_straightener(const Triangle_surface& s, std::vector<char>& is_cut, bool slide,
                    std::function<bool(Index)> is_open)
    : m_surface(s), m_is_cut(is_cut), m_slide(slide), m_is_open(std::move(is_open)),
      m_degree(s.number_of_vertices(), 0), m_mark(s.number_of_halfedges(), 0), m_reached(s.number_of_vertices(), 0),
      m_distance(s.number_of_vertices(), 0), m_by(s.number_of_vertices(), -1)
  {
    for (Index h = 0; h < s.number_of_halfedges(); ++h) { m_degree[s.source(h)] += is_cut[h]; }
  }

  // Tries every path once. Returns whether one got shorter.
  bool straighten_all();

private:
  using Path = std::vector<Index>; // of halfedges

  bool is_wall(Index h) const { return m_surface.opposite[h] < 0 || m_is_cut[h]; }
  bool is_used(Index v) const { return m_degree[v] > 0 || m_surface.is_boundary_vertex(v); }
  bool is_near(Index corner) const { return m_mark[corner] == m_near; }

  // The next halfedge of a path, or -1 at a node.
  Index continued(Index h) const;

  Path path_through(Index h) const;

  void set(const Path& path, bool is_cut);

  // A walk round one boundary of the slit surface.
  struct Walk
  {
    // the halfedge that the walk began with, what its corners are marked with, the halfedge it is at
    Index first, mark, at = -1;
    std::vector<Index> inwards{}; // halfedges from the boundary into the surface
    bool is_closed() const { return at == first; }
  };

  // Begins at the corner that the source of `h` has beside `h`.
  Walk begin_walk(Index h);

  void step(Walk& walk);

  // Marks the corners of the boundary at the source of `h`, or of that at the source of `g`, whichever is shorter.
  // Returns the halfedges that leave it into the surface.
  std::vector<Index> mark_boundary(Index h, Index g);

  // The shortest path that begins with one of some halfedges, goes through free vertices and ends with a halfedge into
  // a used vertex that `is_end` accepts, if it is shorter than `limit`.
  template <class Is_end> Path search(const std::vector<Index>& starts, double limit, const Is_end& is_end)
  {
    Nearest_first<Index> queue; // of the halfedges that are taken last
    ++m_search;
    const auto take = [&](double d, Index h) {
      const Index v = m_surface.target(h);
      const double reached = d + m_surface.length(h);
      if (!(reached < limit)) { return; }
      if (is_used(v))
      {
        if (!is_end(h)) { return; }
      }
      else
      {
        if (m_reached[v] == m_search && !(reached < m_distance[v])) { return; }
        m_reached[v] = m_search;
        m_distance[v] = reached;
        m_by[v] = h;
      }
      queue.reach(reached, h);
    };
    for (Index h : starts) { take(0, h); }
    Path path;
    queue.search([&](double at, Index h) {
      const Index v = m_surface.target(h);
      if (is_used(v))
      {
        path.push_back(h);
        for (Index u = m_surface.source(h); !is_used(u); u = m_surface.source(m_by[u])) { path.push_back(m_by[u]); }
        std::reverse(path.begin(), path.end());
        return true;
      }
      if (m_by[v] == h && m_is_open(v))
      {
        m_surface.for_each_outgoing(v, [&](Index g) { take(at, g); });
      }
      return false;
    });
    return path;
  }

  double length(const Path& path) const;

  bool straighten(const Path& path);

  const Triangle_surface& m_surface;
  std::vector<char>& m_is_cut;
  bool m_slide;
  std::function<bool(Index)> m_is_open;
  std::vector<Index> m_degree;    // of each vertex in the cut graph
  std::vector<Index> m_mark;      // of each corner, the last walk that came by
  Index m_marks = 0, m_near = 0;  // the number of walks, and the one round the boundary in question
  Index m_search = 0;             // the number of searches
  std::vector<Index> m_reached;   // of each vertex, the last search that came there,
  std::vector<double> m_distance; // its distance then,
  std::vector<Index> m_by;        // and the halfedge by which it was reached
};

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_CUT_INTERNAL_STRAIGHTEN_PATHS_H
