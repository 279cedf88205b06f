// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/map/internal/disc_hierarchy.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace meridian {

namespace internal {

namespace {

// A disc of which vertices are taken out in place.
class Decimated_disc
{
public:
  explicit Decimated_disc(const Triangle_surface& disc)
    : m_disc(disc), m_is_gone(disc.number_of_faces(), 0), m_is_removed(disc.number_of_vertices(), 0),
      m_left(disc.number_of_vertices()), m_mark(disc.number_of_vertices(), 0)
  {
    for (Index h = 0; h < disc.number_of_halfedges(); ++h) { m_border += disc.opposite[h] < 0; }
  }

  Index number_of_vertices() const { return m_left; }
  bool is_removed(Index v) const { return m_is_removed[v]; }
  // Of the last vertex that `find_target()` was asked for: see `Disc_hierarchy::Removal`
  const std::vector<Index>& ring() const { return m_ring; }
  bool is_border(Index v) const { return m_disc.is_boundary_vertex(v); }

  std::vector<std::array<Index, 3>> triangles() const
  {
    std::vector<std::array<Index, 3>> result;
    for (Index f = 0; f < m_disc.number_of_faces(); ++f)
    {
      if (!m_is_gone[f]) { result.push_back(m_disc.triangles[f]); }
    }
    return result;
  }

  // The halfedge from a vertex to the neighbour that it is best moved into, or -1 if it has to stay: no edge may become
  // longer than `longest`, and faces have to keep a shape and the side that they show.
  Index find_target(Index v, double longest)
  {
    constexpr std::size_t most = 14; // neighbours
    collect_ring(v);
    const bool at_border = is_border(v);
    if (m_ring.size() > most || (at_border && (m_border <= 4 || m_ring.size() < 3))) { return -1; }
    Index best = -1;
    double best_shape = least_shape;
    const Point normal = normal_of_star(v);
    for (std::size_t i = 0; i < m_ring.size(); ++i)
    {
      if (at_border && i != 0 && i + 1 != m_ring.size()) { continue; }
      const double shape = shape_if_moved(i, at_border, longest, normal);
      if (shape > best_shape && may_join(i, at_border))
      {
        best_shape = shape;
        best = static_cast<Index>(i);
      }
    }
    return best;
  }

  // Moves a vertex into neighbour `i` of its ring.
  void collapse(Index v, Index i)
  {
    const Index into = m_ring[i];
    m_border -= is_border(v);
    std::vector<Index> halfedges;
    m_disc.for_each_outgoing(v, [&](Index h) { halfedges.push_back(h); });
    for (Index h : halfedges)
    {
      if (m_disc.target(h) == into) { remove_face(m_disc.next(h), m_disc.prev(h)); }
      else if (m_disc.apex(h) == into) { remove_face(m_disc.next(h), h); }
    }
    for (Index h : halfedges) { m_disc.triangles[m_disc.face(h)][h % 3] = into; }
    for (Index h : halfedges)
    {
      if (m_is_gone[m_disc.face(h)]) { continue; }
      for (Index g = 3 * m_disc.face(h); g < 3 * m_disc.face(h) + 3; ++g) { set_outgoing(g); }
    }
    m_is_removed[v] = 1;
    --m_left;
  }

private:
  static constexpr double least_shape = 0.02; // twice the area of a face over its longest side, squared

  void collect_ring(Index v)
  {
    m_ring.clear();
    Index last = -1;
    m_disc.for_each_outgoing(v, [&](Index h) {
      m_ring.push_back(m_disc.target(h));
      last = h;
    });
    if (m_disc.is_boundary_vertex(v)) { m_ring.push_back(m_disc.apex(last)); }
  }

  Point normal_of_star(Index v) const
  {
    Point sum{0, 0, 0};
    const auto& p = m_disc.points;
    m_disc.for_each_outgoing(v,
                             [&](Index h) { sum = sum + cross(p[m_disc.target(h)] - p[v], p[m_disc.apex(h)] - p[v]); });
    return sum;
  }

