// The stages on any mesh. Compiled once for each kind, as the rest of the rim.
#include "support/mesh_types.h"
#include "support/sample_surfaces.h"

#include <meridian/cut_to_disc.h>
#include <meridian/fields.h>
#include <meridian/generators.h>
#include <meridian/unwrap.h>
#include <meridian/verify.h>

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/iterator.h>

#include <boost/graph/connected_components.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <vector>

using namespace meridian;

namespace {

template <class Mesh> using Vertex_of = typename boost::graph_traits<Mesh>::vertex_descriptor;
template <class Mesh> using Halfedge_of = typename boost::graph_traits<Mesh>::halfedge_descriptor;
template <class Mesh> using Loops_of = std::vector<std::vector<Halfedge_of<Mesh>>>;

// A property map that anyone can make: one that writes into a std::map.
template <class Key, class Value> auto into(std::map<Key, Value>& map) { return boost::make_assoc_property_map(map); }

template <class Mesh> std::vector<Vertex_of<Mesh>> vertices_of(const Mesh& tm)
{
  std::vector<Vertex_of<Mesh>> all;
  for (auto v : vertices(tm)) { all.push_back(v); }
  return all;
}

template <class Mesh> double coordinate(const Mesh& tm, Vertex_of<Mesh> v, int axis)
{
  const auto& p = get(CGAL::vertex_point, tm, v);
  return axis == 0 ? p[0] : axis == 1 ? p[1] : p[2];
}

template <class Mesh> std::map<Vertex_of<Mesh>, double> coordinates(const Mesh& tm, int axis)
{
  std::map<Vertex_of<Mesh>, double> field;
  for (auto v : vertices(tm)) { field[v] = coordinate(tm, v, axis); }
  return field;
}

template <class Mesh> double length(const Mesh& tm, const std::vector<Halfedge_of<Mesh>>& loop)
{
  double sum = 0;
  for (auto h : loop)
  {
    double square = 0;
    for (int i = 0; i < 3; ++i)
    {
      square += std::pow(coordinate(tm, target(h, tm), i) - coordinate(tm, source(h, tm), i), 2);
    }
    sum += std::sqrt(square);
  }
  return sum;
}

// Whether halfedges follow one another, the first the last, through no vertex twice.
template <class Mesh> bool is_simple_loop(const Mesh& tm, const std::vector<Halfedge_of<Mesh>>& loop)
{
  std::set<Vertex_of<Mesh>> visited;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    if (target(loop[i], tm) != source(loop[(i + 1) % loop.size()], tm)) { return false; }
    visited.insert(target(loop[i], tm));
  }
  return visited.size() == loop.size() && loop.size() > 2;
}

// The loop of edges through some vertices.
template <class Mesh>
std::vector<Halfedge_of<Mesh>> loop_through(const Mesh& tm, const std::vector<Vertex_of<Mesh>>& vertices)
{
  std::vector<Halfedge_of<Mesh>> loop;
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    const auto found = halfedge(vertices[i], vertices[(i + 1) % vertices.size()], tm);
    BOOST_REQUIRE(found.second);
    loop.push_back(found.first);
  }
  return loop;
}

// The long way round a torus of n x m vertices, along one of its m circles.
template <class Mesh> std::vector<Halfedge_of<Mesh>> long_way(const Mesh& tm, int n, int m, int circle)
{
  const auto all = vertices_of(tm);
  std::vector<Vertex_of<Mesh>> way;
  for (int i = 0; i < n; ++i) { way.push_back(all[i * m + circle]); }
  return loop_through(tm, way);
}

// A solver of the caller's own, which counts.
struct Counting_solver
{
  using Eigen_solver =
    CGAL::Eigen_solver_traits<Eigen::SimplicialLDLT<CGAL::Eigen_sparse_symmetric_matrix<double>::EigenType>>;
  using NT = Eigen_solver::NT;
  using Matrix = Eigen_solver::Matrix;
  using Vector = Eigen_solver::Vector;
  static int solved;
  Eigen_solver solver;
  bool factor(const Matrix& a, NT& d) { return solver.factor(a, d); }
  bool linear_solver(const Vector& b, Vector& x)
  {
    ++solved;
    return solver.linear_solver(b, x);
  }
};
int Counting_solver::solved = 0;

