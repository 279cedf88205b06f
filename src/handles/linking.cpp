// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/handles/internal/linking.h>

#include <meridian/handles/internal/tree_cotree.h>
#include <meridian/surface/root_edges.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <utility>
#include <vector>

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

// Of a surface as large as m, a determinant is made of sums of six differences up to m, or of six projected places up
// to 2 m, each with an error of less than 64 roundings of numbers of size m. What this comes to, times what it is
// multiplied with, is for a side less than 2^15 roundings of m^2, and for a volume less than 2^20 roundings of m^3.
Exact_signs::Exact_signs(const Triangle_surface& s) : m_surface(s)
{
  double m = 0;
  Point corner;
  for (int k = 0; k < 3; ++k)
  {
    const auto [low, high] = std::minmax_element(s.points.begin(), s.points.end(),
                                                 [&](const Point& p, const Point& q) { return p[k] < q[k]; });
    m = std::max(m, (*high)[k] - (*low)[k]);
    corner[k] = (*low)[k];
  }
  for (const Point& p : s.points)
  {
    const Point d = p - corner;
    m_seen.push_back({d[0] - direction[0] * d[2], d[1] - direction[1] * d[2]});
  }
  constexpr double rounding = std::numeric_limits<double>::epsilon(); // in whatever direction
  m_sure_side = rounding * (1 << 15) * m * m;
  m_sure_volume = rounding * (1 << 20) * m * m * m;
}

