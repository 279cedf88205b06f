// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CURVES_SLEEVE_H
#define MERIDIAN_CURVES_SLEEVE_H

#include <meridian/base/vectors.h>
#include <meridian/surface/Surface_curve.h>
#include <meridian/surface/Triangle_surface.h>

#include <array>
#include <cstddef>
#include <functional>
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

// The same for a strip that ends where it begins. It is unrolled several times over and pulled between its far ends; of
// the fractions there are those of the middle turn, which is what is wanted. `turns`: how many there were.
Pulled_path pull_closed(const Triangle_surface& s, const std::vector<Index>& halfedges, std::size_t& turns);

double angle(const Point_2& at, const Point_2& p, const Point_2& q);

// Where a sleeve may go: which halfedges it may cross, and which vertices its path may pass through.
using May_cross = std::function<bool(Index)>;
using Is_free = std::function<bool(Index)>;

// Moves the sleeve to the other side of vertices where the path bends and the other side is shorter, until the path is
// locally shortest (Xin, Wang 2007). No face is used twice.
Pulled_path straighten(const Triangle_surface& s, Sleeve& sleeve, const May_cross& may_cross, const Is_free& is_free);

// The curve of a sleeve's shortest path. It passes through free vertices where it bends, and beside the others.
Surface_curve shortest_curve(const Triangle_surface& s, Sleeve& sleeve, const May_cross& may_cross,
                             const Is_free& is_free);

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_CURVES_SLEEVE_H
