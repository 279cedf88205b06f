// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/surface/find_mirror.h>

#include <meridian/base/Bounding_box.h>
#include <meridian/surface/seams.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <unordered_map>
#include <utility>

namespace meridian {

namespace internal {

namespace {

// Vertices by where they are.
class Vertex_places
{
public:
  Vertex_places(const Triangle_surface& s, double near) : m_surface(s), m_near(near)
  {
    for (Index v = 0; v < s.number_of_vertices(); ++v) { m_cells[key(cell_of(s.points[v]))].push_back(v); }
  }

  // The nearest vertex, no farther than is near, or -1.
  Index nearest(const Point& p) const
  {
    const Cell middle = cell_of(p);
    Index best = -1;
    double least = m_near;
    for (int i = 0; i < 27; ++i)
    {
      const auto cell = m_cells.find(key({middle[0] + i % 3 - 1, middle[1] + i / 3 % 3 - 1, middle[2] + i / 9 - 1}));
      if (cell == m_cells.end()) { continue; }
      for (Index v : cell->second)
      {
        const double d = distance(m_surface.points[v], p);
        if (d < least || (!(least < d) && best < 0))
        {
          least = d;
          best = v;
        }
      }
    }
    return best;
  }

private:
  using Cell = std::array<std::int64_t, 3>;

  Cell cell_of(const Point& p) const
  {
    Cell cell;
    for (std::size_t k = 0; k < 3; ++k) { cell[k] = std::llround(p[k] / m_near); }
    return cell;
  }
  // Different cells may have one: then some vertices are looked at in vain.
  static std::uint64_t key(const Cell& cell)
  {
    std::uint64_t k = 0;
    for (std::int64_t x : cell) { k = k * 0x9e3779b97f4a7c15u + static_cast<std::uint64_t>(x); }
    return k;
  }

  const Triangle_surface& m_surface;
  const double m_near;
  std::unordered_map<std::uint64_t, std::vector<Index>> m_cells;
};

// The images of all vertices, or nothing if one has none, or is not the image of its image.
std::vector<Index> match_vertices(const Triangle_surface& s, const Vertex_places& places, const Point& origin,
                                  const Point& normal)
{
  std::vector<Index> image;
  for (const Point& p : s.points)
  {
    image.push_back(places.nearest(p - (2 * dot(p - origin, normal)) * normal));
    if (image.back() < 0) { return {}; }
  }
  for (Index v = 0; v < s.number_of_vertices(); ++v)
  {
    if (image[image[v]] != v) { return {}; }
  }
  return image;
}

// Completes a mirror whose vertices are known. Returns whether triangles go with them, and its line is of edges.
bool match_halfedges(const Triangle_surface& s, Mirror& m)
{
  for (Index h = 0; h < s.number_of_halfedges(); ++h)
  {
    const Index v = m.vertex[s.source(h)], w = m.vertex[s.target(h)];
    if (w == s.source(h) && v == s.target(h)) { return false; } // the plane crosses an edge
    const Index g = s.find_halfedge(w, v);
    if (g < 0 || s.apex(g) != m.vertex[s.apex(h)] || (s.opposite[g] < 0) != (s.opposite[h] < 0)) { return false; }
    m.halfedge.push_back(g);
    if (g == s.opposite[h] && h < g) { m.line.push_back(h); }
  }
  return !m.line.empty();
}

// Whether the line parts the surface into halves that are each other's images. It joins faces to their images alone, so
// one half is all that can be reached on one side.
bool parts_surface(const Triangle_surface& s, const Mirror& m)
{
  std::vector<char> is_line(s.number_of_halfedges(), 0), is_here(s.number_of_faces(), 0);
  for (Index h : m.line) { is_line[h] = is_line[s.opposite[h]] = 1; }
  std::vector<Index> stack{0};
  is_here[0] = 1;
  while (!stack.empty())
  {
    const Index f = stack.back();
    stack.pop_back();
    if (is_here[m.face(f)]) { return false; }
    for (Index h = 3 * f; h < 3 * f + 3; ++h)
    {
      const Index o = s.opposite[h];
      if (o >= 0 && !is_line[h] && !std::exchange(is_here[s.face(o)], 1)) { stack.push_back(s.face(o)); }
    }
  }
  return true;
}

std::vector<Point> candidate_normals(const Triangle_surface& s, const Point& mean)
{
  std::vector<Point> normals{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  for (const Point& p : s.points)
  {
    const Eigen::Vector3d d(p[0] - mean[0], p[1] - mean[1], p[2] - mean[2]);
    moments += d * d.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(moments);
  for (int k = 0; k < 3; ++k)
  {
    const Eigen::Vector3d n = axes.eigenvectors().col(k);
    normals.push_back({n[0], n[1], n[2]});
  }
  return normals;
}

// Vertices that may be images of each other, by their distance from the mean and how many edges they have: the smallest
// two of such classes.
std::array<std::vector<Index>, 2> smallest_classes(const Triangle_surface& s, const Point& mean, double near)
{
  std::map<std::array<std::int64_t, 2>, std::vector<Index>> classes;
  for (Index v = 0; v < s.number_of_vertices(); ++v)
  {
    std::int64_t degree = 0;
    s.for_each_outgoing(v, [&](Index) { ++degree; });
    const double away = distance(s.points[v], mean);
    if (away > 10 * near) { classes[{std::llround(away / near), degree}].push_back(v); }
  }
  std::vector<std::vector<Index>> all;
  for (auto& [key, vertices] : classes) { all.push_back(std::move(vertices)); }
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.size() < b.size(); });
  all.resize(2);
  return {all[0], all[1]};
}

// The planes that exchange the first vertex of a class with another, and that in which the first ones of both lie.
void add_normals_of_classes(const Triangle_surface& s, const Point& mean, double near, std::vector<Point>& normals)
{
  constexpr std::size_t most = 256;
  const auto add = [&](const Point& p) {
    if (norm(p) > 0) { normals.push_back((1 / norm(p)) * p); }
  };
  const auto classes = smallest_classes(s, mean, near);
  for (const std::vector<Index>& vertices : classes)
    for (std::size_t i = 1; i < std::min(vertices.size(), most); ++i)
    {
      add(s.points[vertices[i]] - s.points[vertices.front()]);
    }
  if (classes[1].empty()) { return; }
  add(cross(s.points[classes[0].front()] - mean, s.points[classes[1].front()] - mean));
}

} // namespace

} // namespace internal

std::optional<Mirror> find_mirror(const Triangle_surface& s)
{
  Bounding_box<Point> box(s.points.front());
  Point mean{0, 0, 0};
  for (const Point& p : s.points)
  {
    box.add(p);
    mean = mean + p;
  }
  mean = (1. / s.number_of_vertices()) * mean;
  constexpr double near = 1e-4;
  const double size = norm(box.high - box.low);
  std::optional<Mirror> best;
  if (!(size > 0)) { return best; }
  const internal::Vertex_places places(s, near * size);
  double shortest = std::numeric_limits<double>::infinity();
  std::vector<Point> normals = internal::candidate_normals(s, mean);
  internal::add_normals_of_classes(s, mean, near * size, normals);
  for (const Point& normal : normals)
  {
    Mirror m{mean, normal, internal::match_vertices(s, places, mean, normal), {}, {}};
    if (m.vertex.empty() || !internal::match_halfedges(s, m) || !internal::parts_surface(s, m)) { continue; }
    const double length = length_of_edges(s, m.line);
    if (!(length < shortest)) { continue; }
    shortest = length;
    best = std::move(m);
  }
  return best;
}

} // namespace meridian
