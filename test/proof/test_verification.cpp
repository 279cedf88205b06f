#include "support/pipeline.h"
#include "support/sample_surfaces.h"

#include <meridian/base/Polygon_soup.h>
#include <meridian/base/Result_mesh.h>
#include <meridian/base/vectors.h>
#include <meridian/proof/verify_cut.h>
#include <meridian/result/recount.h>

#include <set>

using namespace meridian;

namespace {

// A bordered genus-1 surface and a sphere, cut: what the corruptions are made of.
struct Fixture
{
  Polygon_soup input;
  Result_mesh result;

  Fixture()
  {
    const auto a = sample::noisy(sample::punctured(sample::torus(14, 9), {50}), 0.1, 3), b = sample::sphere(1);
    input = sample::soup(a);
    for (const Point& p : b.points) { input.points.push_back({p[0] + 9, p[1], p[2]}); }
    for (const auto& t : b.triangles)
    {
      const std::array<Index, 3> moved{t[0] + a.number_of_vertices(), t[1] + a.number_of_vertices(),
                                       t[2] + a.number_of_vertices()};
      input.add_polygon(moved.data(), 3);
    }
    result = pipeline::run(input).assembled.mesh;
  }
  bool is_caught(const std::string& name) const
  {
    const auto v = verify_cut(input, result);
    for (const auto& failure : v.failures) { BOOST_TEST_MESSAGE(failure); }
    return !v && std::any_of(v.failures.begin(), v.failures.end(), [&](const auto& f) {
      return f.find(name) != std::string::npos;
    });
  }
  void erase_face(std::size_t f)
  {
    result.faces.erase(result.faces.begin() + f);
    result.face_of.erase(result.face_of.begin() + f);
    result.component_of.erase(result.component_of.begin() + f);
    std::vector<std::array<Index, 2>> seams;
    for (auto s : result.seams)
    {
      bool is_kept = true;
      for (Index& side : s)
      {
        is_kept = is_kept && side / 3 != static_cast<Index>(f);
        if (side / 3 > static_cast<Index>(f)) { side -= 3; }
      }
      if (is_kept) { seams.push_back(s); }
    }
    result.seams = seams;
  }
  Index copy(Index v) // a new copy of a vertex
  {
    const Index root = result.copy_of[v] < 0 ? v : result.copy_of[v];
    result.points.push_back(result.points[v]);
    result.origin.push_back(result.origin[v]);
    result.copy_of.push_back(root);
    return static_cast<Index>(result.points.size()) - 1;
  }
  // Puts a new vertex on a triangle of the input, which is that of a face of the result, with these weights there.
  void place_inside(Index v, Index triangle, const std::array<double, 3>& weight)
  {
    result.origin[v].kind = Result_origin::FACE;
    result.origin[v].index[0] = triangle;
    result.origin[v].weight = weight;
    result.points[v] = position_of(result.origin[v], input.points, [&](Index t) {
      return std::array{input.corner(t, 0), input.corner(t, 1), input.corner(t, 2)};
    });
  }
  // Divides a face in three at a new vertex; the first part keeps its number, and its first two corners.
  Index divide(std::size_t f, const std::array<double, 3>& weight)
  {
    const Index v = copy(0);
    result.copy_of[v] = -1;
    place_inside(v, result.face_of[f], weight);
    const auto [a, b, c] = result.faces[f];
    result.faces[f] = {a, b, v};
    for (const std::array<Index, 3>& part : {std::array{b, c, v}, {c, a, v}})
    {
      result.faces.push_back(part);
      result.face_of.push_back(result.face_of[f]);
      result.component_of.push_back(result.component_of[f]);
    }
    return v;
  }
  // A face that is one of the input, and has no seam.
  std::size_t whole_face() const
  {
    std::vector<int> parts(input.number_of_polygons(), 0);
    for (Index polygon : result.face_of) { ++parts[polygon]; }
    std::size_t f = 0;
    const auto has_seam = [&](const auto& seam) { return seam[0] / 3 == Index(f) || seam[1] / 3 == Index(f); };
    while (parts[result.face_of[f]] > 1 || std::any_of(result.seams.begin(), result.seams.end(), has_seam)) { ++f; }
    return f;
  }
  // An interior vertex of the disc, and a face at it.
  std::pair<Index, std::size_t> interior() const
  {
    std::vector<char> is_rim(result.points.size(), 0);
    std::map<std::pair<Index, Index>, int> uses;
    for (const auto& f : result.faces)
    {
      for (int k = 0; k < 3; ++k) { ++uses[std::minmax(f[k], f[(k + 1) % 3])]; }
    }
    for (const auto& [edge, n] : uses)
    {
      if (n == 1) { is_rim[edge.first] = is_rim[edge.second] = 1; }
    }
    for (std::size_t f = 0; f < result.faces.size(); ++f)
      if (!is_rim[result.faces[f][0]] && !is_rim[result.faces[f][1]]) { return {result.faces[f][0], f}; }
    return {-1, 0};
  }
};

} // namespace

