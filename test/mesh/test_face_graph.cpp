#include "support/sample_surfaces.h"

#include <meridian/cut_to_disc.h>
#include <meridian/find_generators.h>
#include <meridian/mesh/solve_harmonic_field.h>
#include <meridian/unwrap.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh.h>

#ifdef MERIDIAN_HAS_OPENMESH
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>

#include <CGAL/boost/graph/graph_traits_PolyMesh_ArrayKernelT.h>
#endif

#include <boost/mpl/list.hpp>

#include <iterator>
#include <map>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
#ifdef MERIDIAN_HAS_OPENMESH
struct In_double : OpenMesh::DefaultTraits
{
  using Point = OpenMesh::Vec3d;
};
using Mesh_types = boost::mpl::list<Mesh, CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_3>,
                                    OpenMesh::PolyMesh_ArrayKernelT<In_double>>;
#else
using Mesh_types = boost::mpl::list<Mesh, CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_3>>;
#endif
using namespace meridian;

namespace {

template <class TriangleMesh> TriangleMesh build_mesh(const Triangle_surface& s)
{
  TriangleMesh tm;
  internal::build(s.points, s.triangles, tm);
  return tm;
}

} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(a_mesh_converts_there_and_back, TriangleMesh, Mesh_types)
{
  const auto s = sample::punctured(sample::plate(2), {20});
  const auto again = make_triangle_surface(build_mesh<TriangleMesh>(s));
  BOOST_TEST((again.points == s.points));
  BOOST_TEST(again.number_of_faces() == s.number_of_faces());
  BOOST_TEST(boundary_loops(again).size() == 1u);
  BOOST_TEST(sample::euler_characteristic(again) == sample::euler_characteristic(s));
}

