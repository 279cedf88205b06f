// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/unwrap/plan_extensions.h>

#include <meridian/cut/keep_out.h>
#include <meridian/field/Laplace_system.h>
#include <meridian/field/intrinsic_delaunay.h>
#include <meridian/surface/Closed_model.h>
#include <meridian/surface/measures.h>
#include <meridian/surface/shortest_ways.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace meridian {

namespace internal {

namespace {

class Extension_planner
{
public:
  Extension_planner(const Triangle_surface& disc, Make_solver solver, const std::vector<char>& kept_out)
    : m_model(make_closed_model(disc)), m_lengths(edge_lengths(disc, m_model)),
      m_graph(make_intrinsic_delaunay_graph(disc)), m_system(m_graph.graph, m_graph.weights, solver),
      m_curvature(m_model.number_of_nodes, 0), m_area(m_model.number_of_nodes, 0),
      m_is_border(m_model.number_of_nodes, 0), m_is_closed(m_model.number_of_nodes, !kept_out.empty()),
      m_u(m_model.number_of_nodes, 0), m_by(m_model.number_of_nodes, -1)
  {
    for (Index a = 0; a < m_model.number_of_nodes; ++a) { m_is_border[a] = m_model.is_loop(a); }
    const std::vector<char> inside = vertices_inside(disc, kept_out);
    for (std::size_t v = 0; v < inside.size(); ++v) { m_is_closed[m_model.node[v]] &= inside[v]; }
    measure(disc);
  }

  // Solves for u, with 0 on the border.
  void solve()
  {
    std::vector<Index> unknown;
    for (Index a = 0; a < m_model.number_of_nodes; ++a)
    {
      m_u[a] = 0;
      if (!m_is_border[a]) { unknown.push_back(a); }
    }
    m_system.solve(
      unknown, [](Index) { return 0.; }, m_u, m_curvature);
  }

  // The mean of sqrt(1 + (u - its mean)^2) - 1.
  double variation() const
  {
    double whole = 0, mean = 0, sum = 0;
    for (std::size_t a = 0; a < m_u.size(); ++a)
    {
      whole += m_area[a];
      mean += m_area[a] * m_u[a];
    }
    if (!(whole > 0)) { return 0; }
    mean /= whole;
    for (std::size_t a = 0; a < m_u.size(); ++a) { sum += m_area[a] * (std::hypot(1, m_u[a] - mean) - 1); }
    return sum / whole;
  }

  // A vertex, and the nodes of a path from it that become border.
  struct Way
  {
    Index vertex;
    std::vector<Index> nodes;
  };

  // Takes the peaks of |u| that are nearly as high as the highest.
  std::vector<Way> take_peaks(std::size_t most)
  {
    constexpr double nearly = 0.9; // less takes three times as many
    const std::vector<std::pair<double, Index>> peaks = find_peaks();
    if (!peaks.empty()) { find_ways(); }
    std::vector<Way> ways;
    for (const auto& [minus_height, a] : peaks)
    {
      if (ways.size() == most || minus_height > nearly * peaks.front().first) { break; }
      if (m_is_border[a]) { continue; } // on the path from another
      ways.push_back({m_model.representative[a], {}});
      for (Index b = a; b >= 0 && !m_is_border[b]; b = m_by[b])
      {
        m_is_border[b] = 1;
        ways.back().nodes.push_back(b);
      }
    }
    return ways;
  }

  // Lets only the first of some ways that were taken be border.
  void keep(const std::vector<Way>& ways, std::size_t count)
  {
    for (std::size_t i = 0; i < ways.size(); ++i)
    {
      for (Index a : ways[i].nodes) { m_is_border[a] = i < count; }
    }
  }

private:
  // The curvature at each node, but the border's, and the area around it.
  void measure(const Triangle_surface& disc)
  {
    const double full = 2 * std::acos(-1.);
    for (Index a = 0; a < m_model.first_loop_node; ++a) { m_curvature[a] = full; }
    for (Index f = 0; f < disc.number_of_faces(); ++f)
      for (int k = 0; k < 3; ++k)
      {
        const auto& t = disc.triangles[f];
        const Index a = m_model.node[t[k]];
        const Point to_next = disc.points[t[(k + 1) % 3]] - disc.points[t[k]],
                    to_last = disc.points[t[(k + 2) % 3]] - disc.points[t[k]];
        const double twice = norm(cross(to_next, to_last));
        m_area[a] += twice / 6;
        if (!m_is_border[a]) { m_curvature[a] -= std::atan2(twice, dot(to_next, to_last)); }
      }
  }

