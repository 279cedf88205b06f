// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/unwrap/compare_maps.h>

#include "bound_spectral_norm.h"

#include <meridian/base/exceptions.h>
#include <meridian/base/vectors.h>
#include <meridian/map/distortion.h>
#include <meridian/map/planar_map.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/measures.h>
#include <meridian/unwrap/internal/untouched_stars.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace meridian {

namespace {

// The rows J of a surface's Laplacian: the columns J as a matrix, the others as a list.
class Untouched_rows
{
public:
  using Columns = Eigen::Matrix<double, Eigen::Dynamic, 2>;

  Untouched_rows(const Triangle_surface& root, const std::vector<double>& weights, const std::vector<Index>& untouched)
    : m_untouched(untouched), m_inside(untouched.size(), untouched.size())
  {
    std::vector<Index> row(root.number_of_vertices(), -1);
    for (std::size_t i = 0; i < untouched.size(); ++i) { row[untouched[i]] = static_cast<Index>(i); }
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t i = 0; i < untouched.size(); ++i)
    {
      double diagonal = 0;
      root.for_each_outgoing(untouched[i], [&](Index h) {
        const Index w = root.target(h);
        diagonal += weights[h];
        if (row[w] >= 0) { entries.emplace_back(static_cast<Index>(i), row[w], -weights[h]); }
        else { m_outside.push_back({static_cast<Index>(i), w, -weights[h]}); }
      });
      entries.emplace_back(static_cast<Index>(i), static_cast<Index>(i), diagonal);
    }
    m_inside.setFromTriplets(entries.begin(), entries.end());
  }
  const Eigen::SparseMatrix<double>& inside() const { return m_inside; }

  Columns values(const std::vector<Plane_point>& at) const // x_J
  {
    Columns x(m_untouched.size(), 2);
    for (std::size_t i = 0; i < m_untouched.size(); ++i)
      for (int k = 0; k < 2; ++k) { x(i, k) = at[m_untouched[i]][k]; }
    return x;
  }
  Columns right_side(const std::vector<Plane_point>& at) const // b
  {
    Columns b = Columns::Zero(m_untouched.size(), 2);
    for (const Entry& e : m_outside)
      for (int k = 0; k < 2; ++k) { b(e.row, k) -= e.weight * at[e.vertex][k]; }
    return b;
  }

private:
  struct Entry
  {
    Index row, vertex;
    double weight;
  };
  const std::vector<Index>& m_untouched;
  Eigen::SparseMatrix<double> m_inside;
  std::vector<Entry> m_outside;
};

// Scales a map to an area and brings the centroid of the given vertices to the origin.
void scale_and_center(const Triangle_surface& disc, double area, const std::vector<Index>& vertices,
                      std::vector<Plane_point>& at)
{
  const double image = area_of(disc.triangles, at);
  if (!(image > 0)) { throw Invalid_input_error("compare_maps: the image of a map has no positive area"); }
  const double factor = std::sqrt(area / image);
  for (Plane_point& p : at) { p = factor * p; }
  Plane_point centroid{0, 0};
  for (Index v : vertices) { centroid = centroid + (1. / static_cast<double>(vertices.size())) * at[v]; }
  for (Plane_point& p : at) { p = p - centroid; }
}

// Turns the second map about the origin so that the sum of the squared distances at the given vertices is least.
void turn_onto(const std::vector<Plane_point>& first, const std::vector<Index>& vertices,
               std::vector<Plane_point>& second)
{
  double c = 0, s = 0;
  for (Index v : vertices)
  {
    c += dot(second[v], first[v]);
    s += cross(second[v], first[v]);
  }
  const double length = std::hypot(c, s);
  if (!(length > 0)) { return; }
  c /= length;
  s /= length;
  for (Plane_point& p : second) { p = {c * p[0] - s * p[1], s * p[0] + c * p[1]}; }
}

} // namespace

