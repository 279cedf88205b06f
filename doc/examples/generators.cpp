// Finds a meridian and a longitude of a torus as loops of halfedges, says which is which, and pulls a loop tight.
#include "make_torus.h"

#include <meridian/generators.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <iostream>
#include <iterator>
#include <vector>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Loops = std::vector<std::vector<Mesh::Halfedge_index>>;

int main()
{
  Mesh mesh = make_torus<Mesh>();
  Loops meridians, longitudes;
  const meridian::Generators found =
    meridian::generators(mesh, std::back_inserter(meridians), std::back_inserter(longitudes));
  std::vector<meridian::Loop_class> classes;
  meridian::handle_or_tunnel(mesh, Loops{meridians[0], longitudes[0]}, std::back_inserter(classes));
  std::cout << "genus " << found.genus << ": a " << name_of(classes[0]) << " loop and a " << name_of(classes[1])
            << " loop\n";

  Mesh torus = make_torus<Mesh>();
  std::vector<Mesh::Halfedge_index> around; // along the top
  for (unsigned i = 0; i < 40; ++i)
  {
    around.push_back(torus.halfedge(Mesh::Vertex_index(16 * i + 4), Mesh::Vertex_index(16 * ((i + 1) % 40) + 4)));
  }
  Loops tight;
  const meridian::Tightened_loops result = meridian::tighten(torus, Loops{around}, std::back_inserter(tight));
  std::cout << "length " << static_cast<int>(result.length_before + 0.5) << ", tightened "
            << static_cast<int>(result.length + 0.5) << '\n';
}
