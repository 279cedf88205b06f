// Gives a mesh texture coordinates without a face turned over; seams are edges of the mesh.
#include "make_torus.h"

#include <meridian/unwrap.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <iostream>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int main()
{
  Mesh mesh = make_torus<Mesh>();
  auto uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  const meridian::Unwrapping unwrapping = meridian::unwrap(mesh, uv);
  int flipped = 0;
  for (auto f : faces(mesh))
  {
    const auto h = halfedge(f, mesh);
    flipped += CGAL::orientation(uv[h], uv[next(h, mesh)], uv[prev(h, mesh)]) != CGAL::LEFT_TURN;
  }
  std::cout << unwrapping.cut.opened.seams.size() << " edges are seams, " << flipped << " faces are turned over, "
            << (unwrapping.map.is_one_to_one ? "one-to-one\n" : "not one-to-one\n");
}