  // The worst shape of the faces that the ring is filled with, all at its vertex `i`; 0 if they may not be.
  double shape_if_moved(std::size_t i, bool at_border, double longest, const Point& normal) const
  {
    const std::size_t n = m_ring.size(), sides = at_border ? n - 1 : n;
    const Point& p = m_disc.points[m_ring[i]];
    double worst = 1;
    for (std::size_t j = 0; j < sides; ++j)
    {
      const std::size_t k = (j + 1) % n;
      if (j == i || k == i) { continue; }
      const Point a = m_disc.points[m_ring[j]] - p, b = m_disc.points[m_ring[k]] - p, c = b - a, up = cross(a, b);
      const double side = std::max({dot(a, a), dot(b, b), dot(c, c)});
      if (side > longest * longest || !(dot(up, normal) > 0.2 * norm(up) * norm(normal))) { return 0; }
      worst = std::min(worst, norm(up) / side);
    }
    return worst;
  }

  // Whether what the ring is filled with has no edge that is there already: neighbour `i` knows, of the others, only
  // those beside it.
  bool may_join(std::size_t i, bool at_border)
  {
    ++m_round;
    for (Index x : m_ring) { m_mark[x] = m_round; }
    int known = 0;
    Index last = -1;
    m_disc.for_each_outgoing(m_ring[i], [&](Index h) {
      known += m_mark[m_disc.target(h)] == m_round;
      last = h;
    });
    if (is_border(m_ring[i])) { known += m_mark[m_disc.apex(last)] == m_round; }
    return known == (at_border ? 1 : 2);
  }

  // Takes a face away: what is across from two of its halfedges is joined.
  void remove_face(Index g, Index h)
  {
    const Index x = m_disc.opposite[g], y = m_disc.opposite[h];
    if (x >= 0) { m_disc.opposite[x] = y; }
    if (y >= 0) { m_disc.opposite[y] = x; }
    m_is_gone[m_disc.face(g)] = 1;
  }

  // Lets the halfedge of a vertex, if it is gone, be one that is there: on the border, of a vertex of the border.
  void set_outgoing(Index h)
  {
    Index& outgoing = m_disc.outgoing[m_disc.source(h)];
    if (!m_is_gone[m_disc.face(outgoing)] && m_disc.source(outgoing) == m_disc.source(h)
        && m_disc.opposite[outgoing] < 0)
    {
      return;
    }
    Index g = h;
    while (m_disc.opposite[g] >= 0)
    {
      g = m_disc.turn_right(g);
      if (g == h) { break; }
    }
    outgoing = g;
  }

  Triangle_surface m_disc;
  std::vector<char> m_is_gone, m_is_removed;
  Index m_left, m_border = 0;
  std::vector<Index> m_ring;
  std::vector<Index> m_mark;
  Index m_round = 0;
};

} // namespace

Disc_hierarchy::Disc_hierarchy(const Triangle_surface& disc, Index few)
{
  Decimated_disc d(disc);
  m_levels.push_back({disc.triangles, 0});
  std::vector<double> lengths;
  for (Index h = 0; h < disc.number_of_halfedges(); ++h) { lengths.push_back(disc.length(h)); }
  const double longest_of_all = *std::max_element(lengths.begin(), lengths.end());
  std::nth_element(lengths.begin(), lengths.begin() + lengths.size() / 2, lengths.end());
  constexpr double growth = 1.25, jump = 1000; // of edges, from one sweep to the next; after many that found none
  constexpr int patience = 30;
  double longest = growth * lengths[lengths.size() / 2];
  if (!(longest > 0)) { longest = longest_of_all; } // there are no others than none
  int idle = 0;
  Index wanted = disc.number_of_vertices() / 4; // on the next level
  const auto is_done = [&] { return 4 * wanted <= few; };
  for (bool is_stuck = false; !is_stuck && !is_done(); longest *= idle > patience ? jump : growth)
  {
    const std::size_t before = m_removals.size();
    for (Index v = 0; v < disc.number_of_vertices() && !is_done(); ++v)
    {
      const Index i = d.is_removed(v) ? -1 : d.find_target(v, longest);
      if (i < 0) { continue; }
      const auto& ring = d.ring();
      m_removals.push_back({v, ring[i], d.is_border(v), m_ring.size(), m_ring.size() + ring.size()});
      m_ring.insert(m_ring.end(), ring.begin(), ring.end());
      d.collapse(v, i);
      if (d.number_of_vertices() > wanted) { continue; }
      m_levels.push_back({d.triangles(), m_removals.size()});
      wanted /= 4;
    }
    idle = m_removals.size() == before ? idle + 1 : 0;
    is_stuck = idle > 0 && longest >= 100 * longest_of_all;
  }
  if (m_removals.size() > m_levels.back().removals) { m_levels.push_back({d.triangles(), m_removals.size()}); }
}

} // namespace internal

} // namespace meridian
