// Cuts a mesh of matrices V, F along edges, as libigl's igl::cut_mesh() takes the cut, and maps the disc.
#include <meridian/matrices.h>

#include <meridian/cut/cut_to_disc.h>
#include <meridian/map/parameterize_disc.h>

#include <iostream>

int main()
{
  Eigen::MatrixXd V(8, 3); // a cube
  V << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1;
  Eigen::MatrixXi F(12, 3);
  F << 0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4, 1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7;
  const meridian::Triangle_surface surface = meridian::make_triangle_surface(V, F);
  meridian::Cut_options options;
  options.on_edges = true;
  const meridian::Cut cut = meridian::cut_to_disc(surface, options);
  const Eigen::MatrixXi cuts = meridian::cut_mask(cut.surface); // igl::cut_mesh(V, F, cuts, Vcut, Fcut)
  const meridian::Triangle_surface disc = surface_of(cut.surface, cut.opened);
  const Eigen::MatrixXi Fcut = meridian::face_matrix(disc);
  const Eigen::MatrixXd UV = meridian::uv_matrix(meridian::parameterize_disc(disc));
  std::cout << cuts.sum() / 2 << " edges are cut, " << disc.number_of_vertices() - V.rows() << " vertices are doubled\n"
            << UV.rows() << " coordinates for " << Fcut.rows() << " faces\n";
}