// Ends a run at one of its stages.
struct Button : Progress_observer
{
  Stage last;
  bool is_pressed = false;
  explicit Button(Stage stage) : last(stage) {}
  void stage_started(Stage s) override { is_pressed = is_pressed || s == last; }
  bool go_further() override { return !is_pressed; }
};

} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(a_harmonic_field_lies_between_its_extrema, Mesh, Mesh_types)
{
  const auto tm = build_mesh<Mesh>(sample::torus(20, 12));
  const auto all = vertices_of(tm);
  using Some = std::vector<Vertex_of<Mesh>>;
  std::map<Vertex_of<Mesh>, double> field, own, distant;
  harmonic_field(tm, Some{all[0]}, Some{all[100]}, into(field));
  BOOST_TEST(field.size() == all.size());
  BOOST_TEST((field[all[0]] == 0 && field[all[100]] == 1));
  for (const auto& [v, x] : field) { BOOST_TEST((x >= 0 && x <= 1)); }
  const int before = Counting_solver::solved;
  harmonic_field(tm, Some{all[0]}, Some{all[100]}, into(own), parameters::sparse_linear_solver(Counting_solver()));
  BOOST_TEST(Counting_solver::solved > before);
  for (auto v : all) { BOOST_TEST(std::abs(field[v] - own[v]) < 1e-9); }
  using Matrix = CGAL::Eigen_sparse_matrix<double>::EigenType;
  using Iterative = CGAL::Eigen_solver_traits<
    Eigen::BiCGSTAB<Matrix, Eigen::IncompleteLUT<double>>>; // goes on reading the matrix while it solves
  harmonic_field(tm, Some{all[0]}, Some{all[100]}, into(own), parameters::sparse_linear_solver(Iterative()));
  for (auto v : all) { BOOST_TEST(std::abs(field[v] - own[v]) < 1e-6); }
  BOOST_CHECK_THROW(
    harmonic_field(tm, Some{all[0]}, Some{all[100]}, into(own),
                   parameters::sparse_linear_solver(Counting_solver()).laplacian_weights(Weights::MEAN_VALUE)),
    Solver_error); // it takes the matrix for symmetric
  harmonic_field(tm, Some{all[0]}, Some{all[100]}, into(own),
                 parameters::sparse_linear_solver(Iterative()).laplacian_weights(Weights::MEAN_VALUE));
  for (auto v : all) { BOOST_TEST((own[v] > -1e-6 && own[v] < 1 + 1e-6)); }
  harmonic_field(tm, Some(), Some(), into(distant), parameters::laplacian_weights(Weights::COTANGENT));
  BOOST_TEST(critical_points(tm, into(distant), CGAL::Emptyset_iterator()).saddles == 2);
  BOOST_CHECK_THROW(harmonic_field(tm, Some(), Some{all[1]}, into(field)), Invalid_input_error);
  Button button(Stage::ORDER);
  BOOST_CHECK_THROW(harmonic_field(tm, Some(), Some(), into(field), parameters::visitor(std::ref(button))), Cancelled);
}

// Known answer: eigenvalues of the unit sphere are 2, three times, and 6; the square of a function has integral 1.
BOOST_AUTO_TEST_CASE_TEMPLATE(eigenfunctions_of_a_sphere_are_spherical_harmonics, Mesh, Mesh_types)
{
  const Triangle_surface s = sample::sphere(4);
  const std::vector<double> areas = node_areas(s, make_closed_model(s));
  const auto tm = build_mesh<Mesh>(s);
  const auto all = vertices_of(tm);
  std::vector<std::map<Vertex_of<Mesh>, double>> functions(4);
  std::vector<boost::associative_property_map<std::map<Vertex_of<Mesh>, double>>> maps;
  for (auto& f : functions) { maps.push_back(into(f)); }
  const auto values = eigenfunctions(tm, maps);
  BOOST_REQUIRE(values.size() == 4u);
  for (int i = 0; i < 4; ++i)
  {
    BOOST_TEST(values[i] == (i < 3 ? 2. : 6.), boost::test_tools::tolerance(0.05));
    double sum = 0;
    for (std::size_t v = 0; v < all.size(); ++v) { sum += areas[v] * std::pow(functions[i][all[v]], 2); }
    BOOST_TEST(sum == 1., boost::test_tools::tolerance(1e3 * precision<Mesh>));
  }
  BOOST_CHECK_THROW(eigenfunctions(tm, maps, parameters::laplacian_weights(Weights::MEAN_VALUE)), Invalid_input_error);
}

