// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/curves/snap_to_edges.h>

#include <meridian/base/exceptions.h>
#include <meridian/base/list_elements.h>
#include <meridian/base/vectors.h>

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace meridian {

namespace {

// Moves the crossings of disjoint closed curves to the ends of their edges, one curve after the other.
//
// Each point of a curve has places: a vertex has itself, a crossing the two ends of its edge, and where it is. A curve
// takes one place for each of its points; points next to each other in the same vertex become one visit of it. From one
// place to the next it goes through the face that both points are on, whose vertices are all joined by edges. Why this
// keeps curves simple, disjoint and homotopic:
//
// - Homotopic: unroll the cyclic strip of faces of a curve to an annulus. The new curve goes round that once, as the
// old one does, and the annulus maps to the surface.
// - In vertices: no vertex is visited twice, by one curve or two. That is checked, as one strip may meet a vertex
// several times. Curves of edges alone are simple and disjoint by that.
// - Through faces: a crossing goes to an end of its edge only if none, of any curve, lies between on that edge. Chords
// of a face that do not cross have ends that do not alternate along its rim; moving an end along the rim, past no other
// end, does not change that. Ends that meet in a vertex belong to one visit. So no edge that a curve comes to follow is
// crossed: such a crossing would have a chord in the face, with an end between a moved crossing and where it went, or
// alternating with the old chord.
//
// Crossings of curves moved before need no look at where they are now: one that lay between could only go to the end in
// question, which is then taken, or stay.
class Edge_snapper
{
public:
  // `keeps`: whether crossings may stay inside their edges.
  Edge_snapper(const Triangle_surface& s, const std::vector<Surface_curve>& curves, bool keeps)
    : m_surface(s), m_curves(curves), m_keeps(keeps), m_owner(s.number_of_vertices(), -1), m_is_last(curves.size())
  {
    std::vector<Point_on_edge> crossings;
    for (std::size_t c = 0; c < curves.size(); ++c)
    {
      m_is_last[c].resize(curves[c].points.size(), {0, 0});
      for (std::size_t i = 0; i < curves[c].points.size(); ++i)
      {
        const Curve_point& p = curves[c].points[i];
        if (p.is_vertex()) { own(p.vertex, c); }
        else { crossings.push_back({{s.edge(p.halfedge), turn_fraction(s, p.halfedge, p.t)}, c, i}); }
      }
    }
    mark_last(std::move(crossings));
  }

  // Moves one curve. Returns false if that cannot be, with the edges where it is stuck.
  bool snap(std::size_t c, Surface_curve& snapped, std::vector<std::pair<Index, Index>>& stuck)
  {
    m_tries = m_keeps ? -1 : most_tries; // where crossings may stay, the first way down succeeds
    const auto& points = m_curves[c].points;
    Allowed allowed(points.size(), {0, 0});
    for (std::size_t i = 0; i < points.size(); ++i)
      for (int end = 0; end < 2 && !points[i].is_vertex(); ++end)
      {
        const Index v = end_of(points[i], end);
        allowed[i][end] = m_is_last[c][i][end] && !m_surface.is_boundary_vertex(v)
                          && (m_owner[v] < 0 || m_owner[v] == static_cast<Index>(c));
      }
    if (!search(c, allowed, snapped, stuck)) { return false; }
    for (const Curve_point& p : snapped.points)
    {
      if (p.is_vertex()) { m_owner[p.vertex] = static_cast<Index>(c); }
    }
    return true;
  }

private:
  using Allowed = std::vector<std::array<char, 2>>; // of each point: which ends of its edge it may go to
  // A point of a curve; `halfedge` is its edge.
  struct Point_on_edge : Edge_place
  {
    std::size_t curve, point;
  };

  // A vertex that a curve goes through from the start.
  void own(Index v, std::size_t c)
  {
    if (m_owner[v] >= 0)
    {
      throw Invalid_input_error("snap_to_edges: curves pass twice through vertex " + std::to_string(v));
    }
    m_owner[v] = static_cast<Index>(c);
  }

  // Finds the crossings that come first and last on their edges.
  void mark_last(std::vector<Point_on_edge> crossings)
  {
    std::sort(crossings.begin(), crossings.end(), [](const Point_on_edge& a, const Point_on_edge& b) {
      return std::tie(a.halfedge, a.t, a.curve, a.point) < std::tie(b.halfedge, b.t, b.curve, b.point);
    });
    const auto mark = [&](const Point_on_edge& x, bool toward_source) {
      const bool along = m_curves[x.curve].points[x.point].halfedge == x.halfedge;
      m_is_last[x.curve][x.point][toward_source == along ? 0 : 1] = 1;
    };
    for (std::size_t i = 0; i < crossings.size(); ++i)
    {
      if (i == 0 || crossings[i - 1].halfedge != crossings[i].halfedge) { mark(crossings[i], true); }
      if (i + 1 == crossings.size() || crossings[i + 1].halfedge != crossings[i].halfedge)
      {
        mark(crossings[i], false);
      }
    }
  }

  static constexpr int most_tries = 500;
  enum : int
  {
    STAY = 2
  }; // the places of a crossing: 0 and 1 for the source and target of its halfedge

  Index end_of(const Curve_point& p, int end) const
  {
    return end == 0 ? m_surface.source(p.halfedge) : m_surface.target(p.halfedge);
  }
  std::pair<Index, Index> edge_of(const Curve_point& p) const { return std::minmax({end_of(p, 0), end_of(p, 1)}); }
  Index vertex_at(const Curve_point& p, int place) const
  {
    return p.is_vertex() ? p.vertex : place == STAY ? -1 : end_of(p, place);
  }

  struct Cost
  {
    Index kept = 0; // crossings that stay, first of all
    double length = 0;
    bool operator<(const Cost& o) const { return std::tie(kept, length) < std::tie(o.kept, o.length); }
  };

  // The shortest choice of a place for each point; empty if a point has none. Every vertex is joined to every other by
  // edges of the face between, so a choice exists if each point has a vertex; and staying is always possible, with all
  // neighbours that do.
  std::vector<int> choose(std::size_t c, const Allowed& allowed) const
  {
    const auto& points = m_curves[c].points;
    const std::size_t n = points.size();
    const auto has = [&](std::size_t i, int place) {
      if (points[i].is_vertex()) { return place == STAY; }
      return place == STAY ? m_keeps : allowed[i][place] != 0;
    };
    const auto at = [&](std::size_t i, int place) {
      const Index v = vertex_at(points[i], place);
      return v >= 0 ? m_surface.points[v] : position(m_surface, points[i]);
    };
    // no moved crossing goes on along the edge of one that stays
    const auto joined = [&](std::size_t i, int p, std::size_t j, int q) {
      const Index v = vertex_at(points[i], p), w = vertex_at(points[j], q);
      if ((v < 0) == (w < 0)) { return true; }
      const Curve_point &moved = v < 0 ? points[j] : points[i], &stays = v < 0 ? points[i] : points[j];
      // one of the two is -1
      return moved.is_vertex() || (end_of(stays, 0) != v + w + 1 && end_of(stays, 1) != v + w + 1);
    };
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Cost least{0, infinity};
    std::vector<int> best;
    std::vector<std::array<int, 3>> before(n + 1);
    for (int first = 0; first < 3; ++first)
    {
      if (!has(0, first)) { continue; }
      std::array<Cost, 3> cost;
      for (int p = 0; p < 3; ++p) { cost[p] = {0, p == first ? 0 : infinity}; }
      for (std::size_t i = 1; i <= n; ++i)
      {
        std::array<Cost, 3> next;
        for (int q = 0; q < 3; ++q)
        {
          next[q] = {0, infinity};
          before[i][q] = -1;
          if (!has(i % n, q) || (i == n && q != first)) { continue; }
          for (int p = 0; p < 3; ++p)
          {
            if (cost[p].length == infinity || !joined(i - 1, p, i % n, q)) { continue; }
            const bool stays = q == STAY && !points[i % n].is_vertex();
            const Cost reached{cost[p].kept + stays, cost[p].length + distance(at(i - 1, p), at(i % n, q))};
            if (before[i][q] >= 0 && !(reached < next[q])) { continue; }
            next[q] = reached;
            before[i][q] = p;
          }
        }
        cost = next;
      }
      if (cost[first].length == infinity || (!best.empty() && !(cost[first] < least))) { continue; }
      least = cost[first];
      best.assign(n, first);
      for (std::size_t i = n; i-- > 1;) { best[i] = before[i + 1][i + 1 == n ? first : best[i + 1]]; }
    }
    return best;
  }

  // A longest stretch of points that went to one vertex, or one that stayed.
  struct Visit
  {
    Index vertex;
    std::size_t begin, length;
  };

  std::vector<Visit> visits_of(std::size_t c, const std::vector<int>& places) const
  {
    const auto& points = m_curves[c].points;
    const std::size_t n = points.size();
    const auto vertex = [&](std::size_t i) { return vertex_at(points[i % n], places[i % n]); };
    std::size_t first = 0;
    while (first < n && vertex(first) >= 0 && vertex(first) == vertex(first + n - 1)) { ++first; }
    std::vector<Visit> visits;
    for (std::size_t i = first; i < first + n; ++i)
    {
      if (!visits.empty() && vertex(i) >= 0 && visits.back().vertex == vertex(i)) { ++visits.back().length; }
      else { visits.push_back({vertex(i), i % n, 1}); }
    }
    return visits;
  }

  // Two visits of one vertex, or all of a curve that has too few: one of them must go. Empty if the visits are a curve.
  static std::vector<Visit> rivals_among(const std::vector<Visit>& visits)
  {
    std::vector<std::pair<Index, std::size_t>> sorted;
    for (std::size_t i = 0; i < visits.size(); ++i)
    {
      if (visits[i].vertex >= 0) { sorted.emplace_back(visits[i].vertex, i); }
    }
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t i = 1; i < sorted.size(); ++i)
      if (sorted[i].first == sorted[i - 1].first) { return {visits[sorted[i].second], visits[sorted[i - 1].second]}; }
    std::vector<Visit> rivals;
    for (const Visit& visit : visits)
    {
      if (visits.size() < 3 && visit.vertex >= 0) { rivals.push_back(visit); }
    }
    return rivals;
  }

  // Forbids a visit to the points that make it. Returns false if that cannot be: the curve goes through the vertex as
  // it is.
  bool forbid(const Visit& visit, std::size_t c, Allowed& allowed) const
  {
    const auto& points = m_curves[c].points;
    bool is_fixed = false;
    for (std::size_t k = 0; k < visit.length; ++k)
    {
      const std::size_t i = (visit.begin + k) % points.size();
      is_fixed = is_fixed || points[i].is_vertex();
      for (int end = 0; end < 2 && !points[i].is_vertex(); ++end)
      {
        if (end_of(points[i], end) == visit.vertex) { allowed[i][end] = 0; }
      }
    }
    return !is_fixed || visit.length > 1;
  }

  // Names the crossings that may go to no end of their edges, unless some were named before.
  void name_stuck(std::size_t c, const Allowed& allowed, std::vector<std::pair<Index, Index>>& stuck) const
  {
    if (!stuck.empty()) { return; }
    const auto& points = m_curves[c].points;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      if (!points[i].is_vertex() && !allowed[i][0] && !allowed[i][1]) { stuck.push_back(edge_of(points[i])); }
    }
  }

  // Chooses places, and forbids one visit after the other until they make a curve.
  bool search(std::size_t c, const Allowed& allowed, Surface_curve& snapped,
              std::vector<std::pair<Index, Index>>& stuck)
  {
    const auto& points = m_curves[c].points;
    if (m_tries-- == 0) { return false; }
    const std::vector<int> places = choose(c, allowed);
    if (places.empty())
    {
      name_stuck(c, allowed, stuck);
      return false;
    }
    const std::vector<Visit> visits = visits_of(c, places);
    const std::vector<Visit> rivals = rivals_among(visits);
    if (rivals.empty())
    {
      snapped = Surface_curve{{}, true};
      for (const Visit& visit : visits)
      {
        snapped.points.push_back(visit.vertex >= 0 ? Curve_point::on_vertex(visit.vertex) : points[visit.begin]);
      }
      return true;
    }
    for (const Visit& rival : rivals)
    {
      Allowed without = allowed;
      if (forbid(rival, c, without) && search(c, without, snapped, stuck)) { return true; }
    }
    if (stuck.empty()) // every way on was tried, or given up
      for (const Visit& rival : rivals)
      {
        if (!points[rival.begin].is_vertex()) { stuck.push_back(edge_of(points[rival.begin])); }
      }
    return false;
  }

  const Triangle_surface& m_surface;
  const std::vector<Surface_curve>& m_curves;
  bool m_keeps;
  int m_tries = 0;
  std::vector<Index> m_owner; // of each vertex, the curve that has it
  // of each crossing, whether none lies between it and the source, the target, of its halfedge
  std::vector<Allowed> m_is_last;
};

} // namespace

