// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_HANDLES_INTERNAL_LINKING_H
#define MERIDIAN_HANDLES_INTERNAL_LINKING_H

#include <meridian/base/vectors.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/Surface_curve.h>
#include <meridian/surface/Triangle_surface.h>

#include <array>
#include <vector>

namespace meridian {
namespace internal {

// A curve on a refined surface, pushed to the nearest corners of the faces of the root: a closed walk of its halfedges.
std::vector<Index> walk_on_root(const Triangle_surface& root, const Refined_surface& s, const std::vector<Index>& loop);

// A point as a sum of six vertices, exact where it must be: a vertex is (v,v,v,v,v,v), a midpoint (v,v,v,w,w,w), a
// centre (u,u,v,v,w,w).
struct Weighted_point
{
  std::array<Index, 6> vertices;
  std::array<double, 2> seen; // about where, along the direction of projection
};

// Signs of determinants of such points: from floating-point numbers where these are sure, from intervals where they
// tell, from rational numbers otherwise.
class Exact_signs
{
public:
  // The surface is seen along this direction: of a mesh whose vertices lie on a grid no edge and no face stands
  // upright.
  static constexpr std::array<double, 3> direction{0.29289321881345254, 0.41421356237309515, 1};

  explicit Exact_signs(const Triangle_surface& s);

  Weighted_point vertex(Index v) const { return {{v, v, v, v, v, v}, sum(6, m_seen[v])}; }
  Weighted_point middle(Index v, Index w) const { return {{v, v, v, w, w, w}, sum(3, m_seen[v], m_seen[w])}; }
  Weighted_point centre(Index u, Index v, Index w) const
  {
    return {{u, u, v, v, w, w}, sum(2, m_seen[u], m_seen[v], m_seen[w])};
  }

  // Which side of the plane through line ab and the direction q lies on: 1 on the left, seen against the direction,
  // to which (e, e^2, 0) is added for an infinitely small e. 0 if and only if the three lie on a line.
  int side(const Weighted_point& a, const Weighted_point& b, const Weighted_point& q) const;
  // Whether all corners of a face surely lie on the same side.
  bool is_beside(Index a, Index b, const std::array<Index, 3>& face) const
  {
    int left = 0, right = 0;
    for (Index v : face)
    {
      const double turn = 36 * cross(m_seen[a], m_seen[b], m_seen[v]); // as large as that of weighted points
      left += turn > m_sure_side;
      right += turn < -m_sure_side;
    }
    return left == 3 || right == 3;
  }
  // The sign of the volume of (b - a, q - p, r - a).
  int volume(const Weighted_point& a, const Weighted_point& b, const Weighted_point& p, const Weighted_point& q,
             const Weighted_point& r) const;
  // The sign of the volume that a closed surface encloses.
  int enclosed() const;

private:
  using Seen = std::array<double, 2>;
  static Seen sum(double weight, const Seen& a, const Seen& b = {0, 0}, const Seen& c = {0, 0})
  {
    return {weight * (a[0] + b[0] + c[0]), weight * (a[1] + b[1] + c[1])};
  }
  static double cross(const Seen& a, const Seen& b, const Seen& q)
  {
    return (b[0] - a[0]) * (q[1] - a[1]) - (b[1] - a[1]) * (q[0] - a[0]);
  }
  template <class N> std::array<N, 3> position(Index v) const
  {
    const Point& p = m_surface.points[v];
    return {N(p[0]), N(p[1]), N(p[2])};
  }
  template <class N> std::array<N, 3> difference(const Weighted_point& from, const Weighted_point& to) const
  {
    std::array<N, 3> d{N(0), N(0), N(0)};
    for (std::size_t i = 0; i < 6; ++i)
    {
      if (from.vertices[i] == to.vertices[i]) { continue; }
      const auto p = position<N>(from.vertices[i]), q = position<N>(to.vertices[i]);
      for (int k = 0; k < 3; ++k) { d[k] += q[k] - p[k]; }
    }
    return d;
  }
  template <class N>
  std::array<N, 3> normal(const Weighted_point& a, const Weighted_point& b, const Weighted_point& p,
                          const Weighted_point& q) const
  {
    const auto u = difference<N>(a, b), v = difference<N>(p, q);
    return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  }

  template <class N> static N along(const std::array<N, 3>& v)
  {
    return v[0] * N(direction[0]) + v[1] * N(direction[1]) + v[2];
  }

  const Triangle_surface& m_surface;
  std::vector<Seen> m_seen;          // the vertices, projected
  double m_sure_side, m_sure_volume; // a floating-point determinant beyond has the right sign
};

// On which sides of the surface a walk bounds.
struct Sides
{
  bool inside = false, outside = false;
};

// For each walk of halfedges, by its linking numbers with loops through faces pushed off to the one and to the other
// side. Empty if something touches that should not.
std::vector<Sides> find_bounding_sides(const Triangle_surface& s, const std::vector<std::vector<Index>>& walks);

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_HANDLES_INTERNAL_LINKING_H
