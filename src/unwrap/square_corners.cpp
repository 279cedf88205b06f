// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/unwrap/internal/square_corners.h>

#include <meridian/surface/Surface_curve.h>
#include <meridian/surface/insert_curves.h>

#include <algorithm>
#include <cmath>

namespace meridian {

namespace internal {

double angle_at(const Triangle_surface& s, Index v)
{
  double sum = 0;
  s.for_each_outgoing(v, [&](Index h) {
    const Point a = s.points[s.target(h)] - s.points[v], b = s.points[s.apex(h)] - s.points[v];
    sum += std::atan2(norm(cross(a, b)), dot(a, b));
  });
  return sum;
}

void turn_whole_border(const Triangle_surface& disc, Border_strands& border)
{
  Strand& strand = border.strands.front();
  Border_side& side = border.sides.front();
  const std::size_t n = strand.vertices.size() - 1;
  std::vector<double> angle(n), around(3 * n + 1); // three times around, so that every neighbour is there
  for (std::size_t i = 0; i < n; ++i) { angle[i] = angle_at(disc, side.vertices[i]); }
  for (std::size_t i = 0; i <= 3 * n; ++i)
  {
    const auto turns = i / n;
    around[i] = strand.along[i % n] + strand.steps * static_cast<double>(turns);
  }
  const auto steps_of_side = strand.steps / 4;
  std::size_t best = 0;
  double least = 1e300;
  for (std::size_t i = 0; i < n; ++i)
  {
    double cost = angle[i];
    for (int quarter = 1; quarter < 4; ++quarter)
    {
      const Index v = vertex_near(around, around[n + i] + quarter * steps_of_side);
      cost += v < 0 ? cost_inside_edge : angle[v % n];
    }
    if (cost < least - 1e-9)
    {
      least = cost;
      best = i;
    }
  }
  for (auto* vertices : {&strand.vertices, &side.vertices})
  {
    vertices->pop_back();
    std::rotate(vertices->begin(), vertices->begin() + best, vertices->end());
    vertices->push_back(vertices->front());
  }
  space_strand(disc, strand);
}

int choose_corners(const Triangle_surface& disc, Border_strands& border, int size)
{
  if (border.is_whole)
  {
    turn_whole_border(disc, border);
    return 0;
  }
  std::vector<double> cost(4 * (size - 1));
  for (int p = 0; p < 4 * (size - 1); ++p)
  {
    const auto [s, step] = side_at(border, p);
    const Border_side& side = border.sides[s];
    const Strand& strand = border.strands[side.strand];
    const int on_strand = side.is_reversed ? strand.steps - step : step;
    Index place = vertex_near(strand.along, on_strand);
    if (step == 0) { place = side.is_reversed ? static_cast<Index>(side.vertices.size()) - 1 : 0; }
    cost[p] = place < 0 ? cost_inside_edge : angle_at(disc, side.vertices[place]);
  }
  int best = 0;
  double least = 1e300;
  for (int p = 0; p + 1 < size; ++p)
  {
    const double sum = cost[p] + cost[p + size - 1] + cost[p + 2 * (size - 1)] + cost[p + 3 * (size - 1)];
    if (sum < least - 1e-9)
    {
      least = sum;
      best = p;
    }
  }
  return best;
}

Divided_edges divide_at_corners(const Triangle_surface& root, Refined_surface& s, Border_strands& border,
                                int first_corner, int size)
{
  std::vector<std::vector<int>> stops(border.strands.size());
  for (int j = 0; j < 4; ++j)
  {
    const auto [b, step] = side_at(border, (first_corner + j * (size - 1)) % (4 * (size - 1)));
    const Border_side& side = border.sides[b];
    if (step > 0) { stops[side.strand].push_back(side.is_reversed ? border.strands[side.strand].steps - step : step); }
  }
  struct Point_to_insert
  {
    Index strand;
    std::size_t place;
    int step;
    Index a, b;
    double t;
  };
  std::vector<Point_to_insert> points;
  std::vector<Surface_curve> curves;
  for (std::size_t k = 0; k < stops.size(); ++k)
  {
    Strand& strand = border.strands[k];
    std::sort(stops[k].begin(), stops[k].end());
    stops[k].erase(std::unique(stops[k].begin(), stops[k].end()), stops[k].end());
    std::vector<int> inside;
    for (int step : stops[k])
    {
      const Index near = vertex_near(strand.along, step);
      if (near >= 0) { strand.along[near] = step; }
      else { inside.push_back(step); }
    }
    for (int step : inside)
    {
      const std::size_t i = std::upper_bound(strand.along.begin(), strand.along.end(), step) - strand.along.begin() - 1;
      const double t = (step - strand.along[i]) / (strand.along[i + 1] - strand.along[i]);
      points.push_back({static_cast<Index>(k), i + 1, step, strand.vertices[i], strand.vertices[i + 1], t});
      curves.push_back({{Curve_point::on_edge(s.find_halfedge(strand.vertices[i], strand.vertices[i + 1]), t)}, false});
    }
  }
  const auto inserted = insert_curves(root, s, curves).vertices;
  Divided_edges divided;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    auto& list = divided[std::minmax(points[i].a, points[i].b)];
    list.insert(points[i].a < points[i].b ? list.end() : list.begin(), inserted[i].front()); // steps ascend from a to b
  }
  for (std::size_t i = points.size(); i-- > 0;) // the last first, so that places stay
  {
    Strand& strand = border.strands[points[i].strand];
    strand.vertices.insert(strand.vertices.begin() + points[i].place, inserted[i].front());
    strand.along.insert(strand.along.begin() + points[i].place, points[i].step);
  }
  return divided;
}

void insert_into_curve(const Divided_edges& divided, std::vector<Index>& curve, bool is_closed)
{
  std::vector<Index> longer;
  for (std::size_t i = 0; i < curve.size(); ++i)
  {
    longer.push_back(curve[i]);
    if (i + 1 == curve.size() && !is_closed) { break; }
    const Index a = curve[i], b = curve[(i + 1) % curve.size()];
    const auto found = divided.find(std::minmax(a, b));
    if (found == divided.end()) { continue; }
    if (a < b) { longer.insert(longer.end(), found->second.begin(), found->second.end()); }
    else { longer.insert(longer.end(), found->second.rbegin(), found->second.rend()); }
  }
  curve = std::move(longer);
}

Plane_point point_on_square(double place, int size)
{
  const double whole = size - 1;
  const int side = std::min(3, static_cast<int>(place / whole));
  const double f = std::max(0., (place - side * whole) / whole);
  switch (side)
  {
  case 0: return {f, 0};
  case 1: return {1, f};
  case 2: return {1 - f, 1};
  default: return {0, 1 - f};
  }
}

} // namespace internal

} // namespace meridian
