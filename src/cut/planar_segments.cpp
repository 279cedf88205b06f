// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/cut/internal/planar_segments.h>

#include <meridian/curves/place_crossings.h>
#include <meridian/cut/internal/minimum_spanning_tree.h>
#include <meridian/map/constrained_triangulation.h>
#include <meridian/map/planar_map.h>

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace meridian {

namespace internal {

namespace {

// Whether `q` is not outside of the segment from `p` to `r`, for points on one line.
bool lies_between(const Plane_point& p, const Plane_point& q, const Plane_point& r)
{
  for (int k = 0; k < 2; ++k)
  {
    if (p[k] < q[k]) { return !(r[k] < q[k]); }
    if (q[k] < p[k]) { return !(q[k] < r[k]); }
  }
  return true;
}

} // namespace

std::vector<Planar_segment> spanning_segments(const Triangle_surface& o, const Planar_embedding& plane,
                                              const std::vector<std::vector<Index>>& loops,
                                              const std::vector<Index>& loop_of, Index number_of_loops)
{
  std::vector<Index> vertices; // of the loops, and the source
  for (Index v = 0; v < o.number_of_vertices(); ++v)
  {
    if (loop_of[v] >= 0) { vertices.push_back(v); }
  }
  std::vector<std::vector<Index>> polygons;
  for (const auto& loop : loops)
  {
    polygons.emplace_back();
    for (Index h : loop) { polygons.back().push_back(o.source(h)); }
  }
  struct Candidate
  {
    double length;
    Index from, to;
  };
  std::vector<Candidate> candidates;
  for (const auto& [a, b] : constrained_delaunay_edges(vertices, polygons, plane.points))
  {
    if (loop_of[a] == loop_of[b]) { continue; }
    const Plane_point d = plane.points[b] - plane.points[a];
    candidates.push_back({dot(d, d), std::min(a, b), std::max(a, b)});
  }
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    return std::tie(a.length, a.from, a.to) < std::tie(b.length, b.from, b.to);
  });
  // The weight of a candidate is its place in that order, so that ties are broken by vertices.
  std::vector<Spanning_edge> edges;
  for (const Candidate& c : candidates)
  {
    edges.push_back({loop_of[c.from], loop_of[c.to], static_cast<double>(edges.size())});
  }
  std::vector<Planar_segment> tree;
  for (std::size_t i : minimum_spanning_tree(number_of_loops, edges))
  {
    tree.push_back({candidates[i].from, candidates[i].to});
  }
  return tree;
}

Planar_walk walk(const Triangle_surface& o, const Planar_embedding& plane, const Planar_segment& segment)
{
  const auto side = [&](Index a, Index b, Index c) {
    return orientation_of(plane.points[a], plane.points[b], plane.points[c]);
  };
  Planar_walk w;
  Index at = segment.from;
  w.points.push_back(Curve_point::on_vertex(at));
  while (at != segment.to)
  {
    // The face, or the edge, at `at` towards the end.
    Index h = -1, along = -1;
    o.for_each_outgoing(at, [&](Index g) {
      const Index a = o.target(g), b = o.apex(g);
      if (a == segment.to || b == segment.to) { along = segment.to; }
      const auto left_of_a = side(at, a, segment.to), left_of_b = side(at, b, segment.to);
      if (left_of_a > 0 && left_of_b < 0) { h = o.next(g); }
      for (const auto& [v, turn] : {std::pair(a, left_of_a), std::pair(b, left_of_b)})
        if (turn == 0 && lies_between(plane.points[at], plane.points[v], plane.points[segment.to])) { along = v; }
    });
    while (along < 0)
    {
      if (h < 0 || o.opposite[h] < 0) { return {}; }
      w.points.push_back(Curve_point::on_edge(h, 0.5));
      const Index back = o.opposite[h], c = o.apex(back);
      const auto turn = c == segment.to ? 0 : side(at, segment.to, c);
      if (turn == 0) { along = c; }
      else { h = turn > 0 ? o.next(back) : o.prev(back); }
    }
    at = along;
    w.points.push_back(Curve_point::on_vertex(at));
  }
  return w;
}

namespace {

// Puts walks over an opened surface back on the surface itself.
class Walk_placer
{
public:
  Walk_placer(const Triangle_surface& s, const Triangle_surface& o, const Planar_embedding& plane,
              const std::vector<Planar_segment>& segments, const std::vector<Planar_walk>& walks,
              const std::vector<Index>& copy_of)
    : m_surface(s), m_opened(o), m_plane(plane), m_segments(segments), m_walks(walks), m_copy_of(copy_of),
      m_is_used(s.number_of_vertices(), 0)
  {}

  std::vector<Surface_curve> place(const std::vector<Index>& loop_of)
  {
    for (Index v = 0; v < m_opened.number_of_vertices(); ++v)
    {
      if (loop_of[v] >= 0) { m_is_used[original(v)] = 1; }
    }
    collect_crossings();
    order_crossings();
    return join_stretches(place_crossings(m_surface, m_crossings, false, [&](Index v) { return !m_is_used[v]; }));
  }

private:
  // Crossings between vertices; one walk may have several stretches.
  struct Stretch
  {
    std::size_t walk, first;
  };

