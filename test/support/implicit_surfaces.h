// Smooth surfaces of known genus, from distance functions: the shapes of the paper's figures.
#ifndef MERIDIAN_TEST_IMPLICIT_SURFACES_H
#define MERIDIAN_TEST_IMPLICIT_SURFACES_H

#include "sample_surfaces.h"

#include <meridian/base/vectors.h>
#include <meridian/surface/Triangle_surface.h>

namespace sample {

using Distance = std::function<double(const Point&)>; // below 0 inside

inline double blend(double a, double b, double width) // a smooth minimum
{
  const double h = std::max(width - std::abs(a - b), 0.) / width;
  return std::min(a, b) - h * h * width / 4;
}

inline double ring(const Point& p, double big, double small) // a torus about the z axis
{
  return std::hypot(std::hypot(p[0], p[1]) - big, p[2]) - small;
}

// Where a function with values at points vanishes, tetrahedron by tetrahedron (Bloomenthal 1994).
class Tetrahedra_contour
{
public:
  void add_point(const Point& p, double value)
  {
    m_at.push_back(p);
    m_value.push_back(value);
  }

  // `t` are four of the points, positively oriented.
  void add_tetrahedron(const std::array<int, 4>& t)
  {
    std::vector<int> in, out;
    for (int v : t) { (m_value[v] < 0 ? in : out).push_back(v); }
    const auto add = [&](Index a, Index b, Index c) {
      const auto& points = m_surface.points;
      const Point n =
        meridian::cross(meridian::operator-(points[b], points[a]), meridian::operator-(points[c], points[a]));
      if (meridian::dot(n, meridian::operator-(m_at[out[0]], m_at[in[0]])) < 0) { std::swap(b, c); }
      m_surface.triangles.push_back({a, b, c});
    };
    if (in.size() == 1) { add(cross(in[0], out[0]), cross(in[0], out[1]), cross(in[0], out[2])); }
    if (in.size() == 3) { add(cross(in[0], out[0]), cross(in[1], out[0]), cross(in[2], out[0])); }
    if (in.size() == 2)
    {
      const Index a = cross(in[0], out[0]), b = cross(in[0], out[1]), c = cross(in[1], out[1]),
                  d = cross(in[1], out[0]);
      add(a, b, c);
      add(a, c, d);
    }
  }

  Triangle_surface surface() { return connected(std::move(m_surface)); }

private:
  // The vertex on an edge of the tetrahedra.
  Index cross(int a, int b)
  {
    const int u = std::min(a, b), v = std::max(a, b);
    const auto [found, is_new] = m_vertex.try_emplace({u, v}, m_surface.number_of_vertices());
    if (is_new)
    {
      const double t = std::min(std::max(m_value[u] / (m_value[u] - m_value[v]), 0.1), 0.9);
      Point p;
      for (int k = 0; k < 3; ++k) { p[k] = m_at[u][k] + t * (m_at[v][k] - m_at[u][k]); }
      m_surface.points.push_back(p);
    }
    return found->second;
  }

  std::vector<Point> m_at;
  std::vector<double> m_value;
  std::map<std::pair<int, int>, Index> m_vertex; // on the edges that the surface crosses
  Triangle_surface m_surface;
};

// The surface on a grid of cells x cells x cells over the cube of half-width `half`. `warp` moves the points of the
// grid, for irregular sampling.
inline Triangle_surface isosurface(const Distance& f, double half, int cells,
                                   const std::function<Point(Point)>& warp = {})
{
  Tetrahedra_contour contour;
  const int n = cells + 1;
  const auto id = [&](int i, int j, int k) { return (i * n + j) * n + k; };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k)
      {
        Point p{half * (2. * i / cells - 1), half * (2. * j / cells - 1), half * (2. * k / cells - 1)};
        if (warp) { p = warp(p); }
        contour.add_point(p, f(p));
      }
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j)
      for (int k = 0; k < cells; ++k)
        for (const std::array<int, 3>& order :
             {std::array<int, 3>{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}})
        {
          std::array<int, 3> c{i, j, k};
          std::array<int, 4> t{id(i, j, k), 0, 0, 0};
          for (int step = 0; step < 3; ++step)
          {
            ++c[order[step]];
            t[step + 1] = id(c[0], c[1], c[2]);
          }
          contour.add_tetrahedron(t);
        }
  return contour.surface();
}

inline double bitorus_distance(const Point& p)
{
  return blend(ring({p[0] - 1.05, p[1], p[2]}, 0.8, 0.3), ring({p[0] + 1.05, p[1], p[2]}, 0.8, 0.3), 0.3);
}

inline Triangle_surface bitorus(int cells) { return isosurface(bitorus_distance, 2.4, cells); }

// With a handle a tenth as large as the others, on the outside of one ring.
// Moves the points of a grid along x, so that its cells become wide in places and narrow in others.
inline Point uneven(Point p)
{
  p[0] += 0.55 * std::sin(p[0] * pi / 1.2) * 1.2 / pi;
  return p;
}

inline Triangle_surface bitorus_with_tiny_handle(int cells, bool is_irregular = false)
{
  const auto f = [](const Point& p) {
    return blend(bitorus_distance(p), ring({p[2] - 0.32, p[0] - 1.85, p[1]}, 0.14, 0.055), 0.04);
  };
  return is_irregular ? isosurface(f, 2.4, cells, uneven) : isosurface(f, 2.4, cells);
}

inline Triangle_surface irregular_torus(int cells)
{
  return isosurface([](const Point& p) { return ring(p, 1.5, 0.55); }, 2.4, cells, uneven);
}

// Rings around the z axis, each joined to the next: three of them have genus 3 at a distance of 1.15, four of 1.4 genus
// 5.
inline Triangle_surface rings(int count, double away, int cells)
{
  return isosurface(
    [=](const Point& p) {
      double d = 1e9;
      for (int i = 0; i < count; ++i)
      {
        const double a = 2 * pi * i / count;
        d = blend(d, ring({p[0] - away * std::cos(a), p[1] - away * std::sin(a), p[2]}, 0.8, 0.28), 0.3);
      }
      return d;
    },
    away + 1.45, cells);
}

inline Triangle_surface three_rings(int cells) { return rings(3, 1.15, cells); }

// A body with a handle, open at the top and at the spout: genus 1, two boundary loops.
inline Triangle_surface teapot(int cells, bool is_open = true)
{
  const Triangle_surface s = isosurface(
    [](const Point& p) {
      const double body = std::sqrt(p[0] * p[0] + p[1] * p[1] + 1.3 * p[2] * p[2]) - 1.1;
      const double handle = ring({p[0] + 1.15, p[2], p[1]}, 0.55, 0.16);
      const double along = std::min(std::max((p[0] - 0.8) / 1.1, 0.), 1.);
      const double spout = std::hypot(p[0] - 0.8 - 1.1 * along, p[1], p[2] - 0.7 * along + 0.2) - 0.28 + 0.1 * along;
      return blend(blend(body, handle, 0.15), spout, 0.2);
    },
    2.3, cells);
  if (!is_open) { return s; }
  return without(s, [&](Index f) {
    const Point& p = s.points[s.triangles[f][0]];
    return (p[2] > 0.78 && std::hypot(p[0], p[1]) < 0.8) || p[0] > 1.85;
  });
}

} // namespace sample

#endif // MERIDIAN_TEST_IMPLICIT_SURFACES_H
