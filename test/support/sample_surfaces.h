// Surfaces with a known topology, built in code so that a test names what it needs.
#ifndef MERIDIAN_TEST_SAMPLE_SURFACES_H
#define MERIDIAN_TEST_SAMPLE_SURFACES_H

#include <meridian/base/Polygon_soup.h>
#include <meridian/base/vectors.h>
#include <meridian/surface/Surface_curve.h>
#include <meridian/surface/Triangle_surface.h>

#include <algorithm>
#include <functional>
#include <map>
#include <random>

namespace sample {

using meridian::Index;
using meridian::Point;
using meridian::Triangle_surface;
using meridian::operator+;
using meridian::operator*;
constexpr double pi = 3.14159265358979323846;

inline Triangle_surface connected(Triangle_surface s)
{
  meridian::connect(s);
  return s;
}

// The skin of a set of unit cubes, each side divided into k x k squares. The set must have no cubes that touch only
// along an edge or at a corner.
inline Triangle_surface skin(std::array<int, 3> size, const std::function<bool(int, int, int)>& is_filled, int k = 1)
{
  Triangle_surface s;
  std::map<std::array<int, 3>, Index> index;
  const auto filled = [&](const std::array<int, 3>& c) {
    for (int a = 0; a < 3; ++a)
    {
      if (c[a] < 0 || c[a] >= size[a]) { return false; }
    }
    return is_filled(c[0], c[1], c[2]);
  };
  const auto corner = [&](const std::array<int, 3>& c) {
    const auto [at, is_new] = index.try_emplace(c, s.number_of_vertices());
    if (is_new) { s.points.push_back({c[0] / double(k), c[1] / double(k), c[2] / double(k)}); }
    return at->second;
  };
  std::array<int, 3> c;
  for (c[0] = 0; c[0] < size[0]; ++c[0])
    for (c[1] = 0; c[1] < size[1]; ++c[1])
      for (c[2] = 0; c[2] < size[2]; ++c[2])
        for (int axis = 0; axis < 3 && filled(c); ++axis)
          for (int side = 0; side < 2; ++side)
          {
            std::array<int, 3> beyond = c;
            beyond[axis] += side ? 1 : -1;
            if (filled(beyond)) { continue; }
            const int a = (axis + 1) % 3, b = (axis + 2) % 3;
            for (int i = 0; i < k; ++i)
              for (int j = 0; j < k; ++j)
              {
                std::array<Index, 4> q;
                for (int n = 0; n < 4; ++n)
                {
                  std::array<int, 3> p;
                  p[axis] = (c[axis] + side) * k;
                  p[a] = c[a] * k + i + (n == 1 || n == 2);
                  p[b] = c[b] * k + j + (n == 2 || n == 3);
                  q[side ? n : 3 - n] = corner(p); // outward on both sides
                }
                s.triangles.push_back({q[0], q[1], q[2]});
                s.triangles.push_back({q[0], q[2], q[3]});
              }
          }
  return connected(std::move(s));
}

// A closed surface of the given genus: a plate with one hole a handle.
inline Triangle_surface plate(int genus, int k = 2)
{
  return skin(
    {2 * genus + 1, 3, 1}, [](int i, int j, int) { return i % 2 == 0 || j != 1; }, k);
}

// A grid of n x m squares, mapped into space by f.
template <class Function> Triangle_surface sheet(int n, int m, const Function& f)
{
  Triangle_surface s;
  for (int j = 0; j <= m; ++j)
  {
    for (int i = 0; i <= n; ++i) { s.points.push_back(f(i / double(n), j / double(m))); }
  }
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < n; ++i)
    {
      const Index p = j * (n + 1) + i, q = p + n + 1;
      s.triangles.push_back({p, p + 1, q + 1});
      s.triangles.push_back({p, q + 1, q});
    }
  return connected(std::move(s));
}

// A torus of n x m quadrilaterals about the z axis.
inline Triangle_surface torus(int n, int m, double big = 3, double small = 1)
{
  Triangle_surface s;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j)
    {
      const double u = 2 * pi * i / n, v = 2 * pi * j / m, r = big + small * std::cos(v);
      s.points.push_back({r * std::cos(u), r * std::sin(u), small * std::sin(v)});
      const Index p = i * m + j, q = (i + 1) % n * m + j, t = (i + 1) % n * m + (j + 1) % m, w = i * m + (j + 1) % m;
      s.triangles.push_back({p, q, t});
      s.triangles.push_back({p, t, w});
    }
  return connected(std::move(s));
}

