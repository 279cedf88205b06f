// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/cut/join_generators.h>

#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/Surface_curve.h>
#include <meridian/surface/measures.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/graph/kruskal_min_spanning_tree.hpp>

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>

namespace meridian {

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

} // namespace

namespace internal {

std::vector<Link_guide> guide_joins(const Ordered_surface& m, const Morse_complex& complex,
                                    const std::vector<std::pair<Index, Index>>& saddles,
                                    const std::vector<Index>& shared, Generator_join join)
{
  const Complex_graph graph = graph_of(complex);
  std::map<Index, std::size_t> place;
  for (std::size_t v = 0; v < complex.critical.size(); ++v) { place[m.graph.node[complex.critical[v].vertex]] = v; }
  std::vector<std::vector<std::size_t>> points; // of each pair
  for (const auto& [near, far] : saddles)
  {
    points.push_back({place.at(m.graph.node[near])});
    if (join == Generator_join::COMPLEX && far >= 0) { points.back().push_back(place.at(m.graph.node[far])); }
  }
  struct Way
  {
    double length = std::numeric_limits<double>::infinity();
    std::vector<Index> lines;
  };
  using Pairs = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property,
                                      boost::property<boost::edge_weight_t, double>>;
  Pairs pairs(saddles.size());
  std::map<std::pair<std::size_t, std::size_t>, Way> ways;
  for (std::size_t i = 0; i < saddles.size(); ++i)
    for (std::size_t from : points[i])
    {
      std::vector<double> distance(boost::num_vertices(graph));
      std::vector<std::size_t> before(boost::num_vertices(graph));
      boost::dijkstra_shortest_paths(graph, from,
                                     boost::weight_map(boost::get(&Complex_edge::length, graph))
                                       .distance_map(distance.data())
                                       .predecessor_map(before.data()));
      for (std::size_t j = i + 1; j < saddles.size(); ++j)
        for (std::size_t to : points[j])
        {
          Way& way = ways[{i, j}];
          if (!(distance[to] < way.length)) { continue; }
          way = {distance[to], {}};
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
            way.lines.push_back(best);
          }
        }
    }
  for (const auto& [ends, way] : ways)
    if (way.length < std::numeric_limits<double>::infinity() && !way.lines.empty())
    {
      boost::add_edge(ends.first, ends.second, way.length, pairs);
    }
  std::vector<boost::graph_traits<Pairs>::edge_descriptor> tree;
  boost::kruskal_minimum_spanning_tree(pairs, std::back_inserter(tree));
  std::vector<Link_guide> guides;
  for (const auto& e : tree)
  {
    const std::pair<std::size_t, std::size_t> ends = std::minmax({boost::source(e, pairs), boost::target(e, pairs)});
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