// Known answer: on a sphere distances are angles.
BOOST_AUTO_TEST_CASE_TEMPLATE(distances_on_a_sphere_are_angles, Mesh, Mesh_types)
{
  const auto tm = build_mesh<Mesh>(sample::sphere(4));
  const auto all = vertices_of(tm);
  std::map<Vertex_of<Mesh>, double> distance, own;
  geodesic_distance(tm, std::vector<Vertex_of<Mesh>>{all[0]}, into(distance));
  for (auto v : all)
  {
    double cosine = 0;
    for (int i = 0; i < 3; ++i) { cosine += coordinate(tm, v, i) * coordinate(tm, all[0], i); }
    BOOST_TEST(std::abs(distance[v] - std::acos(std::min(std::max(cosine, -1.), 1.))) < 0.1);
  }
  geodesic_distance(tm, std::vector<Vertex_of<Mesh>>{all[0]}, into(own),
                    parameters::sparse_linear_solver(Counting_solver()));
  for (auto v : all) { BOOST_TEST(std::abs(distance[v] - own[v]) < 1e-6); }
  BOOST_CHECK_THROW(geodesic_distance(tm, std::vector<Vertex_of<Mesh>>(), into(own)), Invalid_input_error);
}

// Known answer: the height of a torus on edge has one minimum, two saddles, one maximum. Theorem: minima - saddles +
// maxima is 2 - 2 g; each saddle of the complex ends four lines, and the complex is connected.
BOOST_AUTO_TEST_CASE_TEMPLATE(critical_points_and_their_complex_obey_eulers_formula, Mesh, Mesh_types)
{
  const auto torus = build_mesh<Mesh>(sample::torus(40, 16));
  auto height = coordinates(torus, 0);
  std::vector<Critical_vertex<Mesh>> critical;
  critical_points(torus, into(height), std::back_inserter(critical));
  BOOST_TEST(critical.size() == 4u);
  for (const auto& c : critical)
  {
    const double x = height[c.vertex];
    BOOST_TEST((c.kind == Critical_kind::SADDLE) == (std::abs(x) < 2.5));
    BOOST_TEST((c.kind == Critical_kind::MAXIMUM) == (x > 2.5));
  }
  for (int genus = 0; genus < 4; ++genus)
  {
    const auto tm = build_mesh<Mesh>(sample::noisy(sample::plate(genus, 3), 0.1, 5));
    auto field = coordinates(tm, 1);
    std::vector<Critical_vertex<Mesh>> all;
    const Critical_counts counts = critical_points(tm, into(field), std::back_inserter(all));
    BOOST_TEST(counts.minima - counts.saddles + counts.maxima == 2 - 2 * genus);
    Morse_graph<Mesh> graph;
    morse_complex(tm, into(field), graph);
    std::size_t saddles = 0;
    for (auto v : CGAL::make_range(boost::vertices(graph)))
    {
      if (graph[v].kind != Critical_kind::SADDLE) { continue; }
      ++saddles;
      BOOST_TEST(boost::out_degree(v, graph) >= 4u);
    }
    BOOST_TEST(static_cast<int>(saddles) == counts.saddles);
    BOOST_TEST(boost::num_edges(graph) == 4 * saddles);
    std::vector<int> component(boost::num_vertices(graph));
    BOOST_TEST((boost::num_edges(graph) == 0 || boost::connected_components(graph, component.data()) == 1));
    for (auto e : CGAL::make_range(boost::edges(graph)))
    {
      double sum = 0;
      const auto& points = graph[e].points;
      for (std::size_t i = 0; i + 1 < points.size(); ++i)
      {
        double square = 0;
        for (int k = 0; k < 3; ++k) { square += std::pow(points[i + 1][k] - points[i][k], 2); }
        sum += std::sqrt(square);
      }
      BOOST_TEST(sum == graph[e].length, boost::test_tools::tolerance(1e-5));
    }
  }
}

