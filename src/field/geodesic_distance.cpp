// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/field/geodesic_distance.h>

#include <meridian/base/exceptions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>
#include <string>
#include <utility>

namespace meridian {

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
  Sparse_matrix a(rows);
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
    a.add(row[u], row[v], -w);
    a.add(row[v], row[u], -w);
  }
  std::vector<double> b(rows), solution;
  for (Index v = 0; v < n; ++v)
  {
    if (row[v] < 0) { continue; }
    a.add(row[v], row[v], diagonal[v]);
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

namespace internal {

std::vector<double> edge_distances(const Intrinsic_triangulation& t, Index vertices, const std::vector<Index>& sources)
{
  std::vector<Index> begin(vertices + 1, 0), leaving(t.number_of_halfedges());
  for (Index h = 0; h < t.number_of_halfedges(); ++h) { ++begin[t.source[h] + 1]; }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<Index> fill(begin.begin(), begin.end() - 1);
  for (Index h = 0; h < t.number_of_halfedges(); ++h) { leaving[fill[t.source[h]]++] = h; }

  std::vector<double> d(vertices, std::numeric_limits<double>::infinity());
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  const auto reach = [&](Index v, double at) {
    if (!(at < d[v])) { return; }
    d[v] = at;
    queue.emplace(at, v);
  };
  for (Index v : sources) { reach(v, 0); }
  while (!queue.empty())
  {
    const auto [at, v] = queue.top();
    queue.pop();
    if (at > d[v]) { continue; }
    for (Index i = begin[v]; i < begin[v + 1]; ++i)
    {
      // Both sides of the corner: a boundary edge has only one halfedge.
      const Index h = leaving[i], last = t.next[t.next[h]];
      reach(t.target(h), at + t.length[h]);
      reach(t.source[last], at + t.length[last]);
    }
  }
  return d;
}

} // namespace internal

std::vector<double> geodesic_distance(const Triangle_surface& s, const std::vector<Index>& sources,
                                      Make_solver make_solver)
{
  if (sources.empty()) { throw Invalid_input_error("a distance needs at least one vertex to start from"); }
  const Index n = s.number_of_vertices();
  Intrinsic_triangulation t = make_intrinsic_delaunay(s);
  const Index halfedges = t.number_of_halfedges();
  double unit = std::accumulate(t.length.begin(), t.length.end(), 0.) / std::max<Index>(halfedges, 1);
  for (double& x : t.length) { x /= unit; }

  const std::vector<double> path = internal::edge_distances(t, n, sources);
  const double farthest = *std::max_element(path.begin(), path.end());
  if (!std::isfinite(farthest))
    throw Solver_error(
      "the geodesic distance is not finite: the surface is not connected or its coordinates are out of range");
  std::vector<char> is_source(n, 0);
  std::vector<double> mass(n, 0), right(n, 0);
  for (Index v : sources)
  {
    is_source[v] = 1;
    right[v] = 1;
  }
  const auto for_each_face = [&](const auto& f) { // `f` gets the first of the three halfedges
    std::vector<char> is_seen(halfedges, 0);
    for (Index h = 0; h < halfedges; ++h)
    {
      if (is_seen[h]) { continue; }
      is_seen[t.next[h]] = is_seen[t.next[t.next[h]]] = 1;
      f(std::array<Index, 3>{h, t.next[h], t.next[t.next[h]]});
    }
  };
  for_each_face([&](const std::array<Index, 3>& side) {
    for (Index h : side) { mass[t.source[h]] += t.area(side[0]) / 3; }
  });
  // Obtuse angles across from the boundary have negative weights. Heat must stay positive.
  // At a distance d it is about e^(-d / reach), in the range of double up to 700 times the reach.
  std::vector<double> heat;
  double reach = std::max(1., farthest / 1000);
  for (int attempt = 0; attempt == 0 || (attempt < 8 && *std::min_element(heat.begin(), heat.end()) < 1e-290);
       ++attempt, reach *= 2)
    heat = solve_on_vertices(
      t, mass, reach * reach, std::vector<char>(n, 0), right, [](double w) { return std::max(w, 0.); }, make_solver);

  std::fill(right.begin(), right.end(), 0);
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
  std::vector<double> d = solve_on_vertices(
    t, std::vector<double>(n, 0), 1, is_source, right, [](double w) { return w; }, make_solver);
  for (double& x : d) { x = unit * std::max(x, 0.); }
  return d;
}

} // namespace meridian
