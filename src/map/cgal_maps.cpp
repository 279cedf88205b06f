// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/map/internal/cgal_maps.h>

#include <meridian/map/planar_map.h>

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Barycentric_mapping_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Circular_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_authalic_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_conformal_map_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Square_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <cmath>
#include <utility>

namespace meridian {

namespace internal {

namespace {

// The messages of CGAL 5.5 belong to other codes from the fourth on.
std::string explain_error(CGAL::Surface_mesh_parameterization::Error_code code)
{
  namespace SMP = CGAL::Surface_mesh_parameterization;
  switch (code)
  {
  case SMP::OK: return "";
  case SMP::ERROR_EMPTY_MESH: return "the mesh is empty";
  case SMP::ERROR_NON_TRIANGULAR_MESH: return "a face is no triangle";
  case SMP::ERROR_NO_TOPOLOGICAL_DISC: return "the surface is no disc";
  case SMP::ERROR_NO_TOPOLOGICAL_BALL: return "the surface is no ball";
  case SMP::ERROR_BORDER_TOO_SHORT: return "the border is too short";
  case SMP::ERROR_NON_CONVEX_BORDER: return "the border is not convex";
  case SMP::ERROR_CANNOT_SOLVE_LINEAR_SYSTEM: return "the linear system cannot be solved";
  case SMP::ERROR_NO_1_TO_1_MAPPING: return "the map is not one-to-one";
  case SMP::ERROR_WRONG_PARAMETER: return "a parameter is wrong";
  }
  return "CGAL's error " + std::to_string(code);
}

} // namespace

std::string map_with_cgal(const Triangle_surface& disc, Map_method method, bool in_square, std::vector<Plane_point>& at)
{
  namespace SMP = CGAL::Surface_mesh_parameterization;
  using Kernel = CGAL::Simple_cartesian<double>;
  using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
  using Circle = SMP::Circular_border_arc_length_parameterizer_3<Mesh>;
  using Square = SMP::Square_border_arc_length_parameterizer_3<Mesh>;
  using Solver = CGAL::Eigen_solver_traits<
    Eigen::SparseLU<CGAL::Eigen_sparse_matrix<double>::EigenType, Eigen::COLAMDOrdering<int>>>;
  Mesh mesh;
  std::vector<Mesh::Vertex_index> vertex;
  for (const Point& p : disc.points) { vertex.push_back(mesh.add_vertex({p[0], p[1], p[2]})); }
  for (const auto& t : disc.triangles) { mesh.add_face(vertex[t[0]], vertex[t[1]], vertex[t[2]]); }
  const auto uv = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
  const auto loops = boundary_loops(disc);
  const Index h = loops.front().front();
  const auto border = mesh.opposite(mesh.halfedge(vertex[disc.source(h)], vertex[disc.target(h)]));

  const auto run = [&](auto parameterizer) { return SMP::parameterize(mesh, parameterizer, border, uv); };
  SMP::Error_code code = SMP::OK;
  switch (method)
  {
  case Map_method::MEAN_VALUE:
    code = in_square ? run(SMP::Mean_value_coordinates_parameterizer_3<Mesh, Square, Solver>())
                     : run(SMP::Mean_value_coordinates_parameterizer_3<Mesh, Circle, Solver>());
    break;
  case Map_method::TUTTE:
    code = in_square ? run(SMP::Barycentric_mapping_parameterizer_3<Mesh, Square, Solver>())
                     : run(SMP::Barycentric_mapping_parameterizer_3<Mesh, Circle, Solver>());
    break;
  case Map_method::CONFORMAL:
    code = in_square ? run(SMP::Discrete_conformal_map_parameterizer_3<Mesh, Square, Solver>())
                     : run(SMP::Discrete_conformal_map_parameterizer_3<Mesh, Circle, Solver>());
    break;
  case Map_method::AUTHALIC:
    code = in_square ? run(SMP::Discrete_authalic_parameterizer_3<Mesh, Square, Solver>())
                     : run(SMP::Discrete_authalic_parameterizer_3<Mesh, Circle, Solver>());
    break;
  case Map_method::LSCM: code = run(SMP::LSCM_parameterizer_3<Mesh>()); break;
  case Map_method::ARAP:
    code = run(SMP::ARAP_parameterizer_3<Mesh, SMP::Two_vertices_parameterizer_3<Mesh>, Solver>());
    break;
  default: return "CGAL has no such method";
  }
  at.clear();
  for (const auto v : vertex) { at.push_back({uv[v].x(), uv[v].y()}); }
  // squares are run around the other way
  if (area_of(disc.triangles, at) < 0)
  {
    for (Plane_point& p : at) { std::swap(p[0], p[1]); }
  }
  // CGAL calls a map with flipped faces an error; they are counted here.
  if (code == SMP::ERROR_NO_1_TO_1_MAPPING) { code = SMP::OK; }
  for (const Plane_point& p : at)
  {
    if (!std::isfinite(p[0]) || !std::isfinite(p[1])) { return "a coordinate is not finite"; }
  }
  return explain_error(code);
}

} // namespace internal

} // namespace meridian