// Known answer: the meridian of a torus bounds inside, the longitude outside. Theorem: they are the marked edges.
BOOST_AUTO_TEST_CASE_TEMPLATE(generators_are_loops_of_halfedges_of_the_refined_mesh, Mesh, Mesh_types)
{
  for (const Triangle_surface& s : {sample::torus(24, 12), sample::noisy(sample::plate(2, 3), 0.1, 1)})
  {
    auto tm = build_mesh<Mesh>(s);
    Loops_of<Mesh> meridians, longitudes;
    const Edge_marks<Mesh> is_marked(tm);
    const Generators g = generators(tm, std::back_inserter(meridians), std::back_inserter(longitudes),
                                    parameters::edge_is_constrained_map(is_marked));
    BOOST_TEST(CGAL::is_valid_polygon_mesh(tm));
    BOOST_REQUIRE(static_cast<int>(meridians.size()) == g.genus);
    BOOST_REQUIRE(longitudes.size() == meridians.size());
    std::set<Halfedge_of<Mesh>> on_loops;
    for (std::size_t i = 0; i < meridians.size(); ++i)
    {
      BOOST_TEST((source(meridians[i].front(), tm) == source(longitudes[i].front(), tm)));
      BOOST_TEST(length(tm, meridians[i]) == g.pairs[i].meridian.length, boost::test_tools::tolerance(1e-5));
      for (const auto& loop : {meridians[i], longitudes[i]})
      {
        BOOST_TEST(is_simple_loop(tm, loop));
        for (auto h : loop) { on_loops.insert(is_marked.side(edge(h, tm))); }
      }
    }
    BOOST_TEST((is_marked.marked() == on_loops));
    if (g.genus > 1) { continue; }
    std::vector<Loop_class> classes;
    handle_or_tunnel(tm, Loops_of<Mesh>{meridians[0], longitudes[0]}, std::back_inserter(classes));
    BOOST_TEST((classes == std::vector<Loop_class>{Loop_class::HANDLE, Loop_class::TUNNEL}));
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(a_shortest_basis_has_two_loops_a_handle, Mesh, Mesh_types)
{
  auto tm = build_mesh<Mesh>(sample::noisy(sample::plate(2, 3), 0.1, 1));
  Loops_of<Mesh> loops;
  const Homology_basis basis = shortest_basis(tm, std::back_inserter(loops));
  BOOST_TEST(CGAL::is_valid_polygon_mesh(tm));
  BOOST_REQUIRE(loops.size() == 4u);
  for (std::size_t i = 0; i < 4; ++i)
  {
    BOOST_TEST(is_simple_loop(tm, loops[i]));
    BOOST_TEST(length(tm, loops[i]) == basis.loops[i].length, boost::test_tools::tolerance(1e-5));
  }
}

// Known answer: the long way round a torus, wherever it begins, is pulled to the inner circle. What can be contracted,
// or meets a vertex twice, is refused.
BOOST_AUTO_TEST_CASE_TEMPLATE(loops_of_edges_are_pulled_tight, Mesh, Mesh_types)
{
  const int n = 40, m = 16;
  for (const int circle : {2, 4, 7})
  {
    auto tm = build_mesh<Mesh>(sample::torus(n, m));
    Loops_of<Mesh> tight;
    const Edge_marks<Mesh> is_marked(tm);
    const auto result = tighten(tm, Loops_of<Mesh>{long_way(tm, n, m, circle)}, std::back_inserter(tight),
                                parameters::edge_is_constrained_map(is_marked));
    BOOST_REQUIRE(tight.size() == 1u);
    BOOST_TEST(CGAL::is_valid_polygon_mesh(tm));
    BOOST_TEST(is_simple_loop(tm, tight[0]));
    BOOST_TEST(result.length <= result.length_before);
    BOOST_TEST(length(tm, tight[0]) == 4 * sample::pi, boost::test_tools::tolerance(0.02));
    for (auto h : tight[0]) { BOOST_TEST(get(is_marked, edge(h, tm))); }
  }
  auto tm = build_mesh<Mesh>(sample::torus(n, m));
  const auto all = vertices_of(tm);
  const auto refused = [&](const Loops_of<Mesh>& loops, const char* part) {
    Loops_of<Mesh> none;
    BOOST_CHECK_EXCEPTION(tighten(tm, loops, std::back_inserter(none)), Invalid_input_error,
                          [&](const auto& e) { return std::string(e.what()).find(part) != std::string::npos; });
  };
  std::vector<Halfedge_of<Mesh>> around, back;
  for (auto h : CGAL::halfedges_around_target(all[50], tm)) { around.push_back(next(opposite(h, tm), tm)); }
  std::reverse(around.begin(), around.end());
  BOOST_REQUIRE(is_simple_loop(tm, around));
  for (auto h = around.rbegin(); h != around.rend(); ++h) { back.push_back(opposite(*h, tm)); }
  refused({around}, "contracted");
  refused({back}, "contracted");
  refused({long_way(tm, n, m, 3), long_way(tm, n, m, 3)}, "visited twice");
  BOOST_TEST(num_vertices(tm) == 640u); // not touched
}

// Theorem: the mesh opened along the map of a cut is a disc; its vertices lie where those do that they copy.
BOOST_AUTO_TEST_CASE_TEMPLATE(a_mesh_is_opened_along_an_edge_map, Mesh, Mesh_types)
{
  for (const Triangle_surface& s : {sample::torus(20, 12), sample::punctured(sample::plate(2, 3), {20})})
  {
    auto tm = build_mesh<Mesh>(s);
    const Edge_marks<Mesh> is_cut(tm);
    std::vector<Mesh_curve<Mesh>> curves;
    const Cut cut =
      cut_to_disc(tm, parameters::edge_is_constrained_map(is_cut).curve_output_iterator(std::back_inserter(curves)));
    std::set<Halfedge_of<Mesh>> on_curves; // they are the cut graph
    BOOST_TEST(curves.size() == cut.curves.size());
    for (const auto& c : curves)
    {
      if (c.is_closed) { BOOST_TEST(is_simple_loop(tm, c.halfedges)); }
      for (std::size_t i = 0; i + 1 < c.halfedges.size(); ++i)
      {
        BOOST_TEST((target(c.halfedges[i], tm) == source(c.halfedges[i + 1], tm)));
      }
      for (auto h : c.halfedges) { on_curves.insert(is_cut.side(edge(h, tm))); }
    }
    BOOST_TEST((on_curves == is_cut.marked()));
    Mesh disc;
    std::vector<std::pair<Vertex_of<Mesh>, Vertex_of<Mesh>>> pairs;
    std::vector<std::pair<typename boost::graph_traits<Mesh>::face_descriptor,
                          typename boost::graph_traits<Mesh>::face_descriptor>>
      face_pairs;
    open_along(tm, is_cut, disc,
               parameters::vertex_to_vertex_output_iterator(std::back_inserter(pairs))
                 .face_to_face_output_iterator(std::back_inserter(face_pairs)));
    BOOST_TEST(CGAL::is_valid_polygon_mesh(disc));
    const Triangle_surface opened = make_triangle_surface(disc);
    BOOST_TEST(sample::euler_characteristic(opened) == 1);
    BOOST_TEST(boundary_loops(opened).size() == 1u);
    BOOST_TEST(pairs.size() == num_vertices(disc));
    for (const auto& [own, copy] : pairs)
      for (int i = 0; i < 3; ++i) { BOOST_TEST(coordinate(tm, own, i) == coordinate(disc, copy, i)); }
    BOOST_TEST(face_pairs.size() == num_faces(disc));
    for (const auto& [own, copy] : face_pairs)
      for (int i = 0; i < 3; ++i)
      {
        BOOST_TEST(coordinate(tm, target(halfedge(own, tm), tm), i)
                   == coordinate(disc, target(halfedge(copy, disc), disc), i));
      }
  }
}

// Theorem: a disc is mapped one-to-one, so that every face turns left.
BOOST_AUTO_TEST_CASE_TEMPLATE(a_mesh_is_parameterized_where_it_is_opened, Mesh, Mesh_types)
{
  auto tm = build_mesh<Mesh>(sample::torus(20, 12));
  std::map<Halfedge_of<Mesh>, Kernel::Point_2> uv;
  BOOST_CHECK_EXCEPTION(parameterize(tm, into(uv)), Invalid_input_error, [](const auto& e) {
    return std::string(e.what()).find("genus 1 and 0 boundary loops") != std::string::npos;
  });
  const Edge_marks<Mesh> is_cut(tm);
  cut_to_disc(tm, parameters::edge_is_constrained_map(is_cut));
  const Parameterization map = parameterize(tm, into(uv), parameters::edge_is_constrained_map(is_cut));
  BOOST_TEST(map.is_one_to_one);
  BOOST_TEST(uv.size() == 3 * num_faces(tm));
  for (auto f : faces(tm))
  {
    const auto h = halfedge(f, tm);
    BOOST_TEST((CGAL::orientation(uv[h], uv[next(h, tm)], uv[prev(h, tm)]) == CGAL::LEFT_TURN));
  }
  for (auto h : halfedges(tm)) // both sides of an edge that is not cut lie at one place
  {
    if (!get(is_cut, edge(h, tm))) { BOOST_TEST((uv[h] == uv[prev(opposite(h, tm), tm)])); }
  }
  Mesh disc;
  open_along(tm, is_cut, disc);
  std::map<Halfedge_of<Mesh>, Kernel::Point_2> of_disc;
  Map_options options;
  options.method = Map_method::POSITIVE;
  BOOST_TEST(parameterize(disc, into(of_disc), parameters::map_options(options)).is_one_to_one);
  Button button(Stage::PARAMETERIZE);
  BOOST_CHECK_THROW(parameterize(disc, into(of_disc), parameters::visitor(&button)), Cancelled);
}

// Each claim of the recount has an alteration that breaks it.
BOOST_AUTO_TEST_CASE_TEMPLATE(a_cut_is_verified_from_the_mesh_before_and_after, Mesh, Mesh_types)
{
  const auto input = build_mesh<Mesh>(sample::torus(20, 12)); // not copied: a cell complex takes another order then
  auto tm = build_mesh<Mesh>(sample::torus(20, 12));
  const Edge_marks<Mesh> is_cut(tm);
  std::map<Vertex_of<Mesh>, Origin> origin;
  std::map<typename boost::graph_traits<Mesh>::face_descriptor, Index> face_origin;
  cut_to_disc(
    tm, parameters::edge_is_constrained_map(is_cut).vertex_origin_map(into(origin)).face_origin_map(into(face_origin)));
  const auto maps = parameters::vertex_origin_map(into(origin)).face_origin_map(into(face_origin));
  const Verification good = verify(input, tm, is_cut, maps);
  if (precision<Mesh> < 1e-9) // points that were rounded are not those that the origins say
  {
    for (const auto& failure : good.failures) { BOOST_ERROR(failure); }
    BOOST_TEST(good.components.front().discs == 1);
  }
  const auto is_refused = [&] { return !verify(input, tm, is_cut, maps).failures.empty(); };
  const auto cut_edge = edge(*is_cut.marked().begin(), tm);
  put(is_cut, cut_edge, false);
  BOOST_TEST(is_refused());
  put(is_cut, cut_edge, true);
  auto& moved = origin[vertices_of(tm).back()];
  const Origin true_origin = moved;
  moved.weight[0] *= 0.5;
  BOOST_TEST(is_refused());
  moved = true_origin;
  auto& other = face_origin[*faces(tm).begin()];
  other += 7;
  BOOST_TEST(is_refused());
  BOOST_TEST(!verify(input, tm, is_cut).failures.empty()); // without the maps a refined mesh is another one
}

// A run ends where the button is pressed, and leaves the mesh as it was; a solver of one's own is asked.
BOOST_AUTO_TEST_CASE_TEMPLATE(a_cut_heeds_its_visitor_and_its_solver, Mesh, Mesh_types)
{
  const auto s = sample::torus(16, 8);
  for (const Stage stage : {Stage::FIELD, Stage::LINKS, Stage::OPEN, Stage::VERIFY})
  {
    auto tm = build_mesh<Mesh>(s);
    Button button(stage);
    BOOST_CHECK_THROW(cut_to_disc(tm, parameters::visitor(std::ref(button))), Cancelled);
    BOOST_TEST((make_triangle_surface(tm).triangles == s.triangles));
  }
  const int before = Counting_solver::solved;
  auto tm = build_mesh<Mesh>(s);
  Morse_graph<Mesh> graph;
  cut_to_disc(tm, parameters::sparse_linear_solver(Counting_solver()).morse_graph(std::ref(graph)));
  BOOST_TEST(Counting_solver::solved > before);
  BOOST_TEST(boost::num_vertices(graph) == 4u);
  BOOST_TEST(boost::num_edges(graph) == 8u);
  auto by_traits = build_mesh<Mesh>(s), by_default = build_mesh<Mesh>(s);
  BOOST_TEST((cut_to_disc(by_traits, parameters::cut_traits(Default_cut_traits())).opened.seams
              == cut_to_disc(by_default).opened.seams));
  Cut_options options;
  options.method = By_tree_cotree();
  auto edges_alone = build_mesh<Mesh>(s);
  BOOST_CHECK_THROW(cut_to_disc(edges_alone, parameters::cut_options(options).morse_graph(std::ref(graph))),
                    Invalid_input_error);
}
