// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CURVES_SLEEVE_H
#define MERIDIAN_CURVES_SLEEVE_H

#include <meridian/base/vectors.h>
#include <meridian/curves/place_crossings.h>
#include <meridian/surface/Surface_curve.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/measures.h>

#include <algorithm>
#include <array>
#include <set>
#include <vector>

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
void trim(const Triangle_surface& s, Sleeve& sleeve);

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
Pulled_path pull(const Triangle_surface& s, const Sleeve& sleeve);

double angle(const Point_2& at, const Point_2& p, const Point_2& q);

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
