// Cuts a mesh where it stands, opens it along the cut, and recounts the result.
#include "make_torus.h"

#include <meridian/cut_to_disc.h>
#include <meridian/verify.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <iostream>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main()
{
  const Mesh input = make_torus<Mesh>();
  Mesh torus = input, disc;
  auto is_cut = torus.add_property_map<Mesh::Edge_index, bool>("e:is_cut", false).first;
  auto field = torus.add_property_map<Mesh::Vertex_index, double>("v:field").first;
  auto origin = torus.add_property_map<Mesh::Vertex_index, meridian::Origin>("v:origin").first;
  auto face_origin = torus.add_property_map<Mesh::Face_index, meridian::Index>("f:origin").first;
  namespace np = meridian::parameters;
  const meridian::Cut cut = meridian::cut_to_disc(
    torus,
    np::edge_is_constrained_map(is_cut).vertex_field_map(field).vertex_origin_map(origin).face_origin_map(face_origin));
  meridian::open_along(torus, is_cut, disc);

  const auto characteristic = static_cast<int>(disc.number_of_vertices()) - static_cast<int>(disc.number_of_edges())
                              + static_cast<int>(disc.number_of_faces());
  const auto proof = meridian::verify(input, torus, is_cut, np::vertex_origin_map(origin).face_origin_map(face_origin));
  std::cout << "genus " << cut.genus << ", " << cut.counts.saddles << " saddles, "
            << curves_of(cut, meridian::Curve_kind::MERIDIAN).size() << " meridian, "
            << curves_of(cut, meridian::Curve_kind::LINK).size() << " link\nthe disc has Euler characteristic "
            << characteristic << (proof ? ", verified\n" : ", not verified\n");
}