// A tube of radius 1 with one end open, and a step of a quarter along it.
inline Triangle_surface tube_with_cap(int around, int along)
{
  Triangle_surface s;
  for (int j = 0; j < along; ++j)
    for (int i = 0; i < around; ++i)
    {
      s.points.push_back({std::cos(2 * pi * i / around), std::sin(2 * pi * i / around), 0.25 * j});
    }
  const auto at = [&](int i, int j) { return j * around + i % around; };
  for (int j = 0; j + 1 < along; ++j)
    for (int i = 0; i < around; ++i)
    {
      s.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      s.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  s.points.push_back({0, 0, 0.25 * along});
  for (int i = 0; i < around; ++i) { s.triangles.push_back({at(i, along - 1), at(i + 1, along - 1), around * along}); }
  return connected(std::move(s));
}

// A torus, with two thorns; by themselves, ten times as long as its tube is wide.
inline Triangle_surface thorny_torus(double length = 20)
{
  auto s = torus(80, 40);
  for (const Point& thorn : {Point{4, 0, 0}, Point{-4, 0, 0}})
    for (Point& p : s.points)
    {
      const double away = distance(p, thorn);
      if (away < 0.6) { p = p + (length * (1 - away / 0.6) / 4) * thorn; }
    }
  return s;
}

// A sphere: an octahedron divided `levels` times.
inline Triangle_surface sphere(int levels)
{
  Triangle_surface s;
  s.points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  s.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int l = 0; l < levels; ++l)
  {
    std::map<std::pair<Index, Index>, Index> middle;
    const auto mid = [&](Index a, Index b) {
      const auto [at, is_new] = middle.try_emplace({std::min(a, b), std::max(a, b)}, s.number_of_vertices());
      if (is_new)
      {
        const Point p = s.points[a] + s.points[b];
        s.points.push_back((1 / meridian::norm(p)) * p);
      }
      return at->second;
    };
    std::vector<std::array<Index, 3>> next;
    for (const auto& t : s.triangles)
    {
      const Index a = mid(t[0], t[1]), b = mid(t[1], t[2]), c = mid(t[2], t[0]);
      for (const std::array<Index, 3>& u : {std::array<Index, 3>{t[0], a, c}, {t[1], b, a}, {t[2], c, b}, {a, b, c}})
      {
        next.push_back(u);
      }
    }
    s.triangles = next;
  }
  return connected(std::move(s));
}

// Every triangle divided into four, straight.
inline Triangle_surface subdivided(const Triangle_surface& from)
{
  Triangle_surface s;
  s.points = from.points;
  std::vector<Index> middle(from.number_of_halfedges());
  for (Index h = 0; h < from.number_of_halfedges(); ++h)
  {
    if (from.edge(h) != h)
    {
      middle[h] = middle[from.edge(h)];
      continue;
    }
    middle[h] = s.number_of_vertices();
    s.points.push_back(from.point_on(h, 0.5));
  }
  for (Index f = 0; f < from.number_of_faces(); ++f)
  {
    const auto& t = from.triangles[f];
    const Index a = middle[3 * f], b = middle[3 * f + 1], c = middle[3 * f + 2];
    for (const std::array<Index, 3>& u : {std::array<Index, 3>{t[0], a, c}, {t[1], b, a}, {t[2], c, b}, {a, b, c}})
    {
      s.triangles.push_back(u);
    }
  }
  return connected(std::move(s));
}

// The surface without the faces that `is_removed` names, and without the vertices that this leaves alone. What is
// removed must leave a manifold.
inline Triangle_surface without(const Triangle_surface& from, const std::function<bool(Index)>& is_removed)
{
  Triangle_surface s;
  std::vector<Index> number(from.number_of_vertices(), -1);
  for (Index f = 0; f < from.number_of_faces(); ++f)
  {
    if (is_removed(f)) { continue; }
    s.triangles.push_back(from.triangles[f]);
    for (Index& v : s.triangles.back())
    {
      if (number[v] < 0)
      {
        number[v] = s.number_of_vertices();
        s.points.push_back(from.points[v]);
      }
      v = number[v];
    }
  }
  return connected(std::move(s));
}

