// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/cut/internal/minimum_spanning_tree.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/kruskal_min_spanning_tree.hpp>

#include <iterator>

namespace meridian {
namespace internal {

std::vector<std::size_t> minimum_spanning_tree(Index vertices, const std::vector<Spanning_edge>& edges)
{
  struct Candidate
  {
    double weight;
    std::size_t number;
  };
  using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property, Candidate>;
  Graph graph(vertices);
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    boost::add_edge(edges[i].from, edges[i].to, Candidate{edges[i].weight, i}, graph);
  }
  std::vector<Graph::edge_descriptor> tree;
  boost::kruskal_minimum_spanning_tree(graph, std::back_inserter(tree),
                                       boost::weight_map(boost::get(&Candidate::weight, graph)));
  std::vector<std::size_t> chosen;
  for (const auto& e : tree) { chosen.push_back(graph[e].number); }
  return chosen;
}

} // namespace internal
} // namespace meridian