int Exact_signs::side(const Weighted_point& a, const Weighted_point& b, const Weighted_point& q) const
{
  const double fast = cross(a.seen, b.seen, q.seen);
  if (fast > m_sure_side) { return 1; }
  if (fast < -m_sure_side) { return -1; }
  const auto v = along(normal<CGAL::Interval_nt<false>>(a, b, a, q));
  if (v.inf() > 0) { return 1; }
  if (v.sup() < 0) { return -1; }
  const auto n = normal<CGAL::Exact_rational>(a, b, a, q);
  for (const CGAL::Exact_rational& x : {CGAL::Exact_rational(along(n)), n[0], n[1]})
  {
    if (x != 0) { return x > 0 ? 1 : -1; }
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
  const double fast = of(0.);
  if (fast > m_sure_volume) { return 1; }
  if (fast < -m_sure_volume) { return -1; }
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

namespace {

using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 2, Index>;

// The box of some vertices, seen along the direction, and a little more.
Box box_of(const Triangle_surface& s, std::initializer_list<Index> vertices, Index info)
{
  CGAL::Bbox_2 box;
  for (Index v : vertices)
  {
    const Point& p = s.points[v];
    const CGAL::Interval_nt<false> x = p[0] - CGAL::Interval_nt<false>(Exact_signs::direction[0]) * p[2],
                                   y = p[1] - CGAL::Interval_nt<false>(Exact_signs::direction[1]) * p[2];
    box += CGAL::Bbox_2(x.inf(), y.inf(), x.sup(), y.sup());
  }
  return Box(box, info);
}

// Counts by edge how a loop through faces that crosses the edge passes over walks, seen in the projection. An edge that
// several walks go along is looked at once.
class Linking_count
{
public:
  using Flow = std::vector<std::pair<Index, int>>; // by edge, added up where an edge comes again

  Linking_count(const Triangle_surface& s, const Exact_signs& signs, const std::vector<std::vector<Index>>& walks)
    : m_surface(s), m_signs(signs), m_walks(walks)
  {
    for (const auto& walk : walks)
      for (Index h : walk) { m_edges.push_back(s.edge(h)); }
    std::sort(m_edges.begin(), m_edges.end());
    m_edges.erase(std::unique(m_edges.begin(), m_edges.end()), m_edges.end());
    m_over.resize(m_edges.size());
  }

  // False if something touches that should not.
  bool count()
  {
    std::vector<Box> edges, faces;
    for (std::size_t i = 0; i < m_edges.size(); ++i)
    {
      if (!count_at(i)) { return false; }
      const Index h = m_edges[i];
      edges.push_back(box_of(m_surface, {m_surface.source(h), m_surface.target(h)}, static_cast<Index>(i)));
    }
    for (Index f = 0; f < m_surface.number_of_faces(); ++f)
    {
      const auto& t = m_surface.triangles[f];
      faces.push_back(box_of(m_surface, {t[0], t[1], t[2]}, f));
    }
    // The pairs come in no order that means anything; the counts are sums.
    bool is_good = true;
    CGAL::box_intersection_d(
      edges.begin(), edges.end(), faces.begin(), faces.end(),
      [&](const Box& edge, const Box& face) { is_good = is_good && count_over(edge.info(), face.info()); });
    return is_good;
  }

  // For walk `i`, what a loop counts that crosses an edge from the face of its halfedge: over the walk, and across it.
  Flow linked(std::size_t i) const
  {
    Flow flow;
    for (const auto& [e, sign] : crossed(i))
    {
      const Flow& over = m_over[std::lower_bound(m_edges.begin(), m_edges.end(), e) - m_edges.begin()];
      for (const auto& [edge, amount] : over) { flow.emplace_back(edge, sign * amount); }
    }
    return flow;
  }
  Flow crossed(std::size_t i) const
  {
    Flow flow;
    for (Index h : m_walks[i]) { flow.emplace_back(m_surface.edge(h), m_surface.edge(h) == h ? 1 : -1); }
    return flow;
  }

private:
  // Where a loop crosses an edge of the walk itself, pushed along the normals. Seen in the projection, it passes over
  // the edge from left to right, or it stays on one side of it and goes round it only where the surface folds away from
  // the edge.
  bool count_at(std::size_t i)
  {
    const Index e = m_edges[i], o = m_surface.opposite[e];
    const Weighted_point a = m_signs.vertex(m_surface.source(e)), b = m_signs.vertex(m_surface.target(e));
    const Weighted_point left_apex = m_signs.vertex(m_surface.apex(e)), right_apex = m_signs.vertex(m_surface.apex(o));
    const int left_up = m_signs.side(a, b, left_apex), right_up = -m_signs.side(a, b, right_apex);
    if (left_up == 0 || right_up == 0) { return false; }
    bool passes_over = left_up > 0;
    if (left_up != right_up)
    {
      const int fold = m_signs.volume(a, b, a, left_apex, right_apex);
      if (fold == 0) { return false; }
      passes_over = fold < 0;
    }
    if (passes_over) { m_over[i].emplace_back(e, -1); }
    return true;
  }

  // Where a loop in a face passes over an edge of walks elsewhere.
  bool count_over(Index i, Index f)
  {
    const Triangle_surface& s = m_surface;
    const Index e = m_edges[i];
    const auto& t = s.triangles[f];
    if (m_signs.is_beside(s.source(e), s.target(e), t)) { return true; }
    const Weighted_point a = m_signs.vertex(s.source(e)), b = m_signs.vertex(s.target(e));
    const auto left = [&](const Weighted_point& from, const Weighted_point& to, const Weighted_point& q) {
      return m_signs.side(from, to, q) >= 0;
    };
    const Weighted_point centre = m_signs.centre(t[0], t[1], t[2]);
    const bool centre_left = left(a, b, centre);
    for (Index h = 3 * f; h < 3 * f + 3; ++h)
    {
      if (s.edge(h) == e) { continue; }
      // the same from both faces
      const Weighted_point middle =
        m_signs.middle(std::min(s.source(h), s.target(h)), std::max(s.source(h), s.target(h)));
      const bool middle_left = left(a, b, middle);
      if (middle_left == centre_left || left(centre, middle, a) == left(centre, middle, b)) { continue; }
      const int turn = middle_left ? 1 : -1; // from the centre outwards
      const int height = m_signs.volume(a, b, centre, middle, centre);
      if (height == 0) { return false; }
      if (height * turn > 0) { m_over[i].emplace_back(s.edge(h), s.edge(h) == h ? turn : -turn); }
    }
    return true;
  }

  const Triangle_surface& m_surface;
  const Exact_signs& m_signs;
  const std::vector<std::vector<Index>>& m_walks;
  std::vector<Index> m_edges; // of all walks, sorted
  std::vector<Flow> m_over;   // of each of them: what a loop counts that passes over it
};

} // namespace

std::vector<Sides> find_bounding_sides(const Triangle_surface& s, const std::vector<std::vector<Index>>& walks)
{
  const CGAL::Interval_nt<false>::Protector rounding;
  const Exact_signs signs(s);
  const int orientation = signs.enclosed();
  if (orientation == 0) { return {}; }
  Linking_count count(s, signs, walks);
  if (!count.count()) { return {}; }
  const Tree_cotree trees(s);
  std::vector<Sides> result;
  for (std::size_t walk = 0; walk < walks.size(); ++walk)
  {
    // Pushed along the normals, the loops lie on their side, and the walk bounds on the other if it is not linked with
    // any.
    const std::vector<int> above = trees.integrate(count.linked(walk)), across = trees.integrate(count.crossed(walk));
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
