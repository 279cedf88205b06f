#include "support/sample_surfaces.h"

#include <meridian/cut_to_disc.h>

#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/insert_curves.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Seam_mesh.h>

#include <array>
#include <iterator>
#include <set>
#include <vector>

using namespace meridian;

namespace {

template <class Kernel> CGAL::Surface_mesh<typename Kernel::Point_3> build_mesh(const Triangle_surface& s)
{
  CGAL::Surface_mesh<typename Kernel::Point_3> tm;
  internal::build(s.points, s.triangles, tm);
  return tm;
}

} // namespace

// Theorem: with exact numbers a refined mesh lies on the mesh that it was, exactly: on its edges and in its faces.
BOOST_AUTO_TEST_CASE(new_points_of_an_exact_kernel_lie_on_the_mesh)
{
  using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
  const Triangle_surface root = sample::noisy(sample::sphere(2), 0.05, 2);
  Refined_surface refined(root);
  insert_curves(root, refined, {sample::ring(root, 3, 0.5)}, false);
  insert_curves(root, refined, {sample::ring(refined, root.number_of_vertices(), 0.5)}, false);
  Mesh tm = build_mesh<Kernel>(root);
  internal::Mesh_refiner<Mesh> refiner(root, refined, tm);
  refiner.run();
  internal::place_new_vertices<Kernel::FT>(root, refined, refiner, tm.points());
  BOOST_TEST(CGAL::is_valid_polygon_mesh(tm));
  BOOST_TEST(tm.number_of_faces() == refined.triangles.size());
  std::array<int, 3> kinds{0, 0, 0};
  for (Index v = 0; v < refined.number_of_vertices(); ++v)
  {
    const auto at = [&](Index w) { return tm.point(refiner.vertex(w)); };
    const Origin o = refined.origin(v);
    ++kinds[o.kind];
    BOOST_TEST(
      CGAL::squared_distance(at(v), Kernel::Point_3(refined.points[v][0], refined.points[v][1], refined.points[v][2]))
      < 1e-20);
    if (o.kind == Origin::EDGE)
    {
      BOOST_TEST(CGAL::collinear(at(o.index[0]), at(v), at(o.index[1])));
      BOOST_TEST(CGAL::collinear_are_strictly_ordered_along_line(at(o.index[0]), at(v), at(o.index[1])));
    }
    if (o.kind != Origin::FACE) { continue; }
    const auto& t = root.triangles[o.index[0]];
    BOOST_TEST((CGAL::orientation(at(t[0]), at(t[1]), at(t[2]), at(v)) == CGAL::COPLANAR));
  }
  BOOST_TEST((kinds[Origin::EDGE] > 0 && kinds[Origin::FACE] > 0));
}

// The kernel that is given is the one that new points are constructed in: an exact one constructs them from the mesh's
// own coordinates, and they are rounded once.
BOOST_AUTO_TEST_CASE(new_points_are_constructed_in_the_kernel_that_is_given)
{
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  using Kernel = CGAL::Simple_cartesian<float>;
  using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
  const Triangle_surface s = sample::torus(20, 12);
  Mesh plain = build_mesh<Kernel>(s), exact = build_mesh<Kernel>(s);
  cut_to_disc(plain);
  const Cut cut = cut_to_disc(exact, parameters::geom_traits(Exact()));
  BOOST_REQUIRE(plain.number_of_vertices() == exact.number_of_vertices());
  BOOST_TEST(exact.number_of_vertices() > 240u);
  for (Mesh::Vertex_index v : exact.vertices())
  {
    BOOST_TEST(CGAL::squared_distance(plain.point(v), exact.point(v)) < 1e-10f);
    const auto i = static_cast<Index>(v.idx());
    if (i < 240) { BOOST_TEST((plain.point(v) == exact.point(v))); }
  }
  BOOST_TEST(cut.genus == 1);
}

// Known answer: CGAL's mesh with seams is the disc that this package opens, whatever the numbers are.
BOOST_AUTO_TEST_CASE(the_edge_map_makes_a_disc_of_cgals_seam_mesh)
{
  using Kernel = CGAL::Simple_cartesian<float>;
  using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
  for (const Triangle_surface& s : {sample::plate(2, 3), sample::sphere(2), sample::torus(20, 12)})
    for (const bool on_edges : {false, true})
    {
      Mesh tm = build_mesh<Kernel>(s);
      auto is_cut = tm.add_property_map<Mesh::Edge_index, bool>("e:is_cut", false).first;
      auto on_seam = tm.add_property_map<Mesh::Vertex_index, bool>("v:on_seam", true).first;
      Cut_options options;
      options.on_edges = on_edges;
      const Cut cut = cut_to_disc(
        tm, parameters::cut_options(options).edge_is_constrained_map(is_cut).vertex_is_constrained_map(on_seam));
      using Seams =
        CGAL::Seam_mesh<Mesh, Mesh::Property_map<Mesh::Edge_index, bool>, Mesh::Property_map<Mesh::Vertex_index, bool>>;
      const Seams disc(tm, is_cut, on_seam);
      std::set<Seams::vertex_descriptor> vertices_of_disc;
      std::size_t border = 0, edges_of_disc = 0;
      for (auto h : halfedges(disc))
      {
        vertices_of_disc.insert(target(h, disc));
        border += is_border(h, disc);
        ++edges_of_disc;
      }
      BOOST_TEST(border == 2 * cut.opened.seams.size());
      BOOST_TEST(vertices_of_disc.size() == cut.surface.points.size() + cut.opened.copy_of.size());
      const auto faces_of_disc = static_cast<std::size_t>(std::distance(faces(disc).begin(), faces(disc).end()));
      BOOST_TEST(vertices_of_disc.size() + faces_of_disc == edges_of_disc / 2 + 1);
    }
}
