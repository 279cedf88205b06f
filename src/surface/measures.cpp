// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/surface/measures.h>

#include <meridian/surface/distance_rings.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace meridian {

double exterior_dihedral_angle(const Triangle_surface& s, Index h)
{
  const auto normal = [&](Index f) {
    const auto& t = s.triangles[f];
    return cross(s.points[t[1]] - s.points[t[0]], s.points[t[2]] - s.points[t[0]]);
  };
  const Point a = normal(s.face(h)), b = normal(s.face(s.opposite[h]));
  return std::atan2(norm(cross(a, b)), dot(a, b));
}

double corner_angle(const Triangle_surface& s, Index h)
{
  const Point a = s.points[s.target(h)] - s.points[s.source(h)], b = s.points[s.apex(h)] - s.points[s.source(h)];
  return std::atan2(norm(cross(a, b)), dot(a, b));
}

double area(const Triangle_surface& s)
{
  double sum = 0;
  for (const auto& t : s.triangles)
    sum += norm(cross(s.points[t[1]] - s.points[t[0]], s.points[t[2]] - s.points[t[0]])) / 2;
  return sum;
}

double smallest_angle(const Triangle_surface& s)
{
  double cotangent = -std::numeric_limits<double>::infinity(); // of the smallest angle so far: the largest
  for (const auto& t : s.triangles)
  {
    const Point ab = s.points[t[1]] - s.points[t[0]], bc = s.points[t[2]] - s.points[t[1]],
                ca = s.points[t[0]] - s.points[t[2]];
    const double twice_area = norm(cross(ab, ca));
    if (!(twice_area > 0)) { return 0; }
    cotangent = std::max(cotangent, -std::min({dot(ab, ca), dot(ab, bc), dot(bc, ca)}) / twice_area);
  }
  return std::atan2(1., cotangent);
}

Curvature curvature(const Triangle_surface& s, Index v)
{
  Curvature c;
  if (s.is_boundary_vertex(v)) { return c; }
  const auto normal = [&](Index f) {
    const auto& t = s.triangles[f];
    return cross(s.points[t[1]] - s.points[t[0]], s.points[t[2]] - s.points[t[0]]);
  };
  double angles = 0, area = 0, bending = 0;
  s.for_each_outgoing(v, [&](Index h) {
    const Point left = normal(s.face(h)), right = normal(s.face(s.opposite[h]));
    const Point along = s.points[s.target(h)] - s.points[v];
    angles += corner_angle(s, h);
    area += norm(left) / 6;
    bending += std::atan2(dot(cross(left, right), along), norm(along) * dot(left, right)) * norm(along);
  });
  if (!(area > 0)) { return c; }
  c.gaussian = (2 * std::acos(-1.) - angles) / area;
  c.mean = bending / (4 * area);
  return c;
}

int genus(const Triangle_surface& s)
{
  const int characteristic = s.number_of_vertices() - s.number_of_edges() + s.number_of_faces();
  return (2 - characteristic - static_cast<int>(boundary_loops(s).size())) / 2;
}

std::vector<double> edge_lengths(const Triangle_surface& s, const Closed_model& g)
{
  std::vector<double> lengths;
  lengths.reserve(g.halfedge.size());
  for (Index h : g.halfedge) { lengths.push_back(s.length(h)); }
  return lengths;
}

std::vector<double> edge_distances(const Closed_model& g, const std::vector<double>& lengths, Index source)
{
  const double mean = std::accumulate(lengths.begin(), lengths.end(), 0.) / static_cast<double>(lengths.size());
  return internal::find_distances(g.number_of_nodes, {{0., source}}, mean, [&](Index a, const auto& reach) {
    for (Index i = g.begin[a]; i < g.begin[a + 1]; ++i) { reach(g.neighbor[i], lengths[i]); }
  });
}

std::pair<Index, Index> find_distant_nodes(const Triangle_surface& s, const Closed_model& g, int sweeps)
{
  Point centroid{0, 0, 0};
  for (const Point& p : s.points) { centroid = centroid + p; }
  centroid = (1. / s.number_of_vertices()) * centroid;
  const auto farthest = [&](const auto& measure) {
    Index best = 0;
    for (Index a = 1; a < g.number_of_nodes; ++a)
    {
      if (measure(a) > measure(best)) { best = a; }
    }
    return best;
  };
  Index from = farthest([&](Index a) { return distance(s.points[g.representative[a]], centroid); });
  Index to = from;
  double reached = -1;
  const std::vector<double> lengths = edge_lengths(s, g);
  for (int i = 0; i < sweeps; ++i)
  {
    const auto d = edge_distances(g, lengths, from);
    const Index next = farthest([&](Index a) { return a == from ? -1 : d[a]; });
    if (!(d[next] > reached)) { break; }
    reached = d[next];
    to = from;
    from = next;
  }
  return {from, to};
}

namespace internal {

double length(const Triangle_surface& s, const std::vector<Index>& loop)
{
  double sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    sum += distance(s.points[loop[i]], s.points[loop[(i + 1) % loop.size()]]);
  }
  return sum;
}

} // namespace internal

namespace {

// Bounds the areas of nodes below by a tiny part of their mean.
void bound_areas(std::vector<double>& areas, double sum)
{
  const double mean = sum / static_cast<double>(areas.size());
  for (double& a : areas) { a = mean > 0 ? std::max(a, 1e-8 * mean) : 1; }
}

} // namespace

std::vector<double> node_areas(const Triangle_surface& s, const Closed_model& g)
{
  std::vector<double> areas(g.number_of_nodes, 0);
  double sum = 0;
  for (const auto& t : s.triangles)
  {
    const double area = norm(cross(s.points[t[1]] - s.points[t[0]], s.points[t[2]] - s.points[t[0]])) / 2;
    for (Index v : t) { areas[g.node[v]] += area / 3; }
    sum += area;
  }
  bound_areas(areas, sum);
  return areas;
}

} // namespace meridian