BOOST_AUTO_TEST_CASE_TEMPLATE(a_mesh_is_cut_into_a_disc, TriangleMesh, Mesh_types)
{
  const auto tm = build_mesh<TriangleMesh>(sample::noisy(sample::plate(2, 3), 0.1, 1));
  TriangleMesh disc;
  Cut_options options;
  options.preference = preference::short_length;
  const auto cut = cut_to_disc(tm, disc, parameters::cut_options(options));
  BOOST_TEST(curves_of(cut, Curve_kind::MERIDIAN).size() == 2u);
  BOOST_TEST(CGAL::is_valid_polygon_mesh(disc));
  const auto edges_of_disc = static_cast<int>(std::distance(edges(disc).first, edges(disc).second));
  BOOST_TEST(static_cast<int>(num_vertices(disc)) - edges_of_disc + static_cast<int>(num_faces(disc)) == 1);
  TriangleMesh by_default;
  BOOST_TEST(cut_to_disc(tm, by_default).genus == 2);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(generators_are_closed_paths_of_a_refined_mesh, TriangleMesh, Mesh_types)
{
  const auto tm = build_mesh<TriangleMesh>(sample::noisy(sample::plate(2, 3), 0.1, 1));
  TriangleMesh refined;
  std::vector<std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor>> curves;
  Generator_options options;
  options.flow = false;
  const Generators g = find_generators(tm, refined, std::back_inserter(curves), parameters::generator_options(options));
  BOOST_TEST(g.pairs.size() == 2u);
  BOOST_TEST(curves.size() == 4u);
  for (const auto& path : curves)
    for (std::size_t i = 0; i < path.size(); ++i)
    {
      BOOST_TEST(halfedge(path[i], path[(i + 1) % path.size()], refined).second);
    }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(halfedges_receive_texture_coordinates, TriangleMesh, Mesh_types)
{
  using Halfedge = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  const auto tm = build_mesh<TriangleMesh>(sample::torus(12, 8));
  std::map<Halfedge, Kernel::Point_2> uv;
  const Unwrapping u = unwrap(tm, boost::make_assoc_property_map(uv), parameters::unwrap_options(Unwrap_options()));
  BOOST_TEST(uv.size() == 3 * num_faces(tm));
  int seams = 0;
  for (auto f : faces(tm))
  {
    const auto h = halfedge(f, tm);
    BOOST_TEST((CGAL::orientation(uv[h], uv[next(h, tm)], uv[prev(h, tm)]) == CGAL::LEFT_TURN));
  }
  for (auto h : halfedges(tm))
  {
    seams += uv[h] != uv[prev(opposite(h, tm), tm)] || uv[prev(h, tm)] != uv[opposite(h, tm)];
  }
  BOOST_TEST(seams == 2 * static_cast<int>(u.cut.opened.seams.size()));
  std::map<Halfedge, Kernel::Point_2> by_default;
  unwrap(tm, boost::make_assoc_property_map(by_default));
  BOOST_TEST((by_default == uv));
}

BOOST_AUTO_TEST_CASE(the_cut_graph_is_an_edge_map_of_the_refined_mesh)
{
  const auto tm = build_mesh<Mesh>(sample::noisy(sample::plate(1, 3), 0.1, 1));
  Mesh disc, refined;
  const auto cut = cut_to_disc(tm, disc);
  auto is_cut = refined.add_property_map<Mesh::Edge_index, bool>("e:is_cut", false).first;
  build_refined_mesh(cut, refined, is_cut);
  std::size_t n = 0;
  for (auto e : refined.edges()) { n += is_cut[e]; }
  BOOST_TEST(n == cut.opened.seams.size());
  BOOST_TEST(CGAL::is_closed(refined));
}

BOOST_AUTO_TEST_CASE_TEMPLATE(a_field_lies_between_its_prescribed_values, TriangleMesh, Mesh_types)
{
  const auto tm = build_mesh<TriangleMesh>(sample::torus(20, 12));
  using Vertex = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  std::vector<Vertex> all(vertices(tm).begin(), vertices(tm).end());
  std::map<Vertex, double> values;
  solve_harmonic_field(tm, std::vector<Vertex>{all[0]}, std::vector<Vertex>{all[100]},
                       boost::make_assoc_property_map(values));
  BOOST_TEST(values.size() == all.size());
  BOOST_TEST(values[all[0]] == 0);
  BOOST_TEST(values[all[100]] == 1);
  for (const auto& [v, x] : values) { BOOST_REQUIRE((x >= 0 && x <= 1)); }
  BOOST_CHECK_THROW(solve_harmonic_field(tm, std::vector<Vertex>{}, std::vector<Vertex>{all[1]},
                                         boost::make_assoc_property_map(values)),
                    Invalid_input_error);
}

// Known answer: contours of the height of a torus on edge are two level circles around its tube, one on each side.
BOOST_AUTO_TEST_CASE_TEMPLATE(maps_give_fields_and_weights, TriangleMesh, Mesh_types)
{
  const auto tm = build_mesh<TriangleMesh>(sample::torus(40, 16));
  std::map<typename boost::graph_traits<TriangleMesh>::vertex_descriptor, double> height, weight;
  Cut_options options;
  options.tightening = Tightening::NONE;
  for (const double sign : {1., -1.})
  {
    for (auto v : vertices(tm))
    {
      height[v] = get(CGAL::vertex_point, tm, v)[0];
      weight[v] = sign * get(CGAL::vertex_point, tm, v)[1];
    }
    TriangleMesh disc;
    const auto cut = cut_to_disc(tm, disc,
                                 parameters::cut_options(options)
                                   .field_map(boost::make_assoc_property_map(height))
                                   .vertex_weight_map(boost::make_assoc_property_map(weight)));
    const std::vector<Index> meridian = curves_of(cut, Curve_kind::MERIDIAN).front().vertices;
    for (Index v : meridian)
    {
      BOOST_TEST(std::abs(cut.surface.points[v][0] - cut.surface.points[meridian.front()][0]) < 0.2);
      BOOST_TEST(sign * cut.surface.points[v][1] < 0); // where the weight is low
    }
  }
}

BOOST_AUTO_TEST_CASE(quadrilaterals_are_refused_by_name)
{
  Mesh tm;
  std::vector<Mesh::Vertex_index> v;
  for (const Point& p : {Point{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}})
  {
    v.push_back(tm.add_vertex({p[0], p[1], p[2]}));
  }
  tm.add_face(v);
  BOOST_CHECK_EXCEPTION(make_triangle_surface(tm), Invalid_input_error,
                        [](const auto& e) { return std::string(e.what()).find("face 0 has 4 corners") == 0; });
}

// Metamorphic: points in a map beside the mesh, whose own all lie in one place, give what its own would.
BOOST_AUTO_TEST_CASE(points_may_lie_in_a_map_of_the_caller)
{
  const auto s = sample::noisy(sample::plate(2, 3), 0.1, 1);
  const auto own = build_mesh<Mesh>(s);
  Mesh tm = own;
  std::map<Mesh::Vertex_index, Kernel::Point_3> points;
  for (auto v : vertices(tm))
  {
    points[v] = own.point(v);
    tm.point(v) = Kernel::Point_3(0, 0, 0);
  }
  const auto map = boost::make_assoc_property_map(points);
  Cut_options options;
  options.preference = preference::short_length;
  Mesh disc, expected;
  const auto cut = cut_to_disc(tm, disc, parameters::cut_options(options).vertex_point_map(map));
  BOOST_TEST((cut.surface.points == cut_to_disc(own, expected, parameters::cut_options(options)).surface.points));
  BOOST_TEST((make_triangle_surface(disc).points == make_triangle_surface(expected).points));
  std::vector<std::vector<Mesh::Vertex_index>> curves;
  Mesh refined;
  const auto g = find_generators(tm, refined, std::back_inserter(curves), CGAL::parameters::vertex_point_map(map));
  BOOST_TEST(g.smallest_angle_before > 0);
  auto uv = tm.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  BOOST_TEST(unwrap(tm, uv, CGAL::parameters::vertex_point_map(map)).map.flipped.empty());
}

BOOST_AUTO_TEST_CASE_TEMPLATE(a_result_is_not_added_to_what_a_mesh_has, TriangleMesh, Mesh_types)
{
  auto tm = build_mesh<TriangleMesh>(sample::torus(8, 6));
  std::vector<std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor>> curves;
  BOOST_CHECK_THROW(cut_to_disc(tm, tm), Invalid_input_error);
  BOOST_CHECK_THROW(find_generators(tm, tm, std::back_inserter(curves)), Invalid_input_error);
  BOOST_TEST(std::distance(vertices(tm).begin(), vertices(tm).end()) == 48);
}
