// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/surface/renumber.h>

#include <CGAL/hilbert_sort.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace meridian {

namespace internal {

namespace {

// The geometric traits that CGAL's spatial sorting asks for: its points are vertices.
struct Vertex_sort_traits
{
  using Point_3 = Index;

  struct Coordinate
  {
    const std::vector<Point>* points;
    int axis;
    double operator()(Index v) const { return (*points)[v][axis]; }
  };
  struct Less
  {
    Coordinate of;
    bool operator()(Index v, Index w) const { return of(v) < of(w); }
  };
  using Compute_x_3 = Coordinate;
  using Compute_y_3 = Coordinate;
  using Compute_z_3 = Coordinate;
  using Less_x_3 = Less;
  using Less_y_3 = Less;
  using Less_z_3 = Less;

  Coordinate compute_x_3_object() const { return {&points, 0}; }
  Coordinate compute_y_3_object() const { return {&points, 1}; }
  Coordinate compute_z_3_object() const { return {&points, 2}; }
  Less less_x_3_object() const { return {compute_x_3_object()}; }
  Less less_y_3_object() const { return {compute_y_3_object()}; }
  Less less_z_3_object() const { return {compute_z_3_object()}; }

  const std::vector<Point>& points;
};

std::vector<Index> inverse(const std::vector<Index>& order)
{
  std::vector<Index> place(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) { place[order[i]] = static_cast<Index>(i); }
  return place;
}

template <class T> void take_in_order(std::vector<T>& values, const std::vector<Index>& order)
{
  std::vector<T> taken;
  taken.reserve(values.size());
  for (Index i : order) { taken.push_back(values[i]); }
  values = std::move(taken);
}

// The faces by their lowest vertices, those of one vertex as they were.
std::vector<Index> order_faces(const Triangle_surface& s)
{
  const auto lowest = [&](Index f) { return *std::min_element(s.triangles[f].begin(), s.triangles[f].end()); };
  std::vector<Index> next(s.number_of_vertices() + 1, 0), order(s.number_of_faces());
  for (Index f = 0; f < s.number_of_faces(); ++f) { ++next[lowest(f) + 1]; }
  std::partial_sum(next.begin(), next.end(), next.begin());
  for (Index f = 0; f < s.number_of_faces(); ++f) { order[next[lowest(f)]++] = f; }
  return order;
}

} // namespace

} // namespace internal

bool is_scattered(const Triangle_surface& s)
{
  constexpr Index line = 4, lines = 4096; // vertices in a line of the cache, and lines
  std::vector<Index> cached(lines, -1);
  std::int64_t missed = 0;
  for (const auto& corners : s.triangles)
    for (Index v : corners)
    {
      Index& here = cached[v / line % lines];
      missed += here >= 0 && here != v / line;
      here = v / line;
    }
  return 10 * missed > 3 * std::int64_t(s.number_of_halfedges());
}

void renumber(Surface_component& c)
{
  Triangle_surface& s = c.surface;
  std::vector<Index> vertices(s.number_of_vertices());
  std::iota(vertices.begin(), vertices.end(), Index(0));
  CGAL::hilbert_sort(vertices.begin(), vertices.end(), internal::Vertex_sort_traits{s.points});
  const std::vector<Index> place = internal::inverse(vertices);
  for (auto& corners : s.triangles)
  {
    for (Index& v : corners) { v = place[v]; }
  }
  internal::take_in_order(s.points, vertices);
  internal::take_in_order(c.vertex_of, vertices);
  const std::vector<Index> faces = internal::order_faces(s), face_place = internal::inverse(faces);
  std::vector<Index> opposite;
  opposite.reserve(s.opposite.size());
  for (Index f : faces)
    for (Index h = 3 * f; h < 3 * f + 3; ++h)
    {
      const Index o = s.opposite[h];
      opposite.push_back(o < 0 ? -1 : 3 * face_place[o / 3] + o % 3);
    }
  s.opposite = std::move(opposite);
  internal::take_in_order(s.triangles, faces);
  internal::take_in_order(c.triangle_of, faces);
  internal::take_in_order(c.polygon_of, faces);
  internal::take_in_order(c.is_flipped, faces);
  find_outgoing(s);
}

} // namespace meridian