BOOST_FIXTURE_TEST_CASE(a_sound_result_is_verified_with_its_counts, Fixture)
{
  const auto v = verify_cut(input, result);
  for (const auto& failure : v.failures) { BOOST_ERROR(failure); }
  BOOST_REQUIRE(v.components.size() == 2u);
  BOOST_TEST(v.components[0].genus == 1);
  BOOST_TEST(v.components[0].boundary_loops == 1);
  BOOST_TEST(v.components[1].genus == 0);
  for (const auto& c : v.components)
  {
    BOOST_TEST(c.discs == 1);
    BOOST_TEST(c.disc_euler_characteristic == 1);
    BOOST_TEST(c.disc_boundary_loops == 1);
    BOOST_TEST(c.glued_euler_characteristic == c.euler_characteristic);
  }
}

BOOST_FIXTURE_TEST_CASE(a_missing_face_is_caught, Fixture)
{
  erase_face(interior().second);
  BOOST_TEST(is_caught("faces of the input are missing from the result"));
}

BOOST_FIXTURE_TEST_CASE(a_missing_part_of_a_face_is_caught, Fixture)
{
  for (std::size_t f = 1; f < result.faces.size(); ++f)
    if (result.face_of[f] == result.face_of[f - 1])
    {
      erase_face(f);
      break;
    }
  BOOST_TEST(is_caught("are not divided into a disc"));
}

BOOST_FIXTURE_TEST_CASE(a_flipped_face_is_caught, Fixture)
{
  auto& f = result.faces[interior().second];
  std::swap(f[1], f[2]);
  BOOST_TEST(is_caught("faces run along an edge in the direction of their neighbour"));
}

BOOST_FIXTURE_TEST_CASE(a_flipped_component_is_caught, Fixture)
{
  // Turned over with its seams, it is still a disc that glues back: everything else about it is right.
  for (auto& f : result.faces) { std::swap(f[1], f[2]); }
  for (auto& seam : result.seams)
  {
    for (Index& side : seam) { side += side % 3 == 0 ? 2 : side % 3 == 2 ? -2 : 0; }
  }
  BOOST_TEST(is_caught("2 components are turned over"));
  BOOST_TEST(verify_cut(input, result).failures.size() == 1u);
}

BOOST_FIXTURE_TEST_CASE(a_doubled_cut_is_caught, Fixture)
{
  // A face is cut off along one more edge, from the rim inwards.
  std::map<std::pair<Index, Index>, int> uses;
  for (const auto& f : result.faces)
  {
    for (int k = 0; k < 3; ++k) { ++uses[std::minmax(f[k], f[(k + 1) % 3])]; }
  }
  std::vector<char> is_rim(result.points.size(), 0);
  for (const auto& [edge, n] : uses)
  {
    if (n == 1) { is_rim[edge.first] = is_rim[edge.second] = 1; }
  }
  bool done = false;
  for (auto& f : result.faces)
    for (int k = 0; k < 3 && !done; ++k)
    {
      const Index v = f[k], w = f[(k + 1) % 3], u = f[(k + 2) % 3];
      if (!is_rim[v] || uses[std::minmax(v, w)] != 2 || uses[std::minmax(u, v)] != 1) { continue; }
      f[k] = copy(v); // the fan of v is opened beside its last face
      done = true;
    }
  BOOST_REQUIRE(done);
  BOOST_TEST(is_caught("faces are cut from a neighbour without a seam"));
}

