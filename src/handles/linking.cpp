// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/handles/internal/linking.h>

#include <meridian/handles/internal/tree_cotree.h>
#include <meridian/surface/root_edges.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Interval_nt.h>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <map>
#include <utility>

namespace meridian {

namespace internal {

std::vector<Index> walk_on_root(const Triangle_surface& root, const Refined_surface& s, const std::vector<Index>& loop)
{
  std::vector<Index> walk;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const Index v = loop[i], w = loop[(i + 1) % loop.size()], a = root_vertex(root, s, v), b = root_vertex(root, s, w);
    if (a == b) { continue; }
    Index h = s.find_halfedge(v, w);
    const Index f = s.face_of[s.face(h >= 0 ? h : s.find_halfedge(w, v))];
    for (Index k = 3 * f; k < 3 * f + 3; ++k)
    {
      if (root.source(k) == a && root.target(k) == b) { h = k; }
      if (root.source(k) == b && root.target(k) == a) { h = root.opposite[k] >= 0 ? root.opposite[k] : -1; }
    }
    if (h < 0) { return {}; } // along a boundary; such surfaces are not asked about
    walk.push_back(h);
  }
  return walk;
}

int Exact_signs::side(const Weighted_point& a, const Weighted_point& b, const Weighted_point& q) const
{
  using I = CGAL::Interval_nt<false>;
  const auto n = normal<I>(a, b, a, q);
  for (int k : {2, 0, 1})
  {
    if (n[k].inf() > 0) { return 1; }
    if (n[k].sup() < 0) { return -1; }
    if (!(n[k].inf() == 0 && n[k].sup() == 0))
    {
      const auto exact = normal<CGAL::Exact_rational>(a, b, a, q);
      for (int i : {2, 0, 1})
      {
        if (exact[i] != 0) { return exact[i] > 0 ? 1 : -1; }
      }
      return 0;
    }
  }
  return 0;
}

int Exact_signs::volume(const Weighted_point& a, const Weighted_point& b, const Weighted_point& p,
                        const Weighted_point& q, const Weighted_point& r) const
{
  const auto of = [&](auto zero) {
    using N = decltype(zero);
    const auto n = normal<N>(a, b, p, q), d = difference<N>(a, r);
    return N(n[0] * d[0] + n[1] * d[1] + n[2] * d[2]);
  };
  const auto v = of(CGAL::Interval_nt<false>(0));
  if (v.inf() > 0) { return 1; }
  if (v.sup() < 0) { return -1; }
  const auto exact = of(CGAL::Exact_rational(0));
  return exact > 0 ? 1 : exact < 0 ? -1 : 0;
}

int Exact_signs::enclosed() const
{
  const auto of = [&](auto sum) {
    using N = decltype(sum);
    for (const auto& t : m_surface.triangles)
    {
      const auto a = position<N>(t[0]), b = position<N>(t[1]), c = position<N>(t[2]);
      sum +=
        a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
    }
    return sum;
  };
  const auto v = of(CGAL::Interval_nt<false>(0));
  if (v.inf() > 0) { return 1; }
  if (v.sup() < 0) { return -1; }
  const auto exact = of(CGAL::Exact_rational(0));
  return exact > 0 ? 1 : exact < 0 ? -1 : 0;
}

std::vector<Sides> find_bounding_sides(const Triangle_surface& s, const std::vector<std::vector<Index>>& walks)
{
  const CGAL::Interval_nt<false>::Protector rounding;
  const Exact_signs signs(s);
  const int orientation = signs.enclosed();
  if (orientation == 0) { return {}; }
  namespace geometry = boost::geometry;
  using Planar_point = geometry::model::point<double, 2, geometry::cs::cartesian>;
  using Box = geometry::model::box<Planar_point>;
  std::vector<std::pair<Box, Index>> boxes;
  const auto box = [&](std::initializer_list<Index> vertices) {
    Box b;
    geometry::assign_inverse(b);
    for (Index v : vertices) { geometry::expand(b, Planar_point(s.points[v][0], s.points[v][1])); }
    return b;
  };
  for (Index f = 0; f < s.number_of_faces(); ++f)
  {
    const auto& t = s.triangles[f];
    boxes.emplace_back(box({t[0], t[1], t[2]}), f);
  }
  const geometry::index::rtree<std::pair<Box, Index>, geometry::index::rstar<16>> tree(boxes);
  const Tree_cotree trees(s);

  const auto vertex = [](Index v) { return Weighted_point{v, v, v, v, v, v}; };
  const auto left = [&](const Weighted_point& a, const Weighted_point& b, const Weighted_point& q) {
    return signs.side(a, b, q) >= 0;
  };
  std::vector<Sides> result;
  std::vector<std::pair<Box, Index>> near;
  for (const auto& walk : walks)
  {
    std::map<Index, int> linked, crossed; // by edge: what a loop counts that crosses it from the face of the halfedge
    for (Index e : walk)
    {
      const Weighted_point a = vertex(s.source(e)), b = vertex(s.target(e));
      const Index own = s.edge(e);
      crossed[own] += own == e ? 1 : -1;
      // Where a loop crosses the walk itself, pushed along the normals. Seen in the projection, it passes over the edge
      // from left to right, or it stays on one side of it and goes round it only where the surface folds away from the
      // edge.
      const Index o = s.opposite[e];
      const int left_up = signs.side(a, b, vertex(s.apex(e))), right_up = -signs.side(a, b, vertex(s.apex(o)));
      const int fold = signs.volume(a, b, a, vertex(s.apex(e)), vertex(s.apex(o)));
      if (left_up == 0 || right_up == 0 || (left_up != right_up && fold == 0)) { return {}; }
      if (left_up == right_up ? left_up > 0 : fold < 0) { linked[own] += own == e ? -1 : 1; }
      // Everything else that passes over the edge.
      near.clear();
      tree.query(geometry::index::intersects(box({s.source(e), s.target(e)})), std::back_inserter(near));
      for (const auto& [ignored, f] : near)
      {
        const auto& t = s.triangles[f];
        const Weighted_point centre{t[0], t[0], t[1], t[1], t[2], t[2]};
        const bool centre_left = left(a, b, centre);
        for (Index h = 3 * f; h < 3 * f + 3; ++h)
        {
          if (s.edge(h) == own) { continue; }
          // the same from both faces
          const Index u = std::min(s.source(h), s.target(h)), v = std::max(s.source(h), s.target(h));
          const Weighted_point middle{u, u, u, v, v, v};
          const bool middle_left = left(a, b, middle);
          if (middle_left == centre_left || left(centre, middle, a) == left(centre, middle, b)) { continue; }
          const int turn = middle_left ? 1 : -1; // from the centre outwards
          const int height = signs.volume(a, b, centre, middle, centre);
          if (height == 0) { return {}; }
          if (height * turn > 0) { linked[s.edge(h)] += s.edge(h) == h ? turn : -turn; }
        }
      }
    }
    // Pushed along the normals, the loops lie on their side, and the walk bounds on the other if it is not linked with
    // any.
    const std::vector<int> above = trees.integrate(linked), across = trees.integrate(crossed);
    bool bounds_below = true, bounds_above = true;
    for (std::size_t i = 0; i < above.size(); ++i)
    {
      bounds_below = bounds_below && above[i] == 0;
      bounds_above = bounds_above && above[i] + across[i] == 0;
    }
    result.push_back(orientation > 0 ? Sides{bounds_below, bounds_above} : Sides{bounds_above, bounds_below});
  }
  return result;
}

} // namespace internal

} // namespace meridian
