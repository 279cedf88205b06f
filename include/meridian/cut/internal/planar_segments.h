// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_INTERNAL_PLANAR_SEGMENTS_H
#define MERIDIAN_CUT_INTERNAL_PLANAR_SEGMENTS_H

#include <meridian/curves/place_crossings.h>
#include <meridian/map/embed_in_plane.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <boost/pending/disjoint_sets.hpp>

#include <map>

namespace meridian {
namespace internal {

struct Planar_segment
{
  Index from, to;
}; // vertices of the opened surface

// The minimum spanning tree of the loops among the edges of a constrained Delaunay triangulation of their vertices; a
// vertex that is a loop of its own is a point of it.
inline std::vector<Planar_segment> spanning_segments(const Triangle_surface& o, const Planar_embedding& plane,
                                                     const std::vector<std::vector<Index>>& loops,
                                                     const std::vector<Index>& loop_of, Index number_of_loops)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Vertex_base = CGAL::Triangulation_vertex_base_with_info_2<Index, Kernel>;
  using Structure =
    CGAL::Triangulation_data_structure_2<Vertex_base, CGAL::Constrained_triangulation_face_base_2<Kernel>>;
  using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::No_constraint_intersection_tag>;

  std::vector<std::pair<Planar_embedding::Point_2, Index>> points;
  for (Index v = 0; v < o.number_of_vertices(); ++v)
  {
    if (loop_of[v] >= 0) { points.emplace_back(plane.points[v], v); }
  }
  Triangulation t;
  t.insert(points.begin(), points.end());
  if (t.number_of_vertices() != points.size()) { return {}; }
  std::map<Index, typename Triangulation::Vertex_handle> handle;
  for (auto v : t.finite_vertex_handles()) { handle[v->info()] = v; }
  for (const auto& loop : loops)
    for (Index h : loop) { t.insert_constraint(handle.at(o.source(h)), handle.at(o.target(h))); }

  struct Candidate
  {
    double length;
    Index from, to;
  };
  std::vector<Candidate> candidates;
  for (const auto& edge : t.finite_edges())
  {
    const auto a = edge.first->vertex(t.cw(edge.second)), b = edge.first->vertex(t.ccw(edge.second));
    const Index v = std::min(a->info(), b->info()), w = std::max(a->info(), b->info());
    if (loop_of[v] != loop_of[w]) { candidates.push_back({CGAL::squared_distance(a->point(), b->point()), v, w}); }
  }
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    return std::tie(a.length, a.from, a.to) < std::tie(b.length, b.from, b.to);
  });
  std::vector<Index> rank(number_of_loops, 0), parent(number_of_loops);
  std::iota(parent.begin(), parent.end(), Index(0));
  boost::disjoint_sets<Index*, Index*> joined(rank.data(), parent.data());
  std::vector<Planar_segment> tree;
  for (const Candidate& c : candidates)
  {
    const Index a = joined.find_set(loop_of[c.from]), b = joined.find_set(loop_of[c.to]);
    if (a == b) { continue; }
    joined.link(a, b);
    tree.push_back({c.from, c.to});
  }
  return tree;
}

// What a segment meets on its way: vertices and halfedges of the opened surface. Empty if it leaves the domain.
struct Planar_walk
{
  std::vector<Curve_point> points;
};

inline Planar_walk walk(const Triangle_surface& o, const Planar_embedding& plane, const Planar_segment& segment)
{
  const auto side = [&](Index a, Index b, Index c) {
    return CGAL::orientation(plane.points[a], plane.points[b], plane.points[c]);
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
      if (left_of_a == CGAL::LEFT_TURN && left_of_b == CGAL::RIGHT_TURN) { h = o.next(g); }
      for (const auto& [v, turn] : {std::pair(a, left_of_a), std::pair(b, left_of_b)})
        if (turn == CGAL::COLLINEAR
            && CGAL::collinear_are_ordered_along_line(plane.points[at], plane.points[v], plane.points[segment.to]))
        {
          along = v;
        }
    });
    while (along < 0)
    {
      if (h < 0 || o.opposite[h] < 0) { return {}; }
      w.points.push_back(Curve_point::on_edge(h, 0.5));
      const Index back = o.opposite[h], c = o.apex(back);
      const auto turn = c == segment.to ? CGAL::COLLINEAR : side(at, segment.to, c);
      if (turn == CGAL::COLLINEAR) { along = c; }
      else { h = turn == CGAL::LEFT_TURN ? o.next(back) : o.prev(back); }
    }
    at = along;
    w.points.push_back(Curve_point::on_vertex(at));
  }
  return w;
}