  // Nodes where |u| is higher than around, minus that height, the highest first.
  std::vector<std::pair<double, Index>> find_peaks() const
  {
    const auto key = [&](Index a) { return std::make_pair(-std::abs(m_u[a]), a); };
    std::vector<std::pair<double, Index>> peaks;
    for (Index a = 0; a < m_model.number_of_nodes; ++a)
    {
      bool is_peak = !m_is_border[a] && !m_is_closed[a];
      for (Index e = m_model.begin[a]; e < m_model.begin[a + 1] && is_peak; ++e)
      {
        const Index b = m_model.neighbor[e];
        is_peak = m_is_border[b] || m_is_closed[b] || key(a) < key(b);
      }
      if (is_peak) { peaks.push_back(key(a)); }
    }
    std::sort(peaks.begin(), peaks.end());
    return peaks;
  }

  // The next node on the shortest way of edges from each to the border.
  void find_ways()
  {
    std::vector<std::pair<double, Index>> starts;
    for (Index a = 0; a < m_model.number_of_nodes; ++a)
    {
      m_by[a] = -1;
      if (m_is_border[a]) { starts.emplace_back(0., a); }
    }
    find_shortest_ways(m_model.number_of_nodes, starts, [&](Index a, const auto& reach) {
      for (Index e = m_model.begin[a]; e < m_model.begin[a + 1]; ++e)
      {
        const Index b = m_model.neighbor[e];
        if (!m_is_closed[b] && reach(b, m_lengths[e])) { m_by[b] = a; }
      }
    });
  }

  const Closed_model m_model;
  const std::vector<double> m_lengths; // of its edges
  const Weighted_graph m_graph;
  Laplace_system m_system;
  std::vector<double> m_curvature, m_area; // of each node
  std::vector<char> m_is_border;           // of each node: on the border, or a path to it
  std::vector<char> m_is_closed;           // of each node: inside what is kept out of
  std::vector<double> m_u;
  std::vector<Index> m_by;
};

double expected_stretch(Extension_planner& planner)
{
  planner.solve();
  return std::sqrt(1 + planner.variation());
}

// Of ways with which the stretch is low enough, about the fewest, from the first on, with which it is.
std::size_t keep_enough(Extension_planner& planner, const std::vector<Extension_planner::Way>& ways, double enough,
                        double& stretch)
{
  std::size_t few = 0, many = ways.size(); // too few, and enough
  for (; many - few > 1 + many / 8;)
  {
    const std::size_t count = (few + many) / 2;
    planner.keep(ways, count);
    const double then = expected_stretch(planner);
    if (then > enough) { few = count; }
    else
    {
      many = count;
      stretch = then;
    }
  }
  planner.keep(ways, many);
  return many;
}

} // namespace

} // namespace internal

Extension_plan plan_extensions(const Triangle_surface& disc, const std::function<double(double)>& goal,
                               std::size_t most, Make_solver solver, const std::vector<char>& kept_out)
{
  Extension_plan plan;
  internal::Extension_planner planner(disc, solver, kept_out);
  plan.before = plan.after = internal::expected_stretch(planner);
  for (const double enough = goal(plan.before); plan.after > enough && plan.vertices.size() < most;)
  {
    const auto ways = planner.take_peaks(most - plan.vertices.size());
    if (ways.empty()) { break; }
    const double without = std::exchange(plan.after, internal::expected_stretch(planner));
    constexpr double worth = 0.05; // around what is kept out of there is always a peak
    if (!kept_out.empty() && without - plan.after < worth * (without - enough))
    {
      plan.after = without;
      break;
    }
    std::size_t count = ways.size();
    if (!(plan.after > enough)) { count = internal::keep_enough(planner, ways, enough, plan.after); }
    for (std::size_t i = 0; i < count; ++i) { plan.vertices.push_back(ways[i].vertex); }
  }
  return plan;
}

} // namespace meridian
