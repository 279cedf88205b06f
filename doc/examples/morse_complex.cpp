// The Morse-Smale complex of a field as a graph for Boost's algorithms: the shortest way through it.
#include "make_torus.h"

#include <meridian/fields.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/graph/dijkstra_shortest_paths.hpp>

#include <iostream>
#include <vector>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Graph = meridian::Morse_graph<Mesh>;

int main()
{
  Mesh mesh = make_torus<Mesh>();
  auto field = mesh.add_property_map<Mesh::Vertex_index, double>("v:field").first;
  const std::vector<Mesh::Vertex_index> anywhere;
  meridian::harmonic_field(mesh, anywhere, anywhere, field);
  Graph complex;
  meridian::morse_complex(mesh, field, complex);
  std::cout << num_vertices(complex) << " critical points, " << num_edges(complex) << " flow lines\n";

  std::vector<double> distance(num_vertices(complex));
  boost::dijkstra_shortest_paths(
    complex, 0,
    boost::weight_map(get(&meridian::Morse_edge<Mesh>::length, complex))
      .distance_map(boost::make_iterator_property_map(distance.begin(), get(boost::vertex_index, complex))));
  int reached = 0;
  for (double d : distance) { reached += d < 100; }
  std::cout << reached << " of them are reached from the first\n";
}