std::vector<Surface_curve> snap_to_edges(const Triangle_surface& root, const std::vector<Surface_curve>& curves,
                                         bool refine_where_needed)
{
  for (std::size_t c = 0; c < curves.size(); ++c)
    if (!curves[c].closed || curves[c].points.empty())
    {
      throw Invalid_input_error("snap_to_edges: curve " + std::to_string(c) + " is not closed");
    }

  std::vector<std::size_t> order(curves.size());
  for (std::size_t c = 0; c < order.size(); ++c) { order[c] = c; }
  std::vector<Surface_curve> snapped(curves.size());
  std::vector<std::pair<Index, Index>> stuck, first_stuck;
  std::size_t first_failed = curves.size();
  for (std::size_t tries = 0; tries <= curves.size(); ++tries)
  {
    Edge_snapper snapper(root, curves, false);
    std::size_t done = 0;
    stuck.clear();
    while (done < order.size() && snapper.snap(order[done], snapped[order[done]], stuck)) { ++done; }
    if (done == order.size()) { return snapped; }
    if (tries == 0)
    {
      first_failed = order[done];
      first_stuck = stuck;
    }
    if (done == 0) { break; } // stuck by itself, or by vertices that others have from the start
    std::rotate(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(done),
                order.begin() + static_cast<std::ptrdiff_t>(done) + 1);
  }
  if (!refine_where_needed)
    throw Invalid_input_error(
      "curve " + std::to_string(first_failed) + " cannot be moved onto edges of the mesh: it is stuck at "
      + internal::list_elements("edges, by their vertices, at whose ends other curves or the boundary are in the way",
                                first_stuck)
      + ". The mesh is too coarse there for disjoint loops of edges; refining it there helps (option "
        "--refine-where-needed)");
  Edge_snapper snapper(root, curves, true);
  for (std::size_t c = 0; c < curves.size(); ++c)
    if (!snapper.snap(c, snapped[c], stuck))
    {
      throw Internal_error("snap_to_edges: curve " + std::to_string(c) + " cannot even stay where it is");
    }
  return snapped;
}

} // namespace meridian
