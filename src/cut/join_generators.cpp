// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/cut/join_generators.h>

#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/Surface_curve.h>
#include <meridian/surface/measures.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/graph/kruskal_min_spanning_tree.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace meridian {

namespace internal {

namespace {

// The faces of the root that a flow line touches.
void add_faces_near(const Ordered_surface& m, const std::vector<Curve_point>& points, std::vector<Index>& faces)
{
  const Refined_surface& s = m.surface;
  for (const Curve_point& p : points)
  {
    if (p.is_vertex())
    {
      s.for_each_outgoing(p.vertex, [&](Index h) { faces.push_back(s.face_of[s.face(h)]); });
      continue;
    }
    faces.push_back(s.face_of[s.face(p.halfedge)]);
    if (s.opposite[p.halfedge] >= 0) { faces.push_back(s.face_of[s.face(s.opposite[p.halfedge])]); }
  }
}

// The complex as Boost.Graph sees it.
using Complex_graph =
  boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property, Complex_edge>;
Complex_graph graph_of(const Morse_complex& complex)
{
  Complex_graph graph(complex.critical.size());
  for (const Complex_edge& e : complex.edges) { boost::add_edge(e.from, e.to, e, graph); }
  return graph;
}

// A way through the complex from a pair of generators to another.
struct Way
{
  double length = std::numeric_limits<double>::infinity();
  std::vector<Index> lines;
};
using Ways = std::map<std::pair<std::size_t, std::size_t>, Way>;

// The lines of a shortest way to a point of the complex; of several between two points the shortest.
std::vector<Index> lines_to(const Complex_graph& graph, const std::vector<std::size_t>& before, std::size_t to)
{
  std::vector<Index> lines;
  for (std::size_t v = to; v != before[v]; v = before[v])
  {
    Index best = -1;
    double least = 0;
    for (auto [e, last] = boost::out_edges(v, graph); e != last; ++e)
      if (boost::target(*e, graph) == before[v] && (best < 0 || graph[*e].length < least))
      {
        best = graph[*e].line;
        least = graph[*e].length;
      }
    lines.push_back(best);
  }
  return lines;
}

// The shortest way between any two pairs, which have points of the complex.
Ways find_ways(const Complex_graph& graph, const std::vector<std::vector<std::size_t>>& points)
{
  Ways ways;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t from : points[i])
    {
      std::vector<double> distance(boost::num_vertices(graph));
      std::vector<std::size_t> before(boost::num_vertices(graph));
      boost::dijkstra_shortest_paths(graph, from,
                                     boost::weight_map(boost::get(&Complex_edge::length, graph))
                                       .distance_map(distance.data())
                                       .predecessor_map(before.data()));
      for (std::size_t j = i + 1; j < points.size(); ++j)
        for (std::size_t to : points[j])
        {
          Way& way = ways[{i, j}];
          if (distance[to] < way.length) { way = {distance[to], lines_to(graph, before, to)}; }
        }
    }
  return ways;
}

// The pairs that a minimum spanning tree joins.
std::vector<std::pair<std::size_t, std::size_t>> choose_ways(const Ways& ways, std::size_t pairs)
{
  using Pairs = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property,
                                      boost::property<boost::edge_weight_t, double>>;
  Pairs graph(pairs);
  for (const auto& [ends, way] : ways)
    if (way.length < std::numeric_limits<double>::infinity() && !way.lines.empty())
    {
      boost::add_edge(ends.first, ends.second, way.length, graph);
    }
  std::vector<boost::graph_traits<Pairs>::edge_descriptor> tree;
  boost::kruskal_minimum_spanning_tree(graph, std::back_inserter(tree));
  std::vector<std::pair<std::size_t, std::size_t>> chosen;
  for (const auto& e : tree) { chosen.push_back(std::minmax({boost::source(e, graph), boost::target(e, graph)})); }
  return chosen;
}

} // namespace

std::vector<Link_guide> guide_joins(const Ordered_surface& m, const Morse_complex& complex,
                                    const std::vector<std::pair<Index, Index>>& saddles,
                                    const std::vector<Index>& shared, Generator_join join)
{
  std::map<Index, std::size_t> place;
  for (std::size_t v = 0; v < complex.critical.size(); ++v) { place[m.graph.node[complex.critical[v].vertex]] = v; }
  std::vector<std::vector<std::size_t>> points; // of each pair
  for (const auto& [near, far] : saddles)
  {
    points.push_back({place.at(m.graph.node[near])});
    if (join == Generator_join::COMPLEX && far >= 0) { points.back().push_back(place.at(m.graph.node[far])); }
  }
  const Ways ways = find_ways(graph_of(complex), points);
  std::vector<Link_guide> guides;
  for (const auto& ends : choose_ways(ways, saddles.size()))
  {
    Link_guide guide{shared[ends.first], shared[ends.second], {}};
    for (Index line : ways.at(ends).lines) { add_faces_near(m, whole_line(complex.lines, line), guide.faces); }
    std::sort(guide.faces.begin(), guide.faces.end());
    guide.faces.erase(std::unique(guide.faces.begin(), guide.faces.end()), guide.faces.end());
    guides.push_back(std::move(guide));
  }
  return guides;
}

} // namespace internal

} // namespace meridian
