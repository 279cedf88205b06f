// Cuts a mesh where it stands, and lets CGAL map it: as rigid as possible, on its mesh with seams.
#include "make_torus.h"

#include <meridian/cut_to_disc.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/boost/graph/Seam_mesh.h>

#include <iostream>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Edges = Mesh::Property_map<Mesh::Edge_index, bool>;
using Vertices = Mesh::Property_map<Mesh::Vertex_index, bool>;
using Disc = CGAL::Seam_mesh<Mesh, Edges, Vertices>;
namespace SMP = CGAL::Surface_mesh_parameterization;

int main()
{
  Mesh mesh = make_torus<Mesh>();
  const Edges on_cut = mesh.add_property_map<Mesh::Edge_index, bool>("e:on_cut", false).first;
  const Vertices at_cut = mesh.add_property_map<Mesh::Vertex_index, bool>("v:at_cut", false).first;
  meridian::cut_to_disc(mesh, meridian::parameters::edge_is_constrained_map(on_cut).vertex_is_constrained_map(at_cut));

  Disc disc(mesh, on_cut, at_cut);
  auto uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  boost::graph_traits<Disc>::halfedge_descriptor border;
  for (auto h : halfedges(disc))
  {
    if (is_border(h, disc)) { border = h; }
  }
  const SMP::Error_code error = SMP::parameterize(disc, SMP::ARAP_parameterizer_3<Disc>(), border, uv);

  int flipped = 0;
  for (auto f : faces(disc))
  {
    const auto at = [&](auto h) { return get(uv, target(h, disc)); };
    const auto h = halfedge(f, disc);
    flipped += CGAL::orientation(at(h), at(next(h, disc)), at(prev(h, disc))) != CGAL::LEFT_TURN;
  }
  std::cout << (error == SMP::OK ? "parameterized" : SMP::get_error_message(error)) << ", " << flipped
            << " faces turned over\n";
}
