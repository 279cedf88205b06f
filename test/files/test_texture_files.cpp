#include "support/pipeline.h"
#include "support/unwrapped_samples.h"

#include "files/Mesh_attributes.h"
#include "files/write_texture.h"

#include <meridian/base/Polygon_soup.h>
#include <meridian/base/Result_mesh.h>
#include <meridian/base/vectors.h>
#include <meridian/cut/Cut_options.h>
#include <meridian/map/planar_map.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/unwrap/internal/Unwrapper.h>

using namespace meridian;
using namespace unwrapped;

namespace {

// What is read back from an unwrapped mesh.
struct Unwrapped
{
  Result_mesh mesh;
  Texture texture;
  std::vector<Index> vertex_of;
  Index vertices = 0;
};

// A folder to read unwrapped meshes from.
struct Obj_folder : Folder
{
  Unwrapped read(const std::string& name, const std::string& bytes) const
  {
    Unwrapped u;
    files::read_unwrapped(write(name, bytes), u.mesh, u.texture, u.vertex_of, u.vertices);
    return u;
  }
  std::string refusal(const std::string& bytes) const
  {
    return message_of([&] { read("a.obj", bytes); });
  }
};

} // namespace

// Known answer: a square whose chart is whole is one face, in the order of the file; one that a seam divides is two.
BOOST_AUTO_TEST_CASE(polygons_are_kept_unless_a_seam_divides_them)
{
  Polygon_soup soup;
  soup.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, -0.}, {0, 0.1, 1e-300}};
  const Index square[] = {3, 0, 1, 2};
  soup.add_polygon(square, 4);
  Result_mesh whole;
  whole.points = soup.points;
  whole.copy_of.assign(4, -1);
  whole.faces = {{0, 1, 2}, {0, 2, 3}};
  whole.face_of = {0, 0};
  const Texture texture{{0, 0}, {1, 0}, {1, 1}, {0, 0.1}};
  const std::string points = "v 0 0 0\nv 1 0 0\nv 1 1 -0\nv 0 0.1 1e-300\n",
                    places = "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 0.1\n";
  BOOST_TEST(files::format_unwrapped(soup, whole, texture, {}, "") == points + places + "f 4/4 1/1 2/2 3/3\n");
  BOOST_TEST(files::format_unwrapped(soup, whole, texture, {}, "m.mtl")
             == "mtllib m.mtl\n" + points + places + "usemtl checkerboard\nf 4/4 1/1 2/2 3/3\n");

  Result_mesh divided = whole;
  divided.points.insert(divided.points.end(), {soup.points[0], soup.points[2]});
  divided.copy_of.insert(divided.copy_of.end(), {0, 2});
  divided.faces[1] = {4, 5, 3};
  Texture more = texture;
  more.insert(more.end(), {{0.5, 0.25}, {0.125, 1}});
  BOOST_TEST(files::format_unwrapped(soup, divided, more, {}, "")
             == points + places + "vt 0.5 0.25\nvt 0.125 1\nf 1/1 2/2 3/3\nf 1/5 3/6 4/4\n");

  // Only one end of the diagonal has two places; a triangle is missing; a triangle is turned; the fan is another; there
  // is a part too many.
  for (const auto& faces : std::vector<std::vector<std::array<Index, 3>>>{{{0, 1, 2}, {4, 2, 3}},
                                                                          {{0, 1, 2}, {0, 5, 3}},
                                                                          {{0, 1, 2}},
                                                                          {{0, 1, 2}, {0, 3, 2}},
                                                                          {{1, 2, 3}, {1, 3, 0}},
                                                                          {{0, 1, 2}, {0, 2, 3}, {4, 5, 3}}})
  {
    Result_mesh other = divided;
    other.faces = faces;
    other.face_of.assign(faces.size(), 0);
    BOOST_TEST(count(files::format_unwrapped(soup, other, more, {}, ""), "\nf ") == faces.size());
  }
  BOOST_TEST(files::format_material("c.png") == "newmtl checkerboard\nKd 1 1 1\nmap_Kd c.png\n");
}