// The surface without the faces around some vertices, none next to another: one boundary loop each.
inline Triangle_surface punctured(const Triangle_surface& from, const std::vector<Index>& vertices)
{
  std::vector<char> removed(from.number_of_faces(), 0);
  for (Index v : vertices)
  {
    from.for_each_outgoing(v, [&](Index h) { removed[from.face(h)] = 1; });
  }
  return without(from, [&](Index f) { return removed[f] != 0; });
}

// The same surface with other numbers for vertices and faces.
inline Triangle_surface renumbered(const Triangle_surface& from, unsigned seed)
{
  std::mt19937 random(seed);
  const auto shuffled = [&](Index n) {
    std::vector<Index> p(n);
    for (Index i = 0; i < n; ++i) { p[i] = i; }
    for (Index i = n; i-- > 1;) { std::swap(p[i], p[random() % (i + 1)]); }
    return p;
  };
  const auto vertex = shuffled(from.number_of_vertices()), face = shuffled(from.number_of_faces());
  Triangle_surface s;
  s.points.resize(from.points.size());
  s.triangles.resize(from.triangles.size());
  for (Index v = 0; v < from.number_of_vertices(); ++v) { s.points[vertex[v]] = from.points[v]; }
  for (Index f = 0; f < from.number_of_faces(); ++f)
  {
    const auto& t = from.triangles[f];
    s.triangles[face[f]] = {vertex[t[0]], vertex[t[1]], vertex[t[2]]};
  }
  return connected(std::move(s));
}

inline Triangle_surface scaled(Triangle_surface s, double factor)
{
  for (Point& p : s.points) { p = factor * p; }
  return s;
}

inline Triangle_surface mirrored(Triangle_surface s)
{
  for (Point& p : s.points) { p[0] = -p[0]; }
  for (auto& t : s.triangles) { std::swap(t[1], t[2]); }
  return connected(std::move(s));
}

// Vertices moved at random, so that no two lengths are equal.
inline Triangle_surface noisy(Triangle_surface s, double amount, unsigned seed)
{
  std::mt19937 random(seed);
  for (Point& p : s.points)
    for (double& x : p) { x += amount * (static_cast<double>(random()) / 4294967296. - 0.5); }
  return s;
}

// For each angle about the x axis the one of some vertices that is nearest to it.
inline std::vector<Index> match_by_angle(const std::vector<double>& angle, const std::vector<Index>& vertices,
                                         const std::vector<Point>& points)
{
  const auto distance_to = [&](double a, Index v) {
    return std::abs(std::remainder(std::atan2(points[v][2], points[v][1]) - a, 2 * pi));
  };
  std::vector<Index> matched;
  for (double a : angle)
  {
    matched.push_back(*std::min_element(vertices.begin(), vertices.end(),
                                        [&](Index v, Index w) { return distance_to(a, v) < distance_to(a, w); }));
  }
  return matched;
}

// A closed curve around a vertex, through all edges at it.
inline meridian::Surface_curve ring(const Triangle_surface& s, Index v, double t)
{
  meridian::Surface_curve c;
  c.closed = true;
  s.for_each_outgoing(v, [&](Index h) { c.points.push_back(meridian::Curve_point::on_edge(s.opposite[h], 1 - t)); });
  return c;
}