// The walks as curves on the slit surface `s`, with fractions that keep their order on every edge.
inline std::vector<Surface_curve> place_walks(const Triangle_surface& s, const Triangle_surface& o,
                                              const Planar_embedding& plane,
                                              const std::vector<Planar_segment>& segments,
                                              const std::vector<Planar_walk>& walks, const std::vector<Index>& copy_of,
                                              const std::vector<Index>& loop_of)
{
  using Rational = CGAL::Exact_rational;
  const auto original = [&](Index v) { return v < s.number_of_vertices() ? v : copy_of[v - s.number_of_vertices()]; };
  std::vector<char> is_used(s.number_of_vertices(), 0);
  for (Index v = 0; v < o.number_of_vertices(); ++v)
  {
    if (loop_of[v] >= 0) { is_used[original(v)] = 1; }
  }

  // Stretches of crossings between vertices; one walk may have several.
  struct Stretch
  {
    std::size_t walk, first;
  };
  std::vector<std::vector<Crossing>> crossings;
  std::vector<Stretch> stretches;
  for (std::size_t i = 0; i < walks.size(); ++i)
    for (std::size_t j = 0; j < walks[i].points.size(); ++j)
    {
      const Curve_point& p = walks[i].points[j];
      if (p.is_vertex())
      {
        is_used[original(p.vertex)] = 1;
        continue;
      }
      if (walks[i].points[j - 1].is_vertex())
      {
        stretches.push_back({i, j});
        crossings.emplace_back();
      }
      const Index e = s.edge(p.halfedge);
      const auto &a = plane.points[segments[i].from], &b = plane.points[segments[i].to];
      const auto &x = plane.points[o.source(e)], &y = plane.points[o.target(e)];
      const double p_side = (b.x() - a.x()) * (x.y() - a.y()) - (b.y() - a.y()) * (x.x() - a.x());
      const double q_side = (b.x() - a.x()) * (y.y() - a.y()) - (b.y() - a.y()) * (y.x() - a.x());
      const double t = p_side / (p_side - q_side);
      crossings.back().push_back({p.halfedge, e, 0, 0, t > 0 && t < 1 ? t : 0.5, true});
    }
  // Where several walks cross an edge, their order on it in rational numbers.
  std::map<Index, std::vector<std::pair<std::size_t, std::size_t>>> on_edge;
  for (std::size_t i = 0; i < crossings.size(); ++i)
    for (std::size_t j = 0; j < crossings[i].size(); ++j) { on_edge[crossings[i][j].edge].emplace_back(i, j); }
  for (auto& [e, places] : on_edge)
  {
    if (places.size() < 2) { continue; }
    std::vector<std::pair<Rational, std::size_t>> order;
    for (std::size_t k = 0; k < places.size(); ++k)
    {
      const Planar_segment& segment = segments[stretches[places[k].first].walk];
      const auto exact = [&](Index v) {
        return std::pair(Rational(plane.points[v].x()), Rational(plane.points[v].y()));
      };
      const auto a = exact(segment.from), b = exact(segment.to), x = exact(o.source(e)), y = exact(o.target(e));
      const Rational p = (b.first - a.first) * (x.second - a.second) - (b.second - a.second) * (x.first - a.first);
      const Rational q = (b.first - a.first) * (y.second - a.second) - (b.second - a.second) * (y.first - a.first);
      order.emplace_back(Rational(p / (p - q)), k);
    }
    std::sort(order.begin(), order.end());
    for (std::size_t k = 0; k < order.size(); ++k)
    {
      const auto& [i, j] = places[order[k].second];
      crossings[i][j].place = static_cast<Index>(k);
    }
  }
  const auto placed = place_crossings(s, crossings, false, [&](Index v) { return !is_used[v]; });

  std::vector<Surface_curve> curves;
  std::size_t next = 0;
  for (std::size_t i = 0; i < walks.size(); ++i)
  {
    curves.emplace_back();
    for (std::size_t j = 0; j < walks[i].points.size(); ++j)
    {
      const Curve_point& p = walks[i].points[j];
      if (p.is_vertex()) { curves.back().points.push_back(Curve_point::on_vertex(original(p.vertex))); }
      else if (next < stretches.size() && stretches[next].walk == i && stretches[next].first == j)
      {
        const auto& points = placed[next++].points;
        curves.back().points.insert(curves.back().points.end(), points.begin(), points.end());
      }
    }
  }
  return curves;
}

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_CUT_INTERNAL_PLANAR_SEGMENTS_H
