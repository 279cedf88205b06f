// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/map/internal/cgal_maps.h>

#include <meridian/map/planar_map.h>

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/Barycentric_mapping_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Circular_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_authalic_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Square_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <cmath>
#include <string>
#include <utility>

namespace meridian {

namespace internal {

namespace {

namespace SMP = CGAL::Surface_mesh_parameterization;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Solver =
  CGAL::Eigen_solver_traits<Eigen::SparseLU<CGAL::Eigen_sparse_matrix<double>::EigenType, Eigen::COLAMDOrdering<int>>>;

// A disc as CGAL's parameterizers take it.
struct Cgal_disc
{
  Mesh mesh;
  Mesh::Halfedge_index border;
  Mesh::Property_map<Mesh::Vertex_index, Kernel::Point_2> uv;
};

// The shape of the border is chosen when the program runs, so that each method is compiled once.
class Circle_or_square
{
public:
  explicit Circle_or_square(bool is_square) : m_is_square(is_square) {}

  template <class Uv_map, class Index_map, class Flag_map>
  SMP::Error_code parameterize(const Mesh& mesh, Mesh::Halfedge_index border, Uv_map uv, Index_map index, Flag_map done)
  {
    return m_is_square ? m_square.parameterize(mesh, border, uv, index, done)
                       : m_circle.parameterize(mesh, border, uv, index, done);
  }
  bool is_border_convex() const { return true; }

private:
  bool m_is_square;
  SMP::Circular_border_arc_length_parameterizer_3<Mesh> m_circle;
  SMP::Square_border_arc_length_parameterizer_3<Mesh> m_square;
};

// The messages of CGAL 5.5 belong to other codes from the fourth on.
std::string explain_error(SMP::Error_code code)
{
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

SMP::Error_code map_disc(Cgal_disc& disc, Map_method method, bool in_square)
{
  const Circle_or_square shape(in_square);
  const auto run = [&](auto parameterizer) {
    return SMP::parameterize(disc.mesh, parameterizer, disc.border, disc.uv);
  };
  switch (method)
  {
  case Map_method::MEAN_VALUE:
    return run(SMP::Mean_value_coordinates_parameterizer_3<Mesh, Circle_or_square, Solver>(shape));
  case Map_method::TUTTE: return run(SMP::Barycentric_mapping_parameterizer_3<Mesh, Circle_or_square, Solver>(shape));
  default: return run(SMP::Discrete_authalic_parameterizer_3<Mesh, Circle_or_square, Solver>(shape));
  }
}

} // namespace

std::string map_with_cgal(const Triangle_surface& disc, Map_method method, bool in_square, std::vector<Plane_point>& at)
{
  Cgal_disc d;
  std::vector<Mesh::Vertex_index> vertex;
  for (const Point& p : disc.points) { vertex.push_back(d.mesh.add_vertex({p[0], p[1], p[2]})); }
  for (const auto& t : disc.triangles) { d.mesh.add_face(vertex[t[0]], vertex[t[1]], vertex[t[2]]); }
  d.uv = d.mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_2>("v:uv").first;
  const auto loops = boundary_loops(disc);
  const Index h = loops.front().front();
  d.border = d.mesh.opposite(d.mesh.halfedge(vertex[disc.source(h)], vertex[disc.target(h)]));

  SMP::Error_code code = map_disc(d, method, in_square);
  at.clear();
  for (const auto v : vertex) { at.push_back({d.uv[v].x(), d.uv[v].y()}); }
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
