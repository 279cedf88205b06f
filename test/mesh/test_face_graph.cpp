// Compiled once for each kind of mesh: all at once take more memory than a compiler should.
#include "support/mesh_types.h"
#include "support/sample_surfaces.h"

#include <meridian/cut_to_disc.h>
#include <meridian/generators.h>
#include <meridian/unwrap.h>

#include <CGAL/iterator.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <vector>

using namespace meridian;

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
  std::get<By_contours>(options.method).preference = preference::short_length;
  const auto cut = cut_to_disc(tm, disc, parameters::cut_options(options));
  BOOST_TEST(curves_of(cut, Curve_kind::MERIDIAN).size() == 2u);
  BOOST_TEST(CGAL::is_valid_polygon_mesh(disc));
  const auto edges_of_disc = static_cast<int>(std::distance(edges(disc).first, edges(disc).second));
  BOOST_TEST(static_cast<int>(num_vertices(disc)) - edges_of_disc + static_cast<int>(num_faces(disc)) == 1);
  TriangleMesh by_default;
  BOOST_TEST(cut_to_disc(tm, by_default).genus == 2);
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

// A band around the tube of a torus is one chart, the rest another; no other edge is a seam but one link in each.
BOOST_AUTO_TEST_CASE_TEMPLATE(constrained_edges_are_seams_of_an_unwrapping, TriangleMesh, Mesh_types)
{
  using Graph = boost::graph_traits<TriangleMesh>;
  const auto tm = build_mesh<TriangleMesh>(sample::torus(12, 8));
  std::map<typename Graph::face_descriptor, bool> is_in_band;
  int f = 0;
  for (auto face : faces(tm)) { is_in_band[face] = f++ < 4 * 16; }
  std::map<typename Graph::edge_descriptor, bool> is_seam;
  for (auto e : edges(tm))
  {
    const auto h = halfedge(e, tm);
    is_seam[e] = is_in_band[face(h, tm)] != is_in_band[face(opposite(h, tm), tm)];
  }
  std::map<typename Graph::halfedge_descriptor, Kernel::Point_2> uv;
  const Unwrapping u = unwrap(tm, boost::make_assoc_property_map(uv),
                              parameters::edge_is_constrained_map(boost::make_assoc_property_map(is_seam)));
  BOOST_TEST(u.charts == 2u);
  BOOST_TEST(curves_of(u.cut, Curve_kind::SEAM).size() == 2u);
  BOOST_TEST(curves_of(u.cut, Curve_kind::LINK).size() == 2u);
  BOOST_TEST(u.cut.curves.size() == 4u);
  for (const auto& [e, is_given] : is_seam)
  {
    const auto h = halfedge(e, tm);
    if (is_given) { BOOST_TEST((uv[h] != uv[prev(opposite(h, tm), tm)])); }
  }
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

#ifdef MERIDIAN_SURFACE_MESH
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
#endif

#ifdef MERIDIAN_SURFACE_MESH
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
  std::get<By_contours>(options.method).preference = preference::short_length;
  Mesh disc, expected;
  const auto cut = cut_to_disc(tm, disc, parameters::cut_options(options).vertex_point_map(map));
  BOOST_TEST((cut.surface.points == cut_to_disc(own, expected, parameters::cut_options(options)).surface.points));
  BOOST_TEST((make_triangle_surface(disc).points == make_triangle_surface(expected).points));
  Mesh refined = tm;
  auto new_points = points;
  const auto g = generators(refined, CGAL::Emptyset_iterator(), CGAL::Emptyset_iterator(),
                            CGAL::parameters::vertex_point_map(boost::make_assoc_property_map(new_points)));
  BOOST_TEST(g.smallest_angle_before > 0);
  BOOST_TEST(new_points.size() == refined.number_of_vertices());
  auto uv = tm.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  BOOST_TEST(unwrap(tm, uv, CGAL::parameters::vertex_point_map(map)).map.flipped.empty());
}
#endif

BOOST_AUTO_TEST_CASE_TEMPLATE(a_result_is_not_added_to_what_a_mesh_has, TriangleMesh, Mesh_types)
{
  auto tm = build_mesh<TriangleMesh>(sample::torus(8, 6));
  const Edge_marks<TriangleMesh> no_cut(tm);
  for (auto e : edges(tm)) { put(no_cut, e, false); }
  BOOST_CHECK_THROW(cut_to_disc(tm, tm), Invalid_input_error);
  BOOST_CHECK_THROW(open_along(tm, no_cut, tm), Invalid_input_error);
  BOOST_TEST(std::distance(vertices(tm).begin(), vertices(tm).end()) == 48);
}

namespace {

// What the caller knows of a mesh that was refined along a cut graph.
template <class TriangleMesh> struct In_place
{
  using Graph = boost::graph_traits<TriangleMesh>;
  TriangleMesh tm;
  std::vector<typename Graph::vertex_descriptor> own_vertices;
  std::vector<typename Graph::face_descriptor> own_faces;
  Edge_marks<TriangleMesh> is_cut;
  std::map<typename Graph::vertex_descriptor, double> field;
  std::map<typename Graph::vertex_descriptor, Origin> origin;
  std::map<typename Graph::face_descriptor, Index> face_origin;
  Cut cut;

  In_place(const Triangle_surface& s, const Cut_options& options) : tm(build_mesh<TriangleMesh>(s)), is_cut(tm)
  {
    own_vertices.assign(vertices(tm).begin(), vertices(tm).end());
    own_faces.assign(faces(tm).begin(), faces(tm).end());
    cut = cut_to_disc(tm, parameters::edge_is_constrained_map(is_cut)
                            .vertex_field_map(boost::make_assoc_property_map(field))
                            .cut_options(options)
                            .vertex_origin_map(boost::make_assoc_property_map(origin))
                            .face_origin_map(boost::make_assoc_property_map(face_origin)));
  }
};

} // namespace

