// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CURVES_SLEEVE_H
#define MERIDIAN_CURVES_SLEEVE_H

#include <meridian/curves/place_crossings.h>
#include <meridian/surface/measures.h>

#include <set>

namespace meridian {
namespace internal {

// A strip of different faces from one vertex to another: the halfedges by which a path leaves each face. The first one
// lies across from `start`, the opposite of the last one across from `end`; with none, an edge joins the two.
struct Sleeve
{
  Index start = -1, end = -1;
  std::vector<Index> halfedges;
};

inline bool touches(const Triangle_surface& s, Index h, Index v) { return s.source(h) == v || s.target(h) == v; }

// Drops faces at both ends that only lead round the end vertices.
inline void trim(const Triangle_surface& s, Sleeve& sleeve)
{
  auto& h = sleeve.halfedges;
  std::size_t first = 0, last = h.size();
  while (first < last && touches(s, h[first], sleeve.start)) { ++first; }
  while (first < last && touches(s, h[last - 1], sleeve.end)) { --last; }
  h = {h.begin() + first, h.begin() + last};
}

using Point_2 = std::array<double, 2>;
inline double turn(const Point_2& a, const Point_2& b, const Point_2& c)
{
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

// The shortest path inside a sleeve, laid out in the plane.
struct Pulled_path
{
  // `first`: the portal from which on it is an end
  struct Corner
  {
    Index vertex;
    bool is_left;
    std::size_t portal, first;
    Point_2 at;
  };
  std::vector<Corner> corners;      // start, the vertices where the path bends, end
  std::vector<Point_2> left, right; // the ends of each portal: target and source of its halfedge
  std::vector<double> fraction;     // where the path crosses each halfedge
};

// Unfolds the sleeve and pulls the path tight with a funnel (Lee, Preparata 1984).
inline Pulled_path pull(const Triangle_surface& s, const Sleeve& sleeve)
{
  Pulled_path path;
  const std::size_t n = sleeve.halfedges.size();
  // The third corner of a triangle whose side runs from a to b (both known), to the left or to the right of it.
  const auto third = [&](Index va, Index vb, Index vc, const Point_2& a, const Point_2& b, double side) -> Point_2 {
    const Point ab = s.points[vb] - s.points[va], ac = s.points[vc] - s.points[va];
    const double l = norm(ab);
    if (!(l > 0)) { return {a[0], a[1] + side * norm(ac)}; }
    const double x = dot(ab, ac) / l, y = side * norm(cross(ab, ac)) / l;
    const Point_2 u{(b[0] - a[0]) / l, (b[1] - a[1]) / l};
    return {a[0] + x * u[0] - y * u[1], a[1] + x * u[1] + y * u[0]};
  };
  const Index h0 = sleeve.halfedges.front();
  // a closed sleeve comes to a vertex again; that is another end
  std::vector<std::size_t> first_left{0}, first_right{0};
  path.right.push_back({0, 0});
  path.left.push_back({s.length(h0), 0});
  const Point_2 start = third(s.source(h0), s.target(h0), sleeve.start, path.right[0], path.left[0], 1);
  Point_2 end{0, 0};
  for (std::size_t i = 0; i < n; ++i)
  {
    const Index h = sleeve.halfedges[i], o = s.opposite[h];
    const Point_2 c = third(s.source(h), s.target(h), s.apex(o), path.right[i], path.left[i], -1);
    if (i + 1 == n)
    {
      end = c;
      break;
    }
    const bool moves_left = sleeve.halfedges[i + 1] == s.next(o); // the new portal keeps the right end
    path.right.push_back(moves_left ? path.right[i] : c);
    path.left.push_back(moves_left ? c : path.left[i]);
    first_right.push_back(moves_left ? first_right[i] : i + 1);
    first_left.push_back(moves_left ? i + 1 : first_left[i]);
  }

  using Corner = Pulled_path::Corner;
  const auto left_of = [&](std::size_t i) {
    return Corner{s.target(sleeve.halfedges[i]), true, i, first_left[i], path.left[i]};
  };
  const auto right_of = [&](std::size_t i) {
    return Corner{s.source(sleeve.halfedges[i]), false, i, first_right[i], path.right[i]};
  };
  Corner apex{sleeve.start, true, 0, 0, start}, left = apex, right = apex;
  bool left_is_apex = true, right_is_apex = true;
  path.corners.push_back(apex);
  for (std::size_t i = 0; i <= n; ++i)
  {
    const auto restart = [&](const Corner& bend) {
      path.corners.push_back(bend);
      apex = left = right = bend;
      left_is_apex = right_is_apex = true;
      i = bend.portal; // the loop goes on with the portal after it
    };
    if (i == n)
    {
      if (!right_is_apex && turn(apex.at, right.at, end) < 0) { restart(right); }
      else if (!left_is_apex && turn(apex.at, left.at, end) > 0) { restart(left); }
      continue;
    }
    const Corner r = right_of(i), l = left_of(i);
    const bool is_bend = path.corners.size() > 1;
    if (right_is_apex || turn(apex.at, right.at, r.at) >= 0)
    {
      if (!right_is_apex && !left_is_apex && turn(apex.at, left.at, r.at) >= 0)
      {
        restart(left);
        continue;
      }
      right = r;
      right_is_apex = is_bend && !apex.is_left && r.first == apex.first;
    }
    if (left_is_apex || turn(apex.at, left.at, l.at) <= 0)
    {
      if (!left_is_apex && !right_is_apex && turn(apex.at, right.at, l.at) <= 0)
      {
        restart(right);
        continue;
      }
      left = l;
      left_is_apex = is_bend && apex.is_left && l.first == apex.first;
    }
  }
  path.corners.push_back({sleeve.end, true, n, n, end});

  path.fraction.resize(n);
  std::size_t k = 1;
  for (std::size_t i = 0; i < n; ++i)
  {
    while (k + 1 < path.corners.size() && path.corners[k].portal < i) { ++k; }
    const Corner &a = path.corners[k - 1], &b = path.corners[k];
    const auto ends_at = [&](const Corner& corner, bool is_bend) {
      return is_bend && corner.first == (corner.is_left ? first_left : first_right)[i];
    };
    const bool at_a = ends_at(a, k > 1), at_b = ends_at(b, k + 1 < path.corners.size());
    double& t = path.fraction[i];
    if ((at_a && !a.is_left) || (at_b && !b.is_left)) { t = 0; }
    else if (at_a || at_b) { t = 1; }
    else
    {
      const double p = turn(a.at, b.at, path.right[i]), q = turn(a.at, b.at, path.left[i]);
      t = q - p > 0 ? std::min(std::max(-p / (q - p), 0.), 1.) : 0.5;
    }
  }
  return path;
}

inline double angle(const Point_2& at, const Point_2& p, const Point_2& q)
{
  const double x1 = p[0] - at[0], y1 = p[1] - at[1], x2 = q[0] - at[0], y2 = q[1] - at[1];
  return std::abs(std::atan2(x1 * y2 - y1 * x2, x1 * x2 + y1 * y2));
}

// Moves the sleeve to the other side of vertices where the path bends and the other side is shorter, until the path is
// locally shortest (Xin, Wang 2007). `may_cross(h)` and `is_free(v)` say where it may go; no face is used twice.
template <class May_cross, class Is_free>
Pulled_path straighten(const Triangle_surface& s, Sleeve& sleeve, const May_cross& may_cross, const Is_free& is_free)
{
  constexpr int passes = 100;
  constexpr double straight = 3.141592653589793 - 1e-6;
  Pulled_path path = pull(s, sleeve);
  for (int pass = 0; pass < passes && !sleeve.halfedges.empty(); ++pass)
  {
    std::set<Index> faces;
    for (Index h : sleeve.halfedges) { faces.insert(s.face(h)); }
    faces.insert(s.face(s.opposite[sleeve.halfedges.back()]));
    std::size_t last_begin = sleeve.halfedges.size();
    bool changed = false;
    for (std::size_t k = path.corners.size() - 1; k-- > 1;)
    {
      const auto& corner = path.corners[k];
      const Index v = corner.vertex;
      if (!is_free(v) || corner.portal >= sleeve.halfedges.size()) { continue; }
      std::size_t begin = corner.portal, end = corner.portal + 1;
      while (begin > 0 && touches(s, sleeve.halfedges[begin - 1], v)) { --begin; }
      while (end < sleeve.halfedges.size() && touches(s, sleeve.halfedges[end], v)) { ++end; }
      if (end >= last_begin) { continue; }
      double around = 0, inside = 0;
      s.for_each_outgoing(v, [&](Index h) { around += corner_angle(s, h); });
      const auto rim = [&](std::size_t i) { return corner.is_left ? path.right[i] : path.left[i]; };
      inside =
        angle(corner.at, path.corners[k - 1].at, rim(begin)) + angle(corner.at, path.corners[k + 1].at, rim(end - 1));
      for (std::size_t i = begin; i + 1 < end; ++i) { inside += angle(corner.at, rim(i), rim(i + 1)); }
      if (around - inside >= straight) { continue; }
      // The way round the other side.
      const Index goal = s.face(s.opposite[sleeve.halfedges[end - 1]]), h0 = sleeve.halfedges[begin];
      std::vector<Index> detour;
      Index g = corner.is_left ? s.next(h0) : s.prev(h0);
      bool possible = true;
      while (possible)
      {
        possible = may_cross(g);
        if (!possible) { break; }
        detour.push_back(g);
        const Index f = s.face(s.opposite[g]);
        if (f == goal) { break; }
        possible = faces.count(f) == 0;
        g = corner.is_left ? s.next(s.opposite[g]) : s.prev(s.opposite[g]);
      }
      if (!possible) { continue; }
      for (Index h : detour) { faces.insert(s.face(s.opposite[h])); }
      auto& all = sleeve.halfedges;
      all.erase(all.begin() + begin, all.begin() + end);
      all.insert(all.begin() + begin, detour.begin(), detour.end());
      last_begin = begin;
      changed = true;
    }
    if (!changed) { break; }
    trim(s, sleeve);
    if (!sleeve.halfedges.empty()) { path = pull(s, sleeve); }
  }
  return path;
}

// The curve of a sleeve's shortest path. It passes through free vertices where it bends, and beside the others.
template <class May_cross, class Is_free>
Surface_curve shortest_curve(const Triangle_surface& s, Sleeve& sleeve, const May_cross& may_cross,
                             const Is_free& is_free)
{
  constexpr double beside = 0.2;
  Surface_curve curve;
  curve.points.push_back(Curve_point::on_vertex(sleeve.start));
  if (!sleeve.halfedges.empty())
  {
    const Pulled_path path = straighten(s, sleeve, may_cross, is_free);
    std::vector<Crossing> crossings;
    for (std::size_t i = 0; i < sleeve.halfedges.size(); ++i)
    {
      const Index h = sleeve.halfedges[i], e = s.edge(h);
      double t = path.fraction[i]; // beside a vertex that cannot be passed, room is left for the next link
      if (!is_free(s.source(h))) { t = std::max(t, beside); }
      if (!is_free(s.target(h))) { t = std::min(t, std::max(1 - beside, 0.5)); }
      crossings.push_back({h, e, 0, 0, e == h ? t : 1 - t, true});
    }
    if (!crossings.empty())
    {
      const Surface_curve inside = place_crossings(s, {crossings}, false, is_free).front();
      curve.points.insert(curve.points.end(), inside.points.begin(), inside.points.end());
    }
  }
  curve.points.push_back(Curve_point::on_vertex(sleeve.end));
  return curve;
}

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_CURVES_SLEEVE_H
