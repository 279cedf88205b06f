// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/field/geodesic_distance.h>

#include <meridian/base/exceptions.h>
#include <meridian/base/group_by.h>
#include <meridian/surface/shortest_ways.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace meridian {

namespace internal {

namespace {

// The system of an intrinsic triangulation on its vertices: `mass[v] x_v` plus `step` times the flow to the neighbours.
// Vertices with `is_known` have the value 0 and no equation. `weight(w)` is what stands for a cotangent weight.
std::vector<double> solve_on_vertices(const Intrinsic_triangulation& t, const std::vector<double>& mass, double step,
                                      const std::vector<char>& is_known, const std::vector<double>& right,
                                      const std::function<double(double)>& weight, Make_solver make_solver)
{
  const Index n = static_cast<Index>(mass.size());
  std::vector<Index> row(n, -1);
  Index rows = 0;
  for (Index v = 0; v < n; ++v)
  {
    if (!is_known[v]) { row[v] = rows++; }
  }
  std::vector<double> x(n, 0), diagonal = mass;
  if (rows == 0) { return x; }
  struct Link
  {
    Index row, column;
    double value;
  };
  std::vector<Link> links;
  for (Index h = 0; h < t.number_of_halfedges(); ++h)
  {
    const Index o = t.opposite[h];
    if (o >= 0 && o < h) { continue; }
    const Index u = t.source[h], v = t.target(h);
    if (u == v) { continue; }
    const double w = step * weight((t.cotangent(h) + (o < 0 ? 0 : t.cotangent(o))) / 2);
    diagonal[u] += w;
    diagonal[v] += w;
    if (row[u] < 0 || row[v] < 0) { continue; }
    links.push_back({row[u], row[v], -w});
    links.push_back({row[v], row[u], -w});
  }
  const Groups of_row = group_by(rows, static_cast<Index>(links.size()), [&](Index i) { return links[i].row; });
  Sparse_matrix a(rows, links.size() + rows);
  std::vector<double> b(rows), solution;
  for (Index v = 0; v < n; ++v)
  {
    if (row[v] < 0) { continue; }
    for (Index i = of_row.begin[row[v]]; i < of_row.begin[row[v] + 1]; ++i)
    {
      a.add(links[of_row.element[i]].column, links[of_row.element[i]].value);
    }
    a.add(row[v], diagonal[v]);
    a.end_row();
    b[row[v]] = right[v];
  }
  const auto solver = make_solver();
  bool is_solved = solver->factor(a) && solver->solve(b, solution);
  for (Index v = 0; v < n && is_solved; ++v)
  {
    if (row[v] < 0) { continue; }
    x[v] = solution[row[v]];
    is_solved = std::isfinite(x[v]);
  }
  if (!is_solved)
    throw Solver_error("the geodesic distance on " + std::to_string(n)
                       + " vertices cannot be solved for; faces of better shape would help");
  return x;
}

} // namespace

std::vector<double> edge_distances(const Intrinsic_triangulation& t, Index vertices, const std::vector<Index>& sources)
{
  const Groups leaving = group_by(vertices, t.number_of_halfedges(), [&](Index h) { return t.source[h]; });
  std::vector<std::pair<double, Index>> starts;
  for (Index v : sources) { starts.emplace_back(0., v); }
  return find_shortest_ways(vertices, starts, [&](Index v, const auto& reach) {
    for (Index i = leaving.begin[v]; i < leaving.begin[v + 1]; ++i)
    {
      // Both sides of the corner: a boundary edge has only one halfedge.
      const Index h = leaving.element[i], last = t.next[t.next[h]];
      reach(t.target(h), t.length[h]);
      reach(t.source[last], t.length[last]);
    }
  });
}

namespace {

// The heat method on an intrinsic triangulation with lengths of about 1.
class Heat_method
{
public:
  Heat_method(const Intrinsic_triangulation& t, Index vertices, const std::vector<Index>& sources,
              Make_solver make_solver)
    : m_triangulation(t), m_vertices(vertices), m_sources(sources), m_make_solver(make_solver)
  {}