// Theorem: the mesh is the refined surface of the cut; its own vertices and undivided faces are where they were.
BOOST_AUTO_TEST_CASE_TEMPLATE(a_mesh_is_refined_along_its_cut_in_place, TriangleMesh, Mesh_types)
{
  for (const Triangle_surface& s : {sample::noisy(sample::plate(2, 3), 0.1, 1),
                                    sample::punctured(sample::plate(1, 3), {20, 60}), sample::sphere(2)})
    for (const bool on_edges : {false, true})
    {
      Cut_options options;
      std::get<By_contours>(options.method).preference = preference::short_length;
      options.on_edges = on_edges;
      In_place<TriangleMesh> r(s, options);
      const Refined_surface& refined = r.cut.surface;
      BOOST_TEST(CGAL::is_valid_polygon_mesh(r.tm));
      const Triangle_surface now = make_triangle_surface(r.tm);
      BOOST_TEST(now.number_of_vertices() == refined.number_of_vertices());
      BOOST_TEST(now.number_of_faces() == refined.number_of_faces());
      BOOST_TEST(sample::euler_characteristic(now) == sample::euler_characteristic(s));
      const auto sorted = [](std::vector<Point> points) {
        std::sort(points.begin(), points.end());
        return points;
      };
      const auto a = sorted(now.points), b = sorted(refined.points);
      double off = 0;
      for (std::size_t i = 0; i < a.size(); ++i) { off = std::max(off, distance(a[i], b[i])); }
      BOOST_TEST(off < precision<TriangleMesh>);
      // the edges of the cut graph, by number and by length
      double length = 0;
      const auto vpm = get(CGAL::vertex_point, r.tm);
      for (auto h : r.is_cut.marked())
      {
        const auto &p = get(vpm, source(h, r.tm)), &q = get(vpm, target(h, r.tm));
        length += std::sqrt(CGAL::square(p.x() - q.x()) + CGAL::square(p.y() - q.y()) + CGAL::square(p.z() - q.z()));
      }
      BOOST_TEST(r.is_cut.size() == static_cast<std::size_t>(refined.number_of_edges()));
      BOOST_TEST(r.is_cut.marked().size() == r.cut.opened.seams.size());
      BOOST_TEST(length == r.cut.length, boost::test_tools::tolerance(1e3 * precision<TriangleMesh>));
      // own vertices keep their places and descriptors, and the field is linear between them
      BOOST_REQUIRE(r.origin.size() == static_cast<std::size_t>(refined.number_of_vertices()));
      for (std::size_t v = 0; v < r.own_vertices.size(); ++v)
      {
        const Origin o = r.origin.at(r.own_vertices[v]);
        BOOST_TEST((o.kind == Origin::VERTEX && o.index[0] == static_cast<Index>(v)));
        if (!r.cut.field.empty()) { BOOST_TEST(r.field.at(r.own_vertices[v]) == r.cut.field[v]); }
      }
      for (const auto& [v, o] : r.origin)
      {
        const auto& p = get(vpm, v);
        BOOST_TEST(distance(position(s, o), Point{p[0], p[1], p[2]}) < precision<TriangleMesh>);
        if (r.cut.field.empty() || o.kind != Origin::EDGE) { continue; }
        const double low = std::min(r.cut.field[o.index[0]], r.cut.field[o.index[1]]),
                     high = std::max(r.cut.field[o.index[0]], r.cut.field[o.index[1]]);
        BOOST_TEST((r.field.at(v) >= low - 1e-12 && r.field.at(v) <= high + 1e-12));
      }
      // each face is part of that which it names, and one part of each face is that face itself
      BOOST_REQUIRE(r.face_origin.size() == static_cast<std::size_t>(refined.number_of_faces()));
      for (std::size_t f = 0; f < r.own_faces.size(); ++f)
      {
        BOOST_TEST(r.face_origin.at(r.own_faces[f]) == static_cast<Index>(f));
      }
      for (const auto& [f, whole] : r.face_origin)
        for (auto v : CGAL::vertices_around_face(halfedge(f, r.tm), r.tm))
        {
          const Origin& o = r.origin.at(v);
          const auto& t = s.triangles.at(static_cast<std::size_t>(whole));
          const auto has = [&](Index w) { return std::count(t.begin(), t.end(), w) > 0; };
          BOOST_TEST((o.kind == Origin::VERTEX ? has(o.index[0])
                      : o.kind == Origin::EDGE ? has(o.index[0]) && has(o.index[1])
                                               : o.index[0] == whole));
        }
      if (on_edges)
      {
        BOOST_TEST(now.number_of_vertices() == s.number_of_vertices());
        BOOST_TEST((now.triangles == s.triangles));
      }
      else if (boundary_loops(s).empty() && r.cut.genus > 0)
      {
        BOOST_TEST(now.number_of_vertices() > s.number_of_vertices());
      }
    }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(a_mesh_that_cannot_be_cut_is_not_touched, TriangleMesh, Mesh_types)
{
  const auto s = sample::torus(8, 6);
  auto tm = build_mesh<TriangleMesh>(s);
  Cut_options options;
  std::get<By_contours>(options.method).minima = {1};
  BOOST_CHECK_THROW(cut_to_disc(tm, parameters::cut_options(options)), Invalid_input_error);
  BOOST_TEST((make_triangle_surface(tm).triangles == s.triangles));
}
