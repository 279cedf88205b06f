// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/cut/link_on_edges.h>

#include <meridian/cut/internal/slit_surface.h>
#include <meridian/surface/Closed_model.h>
#include <meridian/surface/measures.h>
#include <meridian/surface/shortest_ways.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <vector>

namespace meridian {

namespace internal {

namespace {

// Grows a tree of links from one boundary of a slit surface (Prim 1957), along edges. One Dijkstra search serves all
// links: when a boundary is joined or a link found, its corners become further starts, and what the search knows only
// gets nearer.
class Edge_linker
{
public:
  Edge_linker(Refined_surface& s, const std::vector<Index>& points, const std::vector<char>& kept_out)
    : m_surface(s), m_slit(s, s, true, kept_out),
      m_distance(s.number_of_vertices(), std::numeric_limits<double>::infinity()), m_by(s.number_of_vertices(), -1),
      m_is_used(s.number_of_vertices(), 0)
  {
    const bool is_closed = m_slit.number_of_loops() == 0;
    for (Index v : points) { m_slit.add_point(v); }
    if (is_closed)
    {
      const auto [from, to] = find_distant_nodes(s, make_closed_model(s)); // a closed surface's nodes are its vertices
      for (Index v : {from, to})
      {
        if (m_slit.number_of_loops() < 2) { m_slit.add_point(v); }
      }
      m_forbidden = {m_slit.vertices(0).front(), m_slit.vertices(1).front()};
    }
    for (Index v = 0; v < s.number_of_vertices(); ++v) { m_is_used[v] = !m_slit.is_free(v); }
    m_is_joined.assign(m_slit.number_of_loops(), 0);
  }

  Index number_of_loops() const { return m_slit.number_of_loops(); }

  void join(Index loop)
  {
    m_is_joined[loop] = 1;
    ++m_joined;
    for (Index v : m_slit.vertices(loop))
      m_surface.for_each_outgoing(v, [&](Index h) {
        if (m_slit.loop(h) == loop) { take(0, h); }
      });
  }

  bool is_joined(Index loop) const { return m_is_joined[loop] != 0; }
  bool has_all() const { return m_joined == number_of_loops(); }

  // The next link, flagged, as vertices from the tree to the boundary that it joins; nothing if the tree reaches all of
  // its piece.
  std::vector<Index> add_link()
  {
    while (!m_queue.is_empty())
    {
      const auto [d, h] = m_queue.pop();
      const Index v = m_surface.target(h);
      if (m_surface.seam[h]) { continue; } // a link by now
      if (!m_is_used[v])
      {
        if (!(d < m_distance[v])) { continue; }
        m_distance[v] = d;
        m_by[v] = h;
        m_surface.for_each_outgoing(v, [&, at = d](Index g) { take(at, g); });
        continue;
      }
      const Index reached = m_slit.loop(m_surface.opposite[h]);
      if (reached < 0 || m_is_joined[reached]) { continue; } // the tree itself
      std::vector<Index> link{v};
      for (Index g = h;; g = m_by[m_surface.source(g)])
      {
        m_surface.seam[g] = m_surface.seam[m_surface.opposite[g]] = 1;
        link.push_back(m_surface.source(g));
        if (m_is_used[link.back()]) { break; }
      }
      std::reverse(link.begin(), link.end());
      for (std::size_t i = 1; i + 1 < link.size(); ++i)
      {
        m_is_used[link[i]] = 1;
        m_surface.for_each_outgoing(link[i], [&](Index g) { take(0, g); });
      }
      join(reached);
      return link;
    }
    return {};
  }

private:
  void take(double d, Index h)
  {
    if (!m_slit.may_cross(h)) { return; }
    const Index v = m_surface.source(h), w = m_surface.target(h);
    if (m_forbidden[0] >= 0 && std::minmax(v, w) == std::minmax(m_forbidden[0], m_forbidden[1])) { return; }
    m_queue.reach(d + m_surface.length(h) + m_slit.detour_along(h), h);
  }

  Refined_surface& m_surface;
  Slit_surface m_slit;
  std::vector<double> m_distance; // of each free vertex from the tree,
  std::vector<Index> m_by;        // and the halfedge by which it was reached
  std::vector<char> m_is_used;    // of each vertex: on a boundary, a seam or a link
  std::vector<char> m_is_joined;  // of each boundary
  Index m_joined = 0;             // how many are
  // the ends of an edge that is no link on a closed surface: cut alone, it would open nothing
  std::array<Index, 2> m_forbidden{-1, -1};
  Nearest_first<Index> m_queue; // halfedges, each with its length
};

} // namespace

} // namespace internal

std::vector<std::vector<Index>> link_boundaries_on_edges(Refined_surface& s, const std::vector<Index>& points,
                                                         const std::vector<char>& kept_out)
{
  internal::Edge_linker linker(s, points, kept_out);
  std::vector<std::vector<Index>> links;
  if (linker.number_of_loops() < 2) { return links; }           // a disc already
  for (Index loop = 0; loop < linker.number_of_loops(); ++loop) // one piece after the other
  {
    if (linker.is_joined(loop)) { continue; }
    linker.join(loop);
    while (!linker.has_all())
    {
      links.push_back(linker.add_link());
      if (links.back().empty())
      {
        links.pop_back();
        break;
      }
    }
  }
  return links;
}

} // namespace meridian