BOOST_FIXTURE_TEST_CASE(a_disconnected_piece_is_caught, Fixture)
{
  auto& f = result.faces[interior().second];
  for (Index& v : f) { v = copy(v); }
  BOOST_TEST(is_caught("components of the input did not become one disc"));
}

BOOST_FIXTURE_TEST_CASE(a_disconnected_piece_whose_seams_are_listed_is_caught, Fixture)
{
  const std::size_t lone = interior().second;
  const auto old = result.faces[lone];
  for (std::size_t f = 0; f < result.faces.size(); ++f)
    for (int k = 0; k < 3 && f != lone; ++k)
      for (int l = 0; l < 3; ++l)
        if (result.faces[f][k] == old[(l + 1) % 3] && result.faces[f][(k + 1) % 3] == old[l])
          result.seams.push_back({static_cast<Index>(3 * f + k), static_cast<Index>(3 * lone + l)});
  for (Index& v : result.faces[lone]) { v = copy(v); }
  const auto v = verify_cut(input, result);
  BOOST_REQUIRE(v.failures.size() == 1u);
  BOOST_TEST(v.failures.front().find("did not become one disc") != std::string::npos);
  BOOST_TEST(v.components[0].discs == 2);
}

BOOST_FIXTURE_TEST_CASE(a_dropped_component_is_caught, Fixture)
{
  for (std::size_t f = result.faces.size(); f-- > 0;)
  {
    if (result.component_of[f] == 1) { erase_face(f); }
  }
  BOOST_TEST(is_caught("faces of the input are missing"));
  BOOST_TEST(is_caught("components of the input did not become one disc"));
}

BOOST_FIXTURE_TEST_CASE(a_moved_vertex_is_caught_to_the_last_bit, Fixture)
{
  const std::size_t fresh = input.points.size();
  BOOST_REQUIRE(result.copy_of[fresh] < 0);
  result.points[fresh][1] = std::nextafter(result.points[fresh][1], 100);
  BOOST_TEST(is_caught("1 vertices are not at the position of their origin (first: " + std::to_string(fresh) + ")"));
}

BOOST_AUTO_TEST_CASE(nothing_is_not_verified)
{
  Polygon_soup points;
  points.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  Result_mesh same;
  same.points = points.points;
  same.copy_of.assign(3, -1);
  same.origin.resize(3);
  for (Index v = 0; v < 3; ++v) { same.origin[v].index[0] = v; }
  for (const auto& [input, result] : {std::pair(Polygon_soup(), Result_mesh()), {points, same}})
  {
    const Verification v = verify_cut(input, result);
    BOOST_TEST_REQUIRE(v.failures.size() == 1u);
    BOOST_TEST(v.failures.front() == "the input has no face, so nothing can be shown");
  }
}

// The map and the positions are changed alike.
BOOST_FIXTURE_TEST_CASE(weights_that_are_none_are_caught, Fixture)
{
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  const std::size_t f = whole_face();
  const Index v = divide(f, {0.25, 0.25, 0.5});
  BOOST_TEST(verify_cut(input, result).failures.empty());
  for (const std::array<double, 3>& weight : {std::array{3., -1., -1.},
                                              {1., 0.5, 0.5},
                                              {1e6, 1 - 1e6, 0.},
                                              {1., 0., 0.},
                                              {0.25, 0.25, 0.25},
                                              {0.5, 0.5, 0.},
                                              {0.4, 0.4, 0.2 + 1e-14},
                                              {nothing, 0.5, 0.5}})
  {
    place_inside(v, result.face_of[f], weight);
    BOOST_TEST(is_caught("vertices inside faces have weights that are not positive, or that do not add up to 1"));
  }
}

// All that is counted there is that of a disc.
BOOST_FIXTURE_TEST_CASE(faces_that_fold_are_caught, Fixture)
{
  const std::size_t f = whole_face();
  const Index far = divide(f, {0.25, 0.25, 0.5});
  const Index corner = result.faces[f][0]; // of the part that is divided again, and of the triangle
  const std::array<double, 3> near{0.4375, 0.4375, 0.125};
  divide(f, near);
  BOOST_TEST(verify_cut(input, result).failures.empty());
  BOOST_TEST(corner == input.corner(result.face_of[f], 0));
  const char* const failure = "are folded over";
  place_inside(far, result.face_of[f], {0.46875, 0.46875, 0.0625}); // beyond the other
  BOOST_TEST(is_caught(failure));
  place_inside(far, result.face_of[f], near); // on the other
  BOOST_TEST(is_caught(failure));
  place_inside(far, result.face_of[f], {0.4375, 0.4375 - 0x1p-52, 0.125 + 0x1p-52}); // a little above it
  BOOST_TEST(verify_cut(input, result).failures.empty());
}

