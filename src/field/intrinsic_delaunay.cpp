// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/field/intrinsic_delaunay.h>

#include <meridian/base/group_by.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>
#include <numeric>
#include <utility>
#include <vector>

namespace meridian {

double Intrinsic_triangulation::area(Index h) const
{
  double a = length[h], b = length[next[h]], c = length[next[next[h]]];
  if (a < b) { std::swap(a, b); }
  if (b < c) { std::swap(b, c); }
  if (a < b) { std::swap(a, b); }
  b /= a; // far from the ends of the range of double
  c /= a;
  const double square = (1 + (b + c)) * (c - (1 - b)) * (c + (1 - b)) * (1 + (b - c));
  return a * a * std::max(std::sqrt(std::max(square, 0.)) / 4, 1e-8); // flips may lose what was added to lengths
}

std::array<double, 2> Intrinsic_triangulation::corner(Index h) const
{
  const double a = length[h], b = length[next[h]], c = length[next[next[h]]];
  return {(a * a + (c - b) * (c + b)) / (2 * a), 2 * area(h) / a};
}

double Intrinsic_triangulation::cotangent(Index h) const
{
  const double a = length[h], b = length[next[h]], c = length[next[next[h]]];
  return (b * b + c * c - a * a) / (4 * area(h));
}

Intrinsic_triangulation make_intrinsic_delaunay(const Triangle_surface& s)
{
  const Index n = s.number_of_halfedges();
  Intrinsic_triangulation t;
  t.opposite = s.opposite;
  for (Index h = 0; h < n; ++h)
  {
    t.next.push_back(s.next(h));
    t.source.push_back(s.source(h));
    t.length.push_back(s.length(s.edge(h))); // the same bits for twins
  }
  double mean = std::accumulate(t.length.begin(), t.length.end(), 0.) / std::max<Index>(n, 1);
  if (!(mean > 0)) { mean = 1; }
  const double margin = 1e-6 * mean;
  for (double& x : t.length) { x = std::max(x, margin); }
  double growth = 0;
  for (Index h = 0; h < n; ++h)
    growth = std::max(growth, margin - (t.length[s.next(h)] + t.length[s.prev(h)] - t.length[h]));
  for (double& x : t.length) { x += growth; }

  std::deque<Index> queue;
  std::vector<char> is_queued(n, 0);
  const auto add = [&](Index h) {
    if (t.opposite[h] < 0) { return; }
    const Index e = std::min(h, t.opposite[h]);
    if (!is_queued[e]) { queue.push_back(e); }
    is_queued[e] = 1;
  };
  for (Index h = 0; h < n; ++h) { add(h); }
  for (std::int64_t left = 50 * static_cast<std::int64_t>(n); !queue.empty() && left > 0;)
  {
    const Index h = queue.front(), o = t.opposite[h];
    queue.pop_front();
    is_queued[h] = 0;
    const Index h1 = t.next[h], h2 = t.next[h1], o1 = t.next[o], o2 = t.next[o1];
    if (o == h1 || o == h2) { continue; } // two angles of one face
    const double a = t.cotangent(h), b = t.cotangent(o);
    if (!(a + b < -1e-10 * (1 + std::abs(a) + std::abs(b)))) { continue; }
    // The two faces side by side in the plane; the one below is turned by half a turn.
    const auto above = t.corner(h), below = t.corner(o);
    const double x = above[0] + below[0] - t.length[h], y = above[1] + below[1];
    t.length[h] = t.length[o] = std::max(std::sqrt(x * x + y * y), margin);
    const auto join = [&](Index i, Index j, Index k) {
      t.next[i] = j;
      t.next[j] = k;
      t.next[k] = i;
    };
    t.source[h] = t.source[h2];
    t.source[o] = t.source[o2];
    join(h, o2, h1);
    join(o, h2, o1);
    for (Index k : {h1, h2, o1, o2}) { add(k); }
    --left;
  }
  return t;
}

Weighted_graph make_weighted_graph(const Triangle_surface& s, const Intrinsic_triangulation& t)
{
  Weighted_graph result;
  Closed_model& g = result.graph;
  g = make_closed_model(s);
  const Index n = t.number_of_halfedges();
  result.weights.assign(n, 0);
  const auto is_edge = [&](Index h) { return t.opposite[h] >= 0 && g.node[t.source[h]] != g.node[t.target(h)]; };
  double sum = 0;
  Index count = 0;
  for (Index h = 0; h < n; ++h)
  {
    if (!is_edge(h)) { continue; }
    const Index e = std::min(h, t.opposite[h]), o = std::max(h, t.opposite[h]);
    result.weights[h] = std::max((t.cotangent(e) + t.cotangent(o)) / 2, 0.);
    sum += result.weights[h];
    ++count;
  }
  const double least = sum > 0 ? 1e-10 * sum / count : 1;
  Groups edges = group_by(g.number_of_nodes, n, [&](Index h) { return is_edge(h) ? g.node[t.source[h]] : -1; });
  g.begin = std::move(edges.begin);
  g.halfedge = std::move(edges.element);
  g.neighbor.clear();
  for (Index h : g.halfedge)
  {
    result.weights[h] = std::max(result.weights[h], least);
    g.neighbor.push_back(g.node[t.target(h)]);
  }
  return result;
}

} // namespace meridian