  Index original(Index v) const
  {
    return v < m_surface.number_of_vertices() ? v : m_copy_of[v - m_surface.number_of_vertices()];
  }

  // Takes all walks apart into vertices, which become used, and stretches.
  void collect_crossings()
  {
    for (std::size_t i = 0; i < m_walks.size(); ++i)
      for (std::size_t j = 0; j < m_walks[i].points.size(); ++j)
      {
        const Curve_point& p = m_walks[i].points[j];
        if (p.is_vertex())
        {
          m_is_used[original(p.vertex)] = 1;
          continue;
        }
        if (m_walks[i].points[j - 1].is_vertex())
        {
          m_stretches.push_back({i, j});
          m_crossings.emplace_back();
        }
        const Index e = m_surface.edge(p.halfedge);
        const double t = fraction(m_segments[i], e);
        m_crossings.back().push_back({{p.halfedge, 0, t > 0 && t < 1 ? t : 0.5}, e});
      }
  }

  // Where a segment crosses an edge, rounded.
  double fraction(const Planar_segment& segment, Index e) const
  {
    const auto &a = m_plane.points[segment.from], &b = m_plane.points[segment.to];
    const auto &x = m_plane.points[m_opened.source(e)], &y = m_plane.points[m_opened.target(e)];
    const double p_side = (b[0] - a[0]) * (x[1] - a[1]) - (b[1] - a[1]) * (x[0] - a[0]);
    const double q_side = (b[0] - a[0]) * (y[1] - a[1]) - (b[1] - a[1]) * (y[0] - a[0]);
    return p_side / (p_side - q_side);
  }

  // The same exactly.
  CGAL::Exact_rational exact_fraction(const Planar_segment& segment, Index e) const
  {
    using Rational = CGAL::Exact_rational;
    const auto exact = [&](Index v) {
      return std::pair(Rational(m_plane.points[v][0]), Rational(m_plane.points[v][1]));
    };
    const auto a = exact(segment.from), b = exact(segment.to), x = exact(m_opened.source(e)),
               y = exact(m_opened.target(e));
    const Rational p = (b.first - a.first) * (x.second - a.second) - (b.second - a.second) * (x.first - a.first);
    const Rational q = (b.first - a.first) * (y.second - a.second) - (b.second - a.second) * (y.first - a.first);
    return Rational(p / (p - q));
  }

  // Where several walks cross an edge, finds their order on it.
  void order_crossings()
  {
    std::map<Index, std::vector<std::pair<std::size_t, std::size_t>>> on_edge;
    for (std::size_t i = 0; i < m_crossings.size(); ++i)
      for (std::size_t j = 0; j < m_crossings[i].size(); ++j) { on_edge[m_crossings[i][j].edge].emplace_back(i, j); }
    for (auto& [e, places] : on_edge)
    {
      if (places.size() < 2) { continue; }
      std::vector<std::pair<CGAL::Exact_rational, std::size_t>> order;
      for (std::size_t k = 0; k < places.size(); ++k)
      {
        order.emplace_back(exact_fraction(m_segments[m_stretches[places[k].first].walk], e), k);
      }
      std::sort(order.begin(), order.end());
      for (std::size_t k = 0; k < order.size(); ++k)
      {
        const auto& [i, j] = places[order[k].second];
        m_crossings[i][j].place = static_cast<Index>(k);
      }
    }
  }

  // Puts each walk together again from its vertices and its stretches.
  std::vector<Surface_curve> join_stretches(const std::vector<Surface_curve>& placed) const
  {
    std::vector<Surface_curve> curves;
    std::size_t next = 0;
    for (std::size_t i = 0; i < m_walks.size(); ++i)
    {
      curves.emplace_back();
      for (std::size_t j = 0; j < m_walks[i].points.size(); ++j)
      {
        const Curve_point& p = m_walks[i].points[j];
        if (p.is_vertex()) { curves.back().points.push_back(Curve_point::on_vertex(original(p.vertex))); }
        else if (next < m_stretches.size() && m_stretches[next].walk == i && m_stretches[next].first == j)
        {
          const auto& points = placed[next++].points;
          curves.back().points.insert(curves.back().points.end(), points.begin(), points.end());
        }
      }
    }
    return curves;
  }

  const Triangle_surface &m_surface, &m_opened;
  const Planar_embedding& m_plane;
  const std::vector<Planar_segment>& m_segments;
  const std::vector<Planar_walk>& m_walks;
  const std::vector<Index>& m_copy_of;
  std::vector<char> m_is_used; // of each vertex: no walk may be moved to it
  std::vector<Stretch> m_stretches;
  std::vector<std::vector<Piece_crossing>> m_crossings; // of each stretch
};

} // namespace

std::vector<Surface_curve> place_walks(const Triangle_surface& s, const Triangle_surface& o,
                                       const Planar_embedding& plane, const std::vector<Planar_segment>& segments,
                                       const std::vector<Planar_walk>& walks, const std::vector<Index>& copy_of,
                                       const std::vector<Index>& loop_of)
{
  return Walk_placer(s, o, plane, segments, walks, copy_of).place(loop_of);
}

} // namespace internal

} // namespace meridian