BOOST_FIXTURE_TEST_CASE(a_pinched_boundary_is_caught, Fixture)
{
  // Two copies of a vertex are made one: the disc touches itself there.
  for (std::size_t v = 0; v < result.points.size(); ++v)
    if (result.copy_of[v] >= 0)
    {
      for (auto& f : result.faces)
      {
        for (Index& c : f)
        {
          if (c == static_cast<Index>(v)) { c = result.copy_of[v]; }
        }
      }
      break;
    }
  BOOST_TEST(is_caught("vertices are pinched"));
}

BOOST_FIXTURE_TEST_CASE(copies_of_the_wrong_vertex_are_caught, Fixture)
{
  for (std::size_t v = 0; v < result.points.size(); ++v)
    if (result.copy_of[v] >= 0)
    {
      result.copy_of[v] = result.copy_of[v] == 0 ? 1 : 0;
      break;
    }
  BOOST_TEST(is_caught("vertices are copies of the wrong vertex"));
}

BOOST_FIXTURE_TEST_CASE(a_copy_of_a_copy_is_caught, Fixture)
{
  const Index v = copy(0), w = copy(0);
  BOOST_TEST(verify_cut(input, result).failures.empty());
  result.copy_of[w] = v;
  BOOST_TEST(is_caught("vertices are copies of the wrong vertex"));
}

BOOST_FIXTURE_TEST_CASE(a_vertex_that_stands_twice_without_being_a_copy_is_caught, Fixture)
{
  const Index v = copy(0);
  result.copy_of[v] = -1;
  BOOST_TEST(is_caught("vertices do not stand in the order of the input"));
  result.copy_of[v] = 0;
  const auto of_edge = std::find_if(result.origin.begin(), result.origin.end(),
                                    [](const Result_origin& o) { return o.kind == Result_origin::EDGE; });
  BOOST_REQUIRE((of_edge != result.origin.end()));
  const Index w = copy(static_cast<Index>(of_edge - result.origin.begin()));
  BOOST_TEST(verify_cut(input, result).failures.empty());
  result.copy_of[w] = -1;
  BOOST_TEST(is_caught("vertices stand twice without being copies"));
}

BOOST_FIXTURE_TEST_CASE(origins_that_are_none_are_caught, Fixture)
{
  const char* const failure = "vertices have a copy or an origin out of range";
  const auto edge = [](const Result_origin& o) { return o.kind == Result_origin::EDGE; };
  Result_origin& o = *std::find_if(result.origin.begin(), result.origin.end(), edge);
  std::swap(o.index[0], o.index[1]); // the lower end comes first: positions are rounded from there
  BOOST_TEST(is_caught(failure));
  std::swap(o.index[0], o.index[1]);
  const Index v = copy(0);
  result.copy_of[v] = v; // itself
  BOOST_TEST(is_caught(failure));
  result.copy_of[v] = 0;
  const std::array<Index, 3> twice{0, 0, 1}; // a face of the input that is left out
  input.add_polygon(twice.data(), 3);
  BOOST_TEST(verify_cut(input, result).failures.empty());
  result.copy_of[v] = -1;
  result.origin[v].kind = Result_origin::FACE;
  result.origin[v].index[0] = static_cast<Index>(input.number_of_polygons()) - 1;
  result.origin[v].weight = {0.25, 0.25, 0.5};
  BOOST_TEST(is_caught(failure));
}

BOOST_FIXTURE_TEST_CASE(seams_that_join_the_wrong_sides_are_caught, Fixture)
{
  const auto seams = result.seams;
  std::swap(result.seams[0][1], result.seams[1][1]);
  BOOST_TEST(is_caught("seams join sides that were not one edge of the input"));
  for (std::size_t first : {0, 1})
    for (std::size_t second : {0, 1}) // each side of a seam may be the one that comes again
    {
      result.seams = seams;
      result.seams[1][second] = result.seams[0][first];
      BOOST_TEST(is_caught("seams use a side that another seam uses"));
    }
}