  // The distances; `farthest` is about the largest.
  std::vector<double> solve(double farthest) const
  {
    std::vector<char> is_source(m_vertices, 0);
    for (Index v : m_sources) { is_source[v] = 1; }
    const std::vector<double> heat = let_heat_flow(farthest);
    return solve_on_vertices(
      m_triangulation, std::vector<double>(m_vertices, 0), 1, is_source, divergence_of_direction(heat),
      [](double w) { return w; }, m_make_solver);
  }

private:
  // `f` gets the three halfedges of each face.
  template <class Function> void for_each_face(const Function& f) const
  {
    const Intrinsic_triangulation& t = m_triangulation;
    std::vector<char> is_seen(t.number_of_halfedges(), 0);
    for (Index h = 0; h < t.number_of_halfedges(); ++h)
    {
      if (is_seen[h]) { continue; }
      is_seen[t.next[h]] = is_seen[t.next[t.next[h]]] = 1;
      f(std::array<Index, 3>{h, t.next[h], t.next[t.next[h]]});
    }
  }

  // Obtuse angles across from the boundary have negative weights. Heat must stay positive.
  // At a distance d it is about e^(-d / reach), in the range of double up to 700 times the reach.
  std::vector<double> let_heat_flow(double farthest) const
  {
    const Intrinsic_triangulation& t = m_triangulation;
    std::vector<double> heat, mass(m_vertices, 0), right(m_vertices, 0);
    for (Index v : m_sources) { right[v] = 1; }
    for_each_face([&](const std::array<Index, 3>& side) {
      for (Index h : side) { mass[t.source[h]] += t.area(side[0]) / 3; }
    });
    double reach = std::max(1., farthest / 1000);
    for (int attempt = 0; attempt == 0 || (attempt < 8 && *std::min_element(heat.begin(), heat.end()) < 1e-290);
         ++attempt, reach *= 2)
      heat = solve_on_vertices(
        t, mass, reach * reach, std::vector<char>(m_vertices, 0), right, [](double w) { return std::max(w, 0.); },
        m_make_solver);
    return heat;
  }

  // The gradient of heat, turned round and brought to unit length, as what flows to each vertex.
  std::vector<double> divergence_of_direction(const std::vector<double>& heat) const
  {
    const Intrinsic_triangulation& t = m_triangulation;
    std::vector<double> right(m_vertices, 0);
    for_each_face([&](const std::array<Index, 3>& side) {
      // Twice the area times the gradient of the function that is 1 at a corner: the side across, turned by a right
      // angle.
      const double l = t.length[side[0]];
      const auto p = t.corner(side[0]);
      const std::array<std::array<double, 2>, 3> turned{{{-p[1], p[0] - l}, {p[1], -p[0]}, {0, l}}};
      double hottest = 0, x = 0, y = 0;
      for (Index h : side) { hottest = std::max(hottest, heat[t.source[h]]); }
      if (!(hottest > 0)) { return; }
      for (int k = 0; k < 3; ++k)
      {
        x -= heat[t.source[side[k]]] / hottest * turned[k][0];
        y -= heat[t.source[side[k]]] / hottest * turned[k][1];
      }
      const double size = std::sqrt(x * x + y * y);
      if (!(size > 0)) { return; }
      for (int k = 0; k < 3; ++k) { right[t.source[side[k]]] += (x * turned[k][0] + y * turned[k][1]) / (2 * size); }
    });
    return right;
  }

  const Intrinsic_triangulation& m_triangulation;
  Index m_vertices;
  const std::vector<Index>& m_sources;
  Make_solver m_make_solver;
};

} // namespace

} // namespace internal

std::vector<double> geodesic_distance(const Triangle_surface& s, const std::vector<Index>& sources,
                                      Make_solver make_solver)
{
  if (sources.empty()) { throw Invalid_input_error("a distance needs at least one vertex to start from"); }
  const Index n = s.number_of_vertices();
  Intrinsic_triangulation t = make_intrinsic_delaunay(s);
  const double unit =
    std::accumulate(t.length.begin(), t.length.end(), 0.) / std::max<Index>(t.number_of_halfedges(), 1);
  for (double& x : t.length) { x /= unit; }
  const std::vector<double> path = internal::edge_distances(t, n, sources);
  const double farthest = *std::max_element(path.begin(), path.end());
  if (!std::isfinite(farthest))
    throw Solver_error(
      "the geodesic distance is not finite: the surface is not connected or its coordinates are out of range");
  std::vector<double> d = internal::Heat_method(t, n, sources, make_solver).solve(farthest);
  for (double& x : d) { x = unit * std::max(x, 0.); }
  return d;
}

} // namespace meridian
