#include <meridian/cut_to_disc.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

int main()
{
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  Mesh sphere, disc;
  CGAL::make_icosahedron<Mesh, Mesh::Point>(sphere);
  const meridian::Cut cut = meridian::cut_to_disc(sphere, disc);
  return cut.genus == 0 && num_vertices(disc) > num_vertices(sphere) ? 0 : 1;
}