std::vector<Index> find_untouched_vertices(const Triangle_surface& root, const Cut_disc& first, const Cut_disc& second)
{
  const Index n = root.number_of_vertices();
  for (const Cut_disc* d : {&first, &second})
    if (d->is_touched.size() != root.points.size() || d->disc.number_of_vertices() < n)
      throw Invalid_input_error("find_untouched_vertices: a disc does not have the vertices of the surface");
  std::vector<char> is_near(n, 0), is_excluded(n, 0); // within one edge, within two
  const auto spread = [&](const std::vector<char>& from, std::vector<char>& to) {
    for (const auto& t : root.triangles)
    {
      if (from[t[0]] || from[t[1]] || from[t[2]]) { to[t[0]] = to[t[1]] = to[t[2]] = 1; }
    }
  };
  std::vector<char> is_start(n, 0);
  for (Index v = 0; v < n; ++v) { is_start[v] = first.is_touched[v] || second.is_touched[v]; }
  spread(is_start, is_near);
  for (Index v = 0; v < n; ++v)
  {
    if (root.outgoing[v] < 0 || root.is_boundary_vertex(v)) { is_near[v] = 1; }
  }
  spread(is_near, is_excluded);
  std::vector<Index> untouched;
  for (Index v = 0; v < n; ++v)
  {
    if (!is_excluded[v] && root.outgoing[v] >= 0) { untouched.push_back(v); }
  }
  return untouched;
}

double laplacian_residual(const Triangle_surface& root, const std::vector<double>& weights,
                          const std::vector<Index>& untouched, const std::vector<Plane_point>& at)
{
  double square = 0;
  for (Index v : untouched)
  {
    Plane_point sum{0, 0};
    root.for_each_outgoing(v, [&](Index h) { sum = sum + weights[h] * (at[v] - at[root.target(h)]); });
    square += dot(sum, sum);
  }
  return std::sqrt(square);
}

Map_comparison compare_maps(const Triangle_surface& root, const Cut_disc& first, const Cut_disc& second,
                            const std::vector<double>& weights, std::array<std::vector<Plane_point>, 2> at)
{
  Map_comparison c;
  c.untouched = find_untouched_vertices(root, first, second);
  const double surface = area(root);
  if (!(surface > 0)) { throw Invalid_input_error("compare_maps: the surface has no area"); }
  c.diameter = 2 * std::sqrt(surface / std::acos(-1.));
  c.at = std::move(at);
  const std::array<const Triangle_surface*, 2> discs{&first.disc, &second.disc};
  for (int i = 0; i < 2; ++i)
  {
    if (c.at[i].size() != discs[i]->points.size())
    {
      throw Invalid_input_error("compare_maps: a map does not have one image for each vertex of its disc");
    }
    internal::check_stars(root, *discs[i], c.untouched);
    scale_and_center(*discs[i], surface, c.untouched, c.at[i]);
  }
  turn_onto(c.at[0], c.untouched, c.at[1]);
  for (int i = 0; i < 2; ++i)
  {
    c.distortion[i] = measure_distortion(discs[i]->points, discs[i]->triangles, c.at[i],
                                         measure_faces(discs[i]->points, discs[i]->triangles, c.at[i]));
    c.flipped[i] = static_cast<Index>(find_flipped_faces(discs[i]->triangles, c.at[i]).size());
  }
  if (c.untouched.empty()) { return c; }

  const Untouched_rows rows(root, weights, c.untouched);
  c.norm = internal::bound_spectral_norm(rows.inside());
  c.variation = (rows.values(c.at[0]) - rows.values(c.at[1])).norm();
  c.discrepancy = (rows.right_side(c.at[0]) - rows.right_side(c.at[1])).norm();
  std::vector<char> is_counted(root.number_of_vertices(), 0);
  for (Index v : c.untouched)
  {
    root.for_each_outgoing(v, [&](Index h) { is_counted[v] = is_counted[root.target(h)] = 1; });
  }
  double allowance = 0;
  for (int i = 0; i < 2; ++i)
  {
    double square = 0;
    for (Index v = 0; v < root.number_of_vertices(); ++v)
    {
      if (is_counted[v]) { square += dot(c.at[i][v], c.at[i][v]); }
    }
    const double scale = c.norm * std::sqrt(square), residual = laplacian_residual(root, weights, c.untouched, c.at[i]);
    if (scale > 0) { c.residual[i] = residual / scale; }
    allowance += 2 * residual + 8 * std::numeric_limits<double>::epsilon() * scale;
  }
  if (c.norm > 0) { c.bound = std::max(c.discrepancy - allowance, 0.) / c.norm; }
  const double unit = std::sqrt(static_cast<double>(c.untouched.size())) * c.diameter;
  c.relative_variation = c.variation / unit;
  c.relative_bound = c.bound / unit;
  return c;
}

} // namespace meridian