struct Written_obj : Obj_folder
{
  // Reading undoes writing, to the last bit, whatever the coordinates are, packed or not.
  void check(const Polygon_soup& soup, const Result_mesh& mesh, std::size_t lines, const Texture& texture) const
  {
    const std::string text = files::format_unwrapped(soup, mesh, texture, {}, "x.mtl");
    BOOST_TEST(count(text, "\nf ") == lines);
    for (const char* name : {"a.obj", "a.obj.gz"})
    {
      const Unwrapped u = read(name, text);
      BOOST_TEST((u.texture == texture));
      BOOST_TEST((u.mesh.points == mesh.points));
      BOOST_TEST((u.mesh.faces == mesh.faces));
      BOOST_TEST(u.vertices == std::count(mesh.copy_of.begin(), mesh.copy_of.end(), -1));
      for (std::size_t v = 0; v < mesh.points.size(); ++v)
      {
        BOOST_TEST(u.vertex_of[v] == base(mesh, static_cast<Index>(v)));
      }
    }
  }
};

// Theorem: reading undoes writing, to the last bit, whatever the coordinates are, packed or not.
BOOST_FIXTURE_TEST_CASE(an_unwrapped_mesh_is_read_back_as_it_was, Written_obj)
{
  const Torus torus = opened_torus(5, 4);
  check(torus.soup, torus.mesh, 20, torus.texture);
  const Triangle_surface ball = sample::noisy(sample::sphere(1), 0.1, 3);
  const Result_mesh charts = opened_into_charts(ball, [](Index f) { return f % 3; });
  check(sample::soup(ball), charts, 32, random_texture(charts, 7));
  for (const bool on_edges : {false, true})
  {
    Cut_options options;
    options.on_edges = on_edges;
    const Polygon_soup soup = sample::soup(sample::noisy(sample::plate(2, 3), 0.01, 5));
    const auto run = pipeline::run(soup, false, options);
    BOOST_REQUIRE(run.verification);
    check(soup, run.assembled.mesh, run.assembled.mesh.faces.size(), random_texture(run.assembled.mesh, 7));
  }
}

// Squares, cut along edges that are theirs or divide them: those with a vertex or a seam inside come as triangles, all
// others stay.
BOOST_FIXTURE_TEST_CASE(a_square_without_a_seam_inside_stays_one_face, Written_obj)
{
  Polygon_soup squares;
  const Triangle_surface plate = sample::plate(1, 3);
  squares.points = plate.points;
  for (Index f = 0; f < plate.number_of_faces(); f += 2)
  {
    const auto &a = plate.triangles[f], &b = plate.triangles[f + 1];
    const Index q[] = {a[0], a[1], a[2], b[2]};
    squares.add_polygon(q, 4);
  }
  Cut_options options;
  options.on_edges = true;
  const Result_mesh mesh = pipeline::run(squares, false, options).assembled.mesh;
  Triangle_surface disc;
  disc.points = mesh.points;
  disc.triangles = mesh.faces;
  connect(disc);
  const Texture texture = pipeline::map(disc).at;
  std::vector<std::map<Index, Index>> place_of(squares.number_of_polygons()); // of each corner in the plane
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
  {
    for (Index v : mesh.faces[f]) { place_of[mesh.face_of[f]][base(mesh, v)] = v; }
  }
  const auto is_convex = [&](std::size_t i) {
    const auto at = [&](std::size_t k) { return texture[place_of[i][squares.corner(i, k % 4)]]; };
    for (std::size_t k = 0; k < 4; ++k)
    {
      if (orientation_of(at(k), at(k + 1), at(k + 2)) <= 0) { return false; }
    }
    return true;
  };
  std::vector<std::set<Index>> corners(squares.number_of_polygons());
  std::vector<std::size_t> parts(squares.number_of_polygons());
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
  {
    corners[mesh.face_of[f]].insert(mesh.faces[f].begin(), mesh.faces[f].end());
    ++parts[mesh.face_of[f]];
  }
  std::size_t lines = 0, kept = 0;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    const bool is_kept = parts[i] == 2 && corners[i].size() == 4 && is_convex(i);
    lines += is_kept ? 1 : parts[i];
    kept += is_kept;
  }
  BOOST_TEST(kept > parts.size() / 2);
  check(squares, mesh, lines, texture);
}

