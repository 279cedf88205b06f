#include "support/pipeline.h"
#include "support/sample_surfaces.h"

#include <meridian/base/Polygon_soup.h>
#include <meridian/base/Result_mesh.h>
#include <meridian/base/vectors.h>
#include <meridian/proof/verify_cut.h>
#include <meridian/result/recount.h>

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

BOOST_FIXTURE_TEST_CASE(seams_that_join_the_wrong_sides_are_caught, Fixture)
{
  std::swap(result.seams[0][1], result.seams[1][1]);
  BOOST_TEST(is_caught("seams join sides that were not one edge of the input"));
  result.seams.push_back(result.seams.back());
  BOOST_TEST(is_caught("seams use a side that another seam uses"));
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