BOOST_FIXTURE_TEST_CASE(faces_in_another_component_or_chart_are_caught, Fixture)
{
  result.component_of[0] = 1;
  BOOST_TEST(is_caught("faces are said to lie in a component that they do not lie in"));
  result.component_of[0] = 0;
  result.chart_of = result.component_of;
  BOOST_TEST(verify_cut(input, result).failures.empty());
  result.chart_of.push_back(0);
  BOOST_TEST(is_caught("entries for the charts of faces"));
  result.chart_of.pop_back();
  result.chart_of[whole_face()] = 2;
  BOOST_TEST(is_caught("faces are in another chart than what they are joined to"));
}

BOOST_FIXTURE_TEST_CASE(a_face_that_stands_twice_is_caught, Fixture)
{
  const std::size_t f = whole_face();
  result.faces.push_back(result.faces[f]);
  result.face_of.push_back(result.face_of[f]);
  result.component_of.push_back(result.component_of[f]);
  BOOST_TEST(is_caught("faces share an edge with two or more others"));
}

// Its corners are places on one side of a face of the input.
BOOST_FIXTURE_TEST_CASE(a_face_along_a_side_is_caught, Fixture)
{
  bool was_tried = false;
  for (std::size_t f = 0; f < result.faces.size() && !was_tried; ++f)
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Result_origin& o = result.origin[result.faces[f][k]];
      Index& next = result.faces[f][(k + 1) % 3];
      if (was_tried || o.kind != Result_origin::EDGE || next != o.index[0]) { continue; }
      result.faces[f][(k + 2) % 3] = o.index[1];
      was_tried = true;
    }
  BOOST_TEST(was_tried);
  BOOST_TEST(is_caught("faces do not lie on the face of the input that the map gives them"));
}

namespace {

// Three squares along one edge, which are three sheets after they were repaired.
struct Three_sheets : Fixture
{
  Three_sheets()
  {
    input = {};
    input.points = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {1, 0, 1}, {-1, 1, 0}, {-1, 1, 1}, {-1, -1, 0}, {-1, -1, 1}};
    for (const std::array<Index, 3>& t :
         {std::array<Index, 3>{0, 2, 3}, {0, 3, 1}, {0, 5, 4}, {0, 1, 5}, {0, 6, 7}, {0, 7, 1}})
    {
      input.add_polygon(t.data(), 3);
    }
    result = pipeline::run(input, true).assembled.mesh;
  }
};

} // namespace

BOOST_FIXTURE_TEST_CASE(a_repaired_edge_of_three_faces_is_verified, Three_sheets)
{
  const auto v = verify_cut(input, result);
  BOOST_TEST(v.failures.empty());
  BOOST_TEST(v.components.size() == 3U);
}

BOOST_FIXTURE_TEST_CASE(sheets_that_were_kept_apart_and_are_joined_are_caught, Three_sheets)
{
  // the copies of one sheet become the vertices of another
  std::vector<Index> copies;
  for (std::size_t v = 0; v < result.points.size(); ++v)
  {
    if (result.copy_of[v] >= 0) { copies.push_back(static_cast<Index>(v)); }
  }
  BOOST_REQUIRE(copies.size() == 4U);
  const std::set<Index> joined(copies.begin(), copies.begin() + 2);
  for (auto& f : result.faces)
    for (Index& v : f)
    {
      if (joined.count(v)) { v = result.copy_of[v]; }
    }
  BOOST_TEST(is_caught("faces share an edge with a face that is not their neighbour on the input"));
}

