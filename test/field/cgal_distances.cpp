#include "field/cgal_distances.h"

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>

using namespace meridian;

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;

Mesh mesh_of(const Triangle_surface& s)
{
  Mesh mesh;
  for (const Point& p : s.points) { mesh.add_vertex({p[0], p[1], p[2]}); }
  for (const auto& t : s.triangles) { mesh.add_face(Vertex(t[0]), Vertex(t[1]), Vertex(t[2])); }
  return mesh;
}

// CGAL's Heat_method_3.
struct Heat_solver : CGAL::Eigen_solver_traits<Eigen::SimplicialLDLT<CGAL::Eigen_sparse_matrix<double>::EigenType>>
{
  using Index = int;
};

} // namespace

std::vector<double> exact_distance(const Triangle_surface& s, Index source)
{
  Mesh mesh = mesh_of(s);
  CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>> paths(mesh);
  paths.add_source_point(Vertex(source));
  std::vector<double> d;
  for (Index v = 0; v < s.number_of_vertices(); ++v)
  {
    d.push_back(paths.shortest_distance_to_source_points(Vertex(v)).first);
  }
  return d;
}

std::vector<double> cgal_distance(const Triangle_surface& s, Index source)
{
  Mesh mesh = mesh_of(s);
  CGAL::Heat_method_3::Surface_mesh_geodesic_distances_3<Mesh, CGAL::Heat_method_3::Intrinsic_Delaunay, CGAL::Default,
                                                         Heat_solver>
    heat(mesh);
  heat.add_source(Vertex(source));
  auto map = mesh.add_property_map<Vertex, double>("v:distance", 0).first;
  heat.estimate_geodesic_distances(map);
  std::vector<double> d;
  for (Index v = 0; v < s.number_of_vertices(); ++v) { d.push_back(map[Vertex(v)]); }
  return d;
}