// Two tori joined by a tube of radius 1 and the given length. Vertices of the first torus come first; both are alike,
// n x 24 quadrilaterals each.
inline Triangle_surface dumbbell(double tube_length, int n = 48)
{
  constexpr int m = 24, ring = 16; // the hole in each torus is 4 x 4 quadrilaterals
  const Triangle_surface one = torus(n, m, 4, 2);
  const auto is_hole = [&](Index f) {
    const int i = f / 2 / m, j = f / 2 % m;
    return (i < 2 || i >= n - 2) && (j < 2 || j >= m - 2);
  };
  const Triangle_surface open = without(one, is_hole);
  const std::vector<Index> loop = meridian::boundary_loops(open).front();
  Triangle_surface s = open;
  const double far = 6 + 2 + tube_length; // the torus reaches to x = 6
  // The other half is turned by half a turn about the axis through the middle of the tube, along z.
  const Index other = open.number_of_vertices();
  for (const Point& p : open.points) { s.points.push_back({2 + far + 6 - p[0], -p[1], p[2]}); }
  for (const auto& t : open.triangles) { s.triangles.push_back({t[0] + other, t[1] + other, t[2] + other}); }
  std::vector<Index> last;
  for (Index h : loop) { last.push_back(open.source(h)); }
  std::vector<double> angle;
  for (Index v : last) { angle.push_back(std::atan2(s.points[v][2], s.points[v][1])); }
  // Along the loop the surface is on the left; the tube continues it on the right.
  const auto band = [&](const std::vector<Index>& a, const std::vector<Index>& b) {
    for (int i = 0; i < ring; ++i)
    {
      const int j = (i + 1) % ring;
      s.triangles.push_back({a[j], a[i], b[i]});
      s.triangles.push_back({a[j], b[i], b[j]});
    }
  };
  const double step = 2 * pi / ring;
  const int rings = static_cast<int>(tube_length / step) + 1;
  for (int k = 0; k <= rings; ++k)
  {
    std::vector<Index> next;
    for (int i = 0; i < ring; ++i)
    {
      next.push_back(s.number_of_vertices());
      s.points.push_back({8 + tube_length * k / rings, std::cos(angle[i]), std::sin(angle[i])});
    }
    band(last, next);
    last = next;
  }
  // The loop of the other torus runs the other way about the axis: match by angle.
  std::vector<Index> others;
  for (Index h : loop) { others.push_back(open.source(h) + other); }
  band(last, match_by_angle(angle, others, s.points));
  return connected(std::move(s));
}

// A tube of n x m quadrilaterals around a closed curve; no direction of the curve may be the z axis.
template <class Curve> Triangle_surface tube(int n, int m, double radius, const Curve& curve)
{
  using meridian::operator+;
  using meridian::operator-;
  using meridian::operator*;
  Triangle_surface s;
  for (int i = 0; i < n; ++i)
  {
    const double t = 2 * pi * i / n, step = 1e-4;
    const Point at = curve(t), ahead = curve(t + step) - curve(t - step);
    const Point along = (1 / meridian::norm(ahead)) * ahead;
    Point side = meridian::cross({0, 0, 1}, along);
    side = (1 / meridian::norm(side)) * side;
    const Point up = meridian::cross(along, side);
    for (int j = 0; j < m; ++j)
    {
      const double v = 2 * pi * j / m;
      s.points.push_back(at + radius * (std::cos(v) * side + std::sin(v) * up));
      const Index p = i * m + j, q = (i + 1) % n * m + j, u = (i + 1) % n * m + (j + 1) % m, w = i * m + (j + 1) % m;
      s.triangles.push_back({p, q, u});
      s.triangles.push_back({p, u, w});
    }
  }
  return connected(std::move(s));
}

// The curve of a trefoil knot.
inline Point trefoil(double t)
{
  return {std::sin(t) + 2 * std::sin(2 * t), std::cos(t) - 2 * std::cos(2 * t), -std::sin(3 * t)};
}

// Turned about the x and then about the z axis.
inline Triangle_surface rotated(Triangle_surface s, double a, double b)
{
  for (Point& p : s.points)
  {
    p = {p[0], std::cos(a) * p[1] - std::sin(a) * p[2], std::sin(a) * p[1] + std::cos(a) * p[2]};
    p = {std::cos(b) * p[0] - std::sin(b) * p[1], std::sin(b) * p[0] + std::cos(b) * p[1], p[2]};
  }
  return s;
}

inline meridian::Polygon_soup soup(const Triangle_surface& s)
{
  meridian::Polygon_soup soup;
  soup.points = s.points;
  for (const auto& t : s.triangles) { soup.add_polygon(t.data(), 3); }
  return soup;
}

inline int euler_characteristic(const Triangle_surface& s)
{
  return s.number_of_vertices() - s.number_of_edges() + s.number_of_faces();
}

} // namespace sample

#endif // MERIDIAN_TEST_SAMPLE_SURFACES_H