// Only across seams do neighbours show it: all faces of one chart are turned over.
BOOST_AUTO_TEST_CASE(a_chart_that_is_turned_over_is_caught)
{
  const Triangle_surface s = sample::sheet(3, 1, [](double x, double y) { return Point{x, y, 0}; });
  const Polygon_soup input = sample::soup(s);
  Result_mesh result;
  result.points = s.points;
  result.faces = s.triangles;
  for (std::size_t v = 0; v < s.points.size(); ++v)
  {
    result.copy_of.push_back(-1);
    result.origin.emplace_back();
    result.origin.back().index[0] = static_cast<Index>(v);
  }
  for (Index f = 0; f < s.number_of_faces(); ++f)
  {
    result.face_of.push_back(f);
    result.component_of.push_back(0);
    result.chart_of.push_back(f < 2 ? 0 : 1);
  }
  for (Index v : {1, 5}) // the edge between the first two squares is cut
  {
    result.points.push_back(s.points[v]);
    result.origin.push_back(result.origin[v]);
    result.copy_of.push_back(v);
    for (std::size_t f = 0; f < 2; ++f)
    {
      std::replace(result.faces[f].begin(), result.faces[f].end(), v, static_cast<Index>(result.points.size()) - 1);
    }
  }
  const Index a = s.find_halfedge(1, 5), b = s.find_halfedge(5, 1);
  result.seams = {{std::min(a, b), std::max(a, b)}};
  BOOST_TEST(verify_cut(input, result).failures.empty());
  for (std::size_t f = 0; f < 2; ++f) { std::swap(result.faces[f][0], result.faces[f][2]); } // side k becomes 1 - k
  for (Index& side : result.seams[0])
  {
    if (side / 3 < 2) { side = side - side % 3 + (4 - side % 3) % 3; }
  }
  const auto v = verify_cut(input, result);
  BOOST_REQUIRE(!v.failures.empty());
  BOOST_TEST(v.failures.front().find("faces are turned against their neighbours") != std::string::npos,
             v.failures.front());
}

BOOST_FIXTURE_TEST_CASE(a_seam_that_is_not_listed_is_caught, Fixture)
{
  result.seams.pop_back();
  BOOST_TEST(is_caught("faces are cut from a neighbour without a seam"));
  BOOST_TEST(is_caught("another Euler characteristic"));
}

BOOST_FIXTURE_TEST_CASE(faces_and_vertices_in_another_order_than_the_input_are_caught, Fixture)
{
  std::swap(result.points[2], result.points[3]);
  std::swap(result.origin[2], result.origin[3]);
  for (auto& f : result.faces)
  {
    for (Index& v : f)
    {
      if (v == 2 || v == 3) { v = 5 - v; }
    }
  }
  BOOST_TEST(is_caught("vertices do not stand in the order of the input"));
}

BOOST_FIXTURE_TEST_CASE(an_uncut_handle_is_caught, Fixture)
{
  result.points.resize(input.points.size());
  result.points = input.points;
  result.origin.resize(input.points.size());
  result.copy_of.assign(input.points.size(), -1);
  result.seams.clear();
  result.faces.clear();
  result.face_of.clear();
  result.component_of.clear();
  for (std::size_t i = 0; i < input.number_of_polygons(); ++i)
  {
    result.faces.push_back({input.corner(i, 0), input.corner(i, 1), input.corner(i, 2)});
    result.face_of.push_back(static_cast<Index>(i));
    result.component_of.push_back(i < input.number_of_polygons() - 32 ? 0 : 1);
  }
  const auto v = verify_cut(input, result);
  BOOST_REQUIRE(v.failures.size() == 1u); // everything else about it is right
  BOOST_TEST(v.failures.front().find("2 components of the input did not become one disc") != std::string::npos);
}

BOOST_FIXTURE_TEST_CASE(a_face_given_to_another_face_of_the_input_is_caught, Fixture)
{
  result.face_of[0] = static_cast<Index>(input.number_of_polygons()) - 1;
  BOOST_TEST(is_caught("faces do not lie on the face of the input"));
}

BOOST_FIXTURE_TEST_CASE(a_map_of_another_mesh_is_caught, Fixture)
{
  result.copy_of.pop_back();
  BOOST_TEST(is_caught("the map is not of this mesh"));
}

BOOST_FIXTURE_TEST_CASE(a_damaged_input_is_caught, Fixture)
{
  input.corners[10] = 1 << 29;
  BOOST_TEST(is_caught("1 faces of the input name a vertex that it does not have (first: 3)"));
}

BOOST_FIXTURE_TEST_CASE(indices_out_of_range_are_caught, Fixture)
{
  result.faces[1][1] = 1 << 30;
  result.origin[4].index[0] = -7;
  result.seams[0][0] = -1;
  BOOST_TEST(is_caught("index out of range"));
  BOOST_TEST(is_caught("origin out of range"));
  BOOST_TEST(is_caught("side out of range"));
}