BOOST_FIXTURE_TEST_CASE(obj_of_other_programs_is_read, Obj_folder)
{
  // Normals, negative indices, a third texture coordinate, a texture vertex that only stands beside its vertex, and CR.
  const Unwrapped u = read("a.obj", "v 0 0 0 1\nv 1 0 0\r\nv 1 1 0\nv 0 1 0\nvt 0 0 0\nvt 1 0\nvt 0.5 1 # a "
                                    "comment\nvt 0 1\nvn 0 0 1\nf 4/3/1 -3/-3/1 -2/1\n");
  BOOST_TEST((u.mesh.faces == std::vector<std::array<Index, 3>>{{2, 1, 0}}));
  BOOST_TEST((u.vertex_of == std::vector<Index>{2, 1, 3, 3}));
  BOOST_TEST((u.mesh.points == std::vector<Point>{{1, 1, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 0}}));
  BOOST_TEST(u.vertices == 4);
}

BOOST_FIXTURE_TEST_CASE(obj_that_is_no_unwrapped_mesh_is_refused_with_its_line, Obj_folder)
{
  const std::string head = "v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\n";
  const auto bad = [&](const std::string& more, const std::string& message) {
    const std::string refused = refusal(head + more);
    BOOST_TEST(contains(refused, message), "'" << refused << "'");
    BOOST_TEST(contains(refused, "a.obj"), refused);
  };
  BOOST_TEST(refusal(head + "f 1/1 2/2 3/3\n") == "");
  bad("f 1/1 2 3/3\n", "line 7: the corner '2' has no texture vertex");
  bad("f 1//1 2//1 3//1\n", "line 7: the corner '1//1' has no texture vertex");
  bad("\nf 1/1 2/2 3/4\n", "line 8: a corner names texture vertex 4, and 3 stand above it");
  bad("f 1/1 4/2 3/3\n", "line 7: a corner names vertex 4, and 3 stand above it");
  bad("f 0/1 2/2 3/3\n", "line 7: a corner names vertex 0, and 3 stand above it");
  bad("f 1/1 2/-4 3/3\n", "line 7: a corner names texture vertex -4, and 3 stand above it");
  bad("f 1/1 99999999999/2 3/3\n", "line 7: a corner names vertex 99999999999");
  bad("f 1/1 2/2 3/x\n", "line 7: expected texture vertex, found 'x'");
  bad("f 1/1 2/2 3/3\nf 1/1 3/2 2/2\n", "line 8: texture vertex 2 is used with vertex 2 and with vertex 3");
  bad("f 1/1 2/2\n", "line 7: a face has 2 corners");
  bad("v 0 nan 0\nf 1/1 2/2 4/3\n", "line 8: a corner names a vertex with a coordinate that is not a finite number");
  BOOST_TEST(refusal(head + "v 0 nan 0\nf 1/1 2/2 3/3\n") == ""); // of no face
  bad("vt inf 0\n", "line 7: a texture vertex has a coordinate that is not a finite number");
  bad("vt 1\n", "line 7: a texture vertex has fewer than 2 coordinates");
  bad("v 1 2\n", "line 7: a vertex has fewer than 3 coordinates");
  bad("vt 0 0\nf 1/1 2/2 3/3\n", "no corner names texture vertex 4, and there is no vertex of that number");
  bad("", "the file has no faces");
  BOOST_TEST(contains(message_of([&] { read("a.off", "OFF\n"); }), "are OBJ files"));
}
