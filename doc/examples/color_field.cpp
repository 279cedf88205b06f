// Solves for a field on a polyhedron, finds its critical points, and writes it as colours.
#include "make_torus.h"

#include <meridian/fields.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Simple_cartesian.h>

#include <boost/property_map/property_map.hpp>

#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <vector>

using Mesh = CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>>;
using Vertex = boost::graph_traits<Mesh>::vertex_descriptor;

int main()
{
  const Mesh mesh = make_torus<Mesh>();
  std::map<Vertex, double> values;
  const auto field = boost::make_assoc_property_map(values);
  const std::vector<Vertex> minima{*vertices(mesh).begin()}, maxima{*std::prev(vertices(mesh).end())};
  meridian::harmonic_field(mesh, minima, maxima, field);

  std::vector<meridian::Critical_vertex<Mesh>> critical;
  meridian::critical_points(mesh, field, std::back_inserter(critical));
  for (const auto& c : critical)
  {
    const char* const names[] = {"minimum", "saddle", "maximum"};
    std::cout << names[static_cast<int>(c.kind)] << " of value " << values[c.vertex] << '\n';
  }

  std::ofstream out("colored.off"); // from blue to red
  out << "COFF\n" << num_vertices(mesh) << ' ' << num_faces(mesh) << " 0\n";
  std::map<Vertex, int> number;
  for (auto v : vertices(mesh))
  {
    number.emplace(v, static_cast<int>(number.size()));
    out << v->point() << ' ' << static_cast<int>(255 * values[v]) << " 0 " << static_cast<int>(255 * (1 - values[v]))
        << " 255\n";
  }
  for (auto f : faces(mesh))
  {
    out << 3;
    for (auto v : CGAL::vertices_around_face(halfedge(f, mesh), mesh)) { out << ' ' << number[v]; }
    out << '\n';
  }
}
