// `meridian pack` as a person runs it.
#include <boost/test/unit_test.hpp>

#include "support/run_program.h"
#include "support/sample_surfaces.h"
#include "support/written_meshes.h"

#include "files/Texture_text.h"
#include "files/png.h"

#include <meridian/base/vectors.h>
#include <meridian/proof/verify_packing.h>
#include <meridian/surface/Triangle_surface.h>

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <filesystem>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using namespace meridian;
using written::contains;

namespace {

using Triangles = std::vector<std::array<Index, 3>>;

// Squares beside each other, and above each other in the texture, but for the second, which is mirrored and half as
// large there; the last has no texture coordinates. With a comment, groups, normals and a number that nobody uses.
std::string squares(int count)
{
  std::ostringstream out;
  out << "# squares \t\r\nmtllib some.mtl\nvn 0 0 1\nvt 7.0 07 7 # of no one\n";
  for (int i = 0; i <= count; ++i)
  {
    for (int k = 0; k < 4; ++k) { out << "v " << 2 * i + (k == 1 || k == 2) << ' ' << (k > 1) << " 0\n"; }
    out << "g square" << i << '\n';
    if (i == count)
    {
      out << "f -4//1 -3//1 -2//1 -1//1\n";
      continue;
    }
    for (int k = 0; k < 4; ++k)
    {
      const double u = k == 1 || k == 2, v = k > 1;
      out << "vt  " << (i == 1 ? -0.5 * u : u) << '\t' << (i == 1 ? 0.5 * v : v) << (k == 3 ? " 0.25" : "") << '\n';
    }
    out << "f -4/-4/1 -3/-3/1 -2/-2/1 -1/-1/1\n";
  }
  return out.str();
}

double signed_area(const files::Texture_text& text, const std::array<std::int32_t, 3>& t)
{
  const auto& p = text.texture();
  return cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]) / 2;
}

std::string without_coordinates(const std::string& text)
{
  std::istringstream in(text);
  std::string rest;
  for (std::string line; std::getline(in, line);)
  {
    if (line.compare(0, 3, "vt ") != 0 || contains(line, "of no one")) { rest += line + '\n'; }
  }
  return rest;
}

struct Fixture : program::Workplace
{
  std::string text(const std::string& name) const { return program::read(folder() / name); }
};

} // namespace

BOOST_FIXTURE_TEST_CASE(charts_of_several_meshes_share_a_texture, Fixture)
{
  write("a.obj", squares(3));
  write("b.obj", squares(6));
  for (const std::string options : {"", "--keep-scale", "--density 60 --resolution 256 --padding 6",
                                    "--density 100 --resolution 128 --tiles 9 --padding 4", "--resolution 128x128"})
  {
    const auto r = meridian("pack a.obj b.obj -o c.obj d.obj --report report.json " + options);
    BOOST_TEST(r.status == 0, r.error);
    BOOST_TEST(contains(r.out, "note: a.obj: 1 faces have no texture coordinates"), r.out);
    BOOST_TEST(contains(r.out, "2 meshes, 9 charts"), r.out);
    double side = 0; // of a square in the texture
    for (const auto& [from, to] :
         std::vector<std::pair<std::string, std::string>>{{"a.obj", "c.obj"}, {"b.obj", "d.obj"}})
    {
      BOOST_TEST(without_coordinates(text(from)) == without_coordinates(text(to)));
      BOOST_TEST(contains(text(to), " 0.25\n")); // what stands behind
      const files::Texture_text packed(to, text(to));
      for (std::size_t f = 0; f < packed.texture_triangles().size(); ++f)
      {
        const double area = signed_area(packed, packed.texture_triangles()[f]);
        BOOST_TEST((area < 0) == (f / 2 == 1)); // the mirrored one stays so
        if (side == 0) { side = std::sqrt(2 * area); }
        const double wanted = f / 2 == 1 && options == "--keep-scale" ? side / 2 : side;
        BOOST_TEST(std::sqrt(2 * std::abs(area)) == wanted, boost::test_tools::tolerance(1e-9));
      }
    }
    const auto report = nlohmann::json::parse(text("report.json"));
    if (contains(options, "--density 60")) { BOOST_TEST(side == 60. / 256, boost::test_tools::tolerance(1e-9)); }
    if (options.empty())
    {
      BOOST_TEST(report["density"].get<double>() == 2048 * side, boost::test_tools::tolerance(1e-9));
    }
    BOOST_TEST(report["verified"] == true);
    BOOST_TEST(report["coverage"] > (contains(options, "tiles") ? 0.5 : 0.4 * 0.25));
  }
}

BOOST_FIXTURE_TEST_CASE(a_map_that_was_packed_again_is_still_verified, Fixture)
{
  write("mesh.obj", written::obj(sample::noisy(sample::plate(2, 3), 0.05, 1)));
  BOOST_TEST_REQUIRE(meridian("unwrap mesh.obj -o uv.obj --charts 5 --quiet").status == 0);
  std::filesystem::create_directory(folder() / "packed");
  std::filesystem::copy(folder() / "uv.map.json", folder() / "packed/uv.map.json");
  const auto r = meridian("pack uv.obj -o packed/uv.obj --resolution 512 --padding 8");
  BOOST_TEST(r.status == 0, r.error);
  BOOST_TEST(meridian("verify mesh.obj packed/uv.obj").status == 0);
}

BOOST_FIXTURE_TEST_CASE(several_meshes_are_unwrapped_into_one_texture, Fixture)
{
  const Triangle_surface plate = sample::noisy(sample::plate(2, 3), 0.05, 1);
  write("plate.obj", written::obj(plate));
  write("ball.obj", written::obj(sample::scaled(sample::sphere(3), 2)));
  const auto r =
    meridian("unwrap plate.obj ball.obj -o a.obj b.obj --charts 3 --padding 8 --resolution 512 --report r.json");
  BOOST_TEST(r.status == 0, r.error);
  BOOST_TEST(contains(r.out, "2 meshes in one texture"), r.out);
  BOOST_TEST(meridian("verify plate.obj a.obj").status == 0);
  BOOST_TEST(meridian("verify ball.obj b.obj").status == 0);
  Triangles faces;
  std::vector<Plane_point> texture;
  for (const std::string name : {"a.obj", "b.obj"})
  {
    const files::Texture_text of_mesh(name, text(name));
    const auto first = static_cast<Index>(texture.size());
    for (const auto& t : of_mesh.texture_triangles()) { faces.push_back({t[0] + first, t[1] + first, t[2] + first}); }
    texture.insert(texture.end(), of_mesh.texture().begin(), of_mesh.texture().end());
  }
  BOOST_TEST(verify_packing(faces, texture, 8. / 512).failures.empty());
  const auto report = nlohmann::json::parse(text("r.json"));
  BOOST_TEST_REQUIRE(report["meshes"].size() == 2u);
  BOOST_TEST(report["verified"] == true);
  const auto& texture_of = [&](int i) { return report["meshes"][i]["texture"]; };
  BOOST_TEST(texture_of(0)["density"].get<double>() == texture_of(1)["density"].get<double>(),
             boost::test_tools::tolerance(1e-6));
  BOOST_TEST(texture_of(0)["coverage"].get<double>() + texture_of(1)["coverage"].get<double>() > 0.3);

  // a wish that one of them misses is missed by all, and nothing else is written if one of them cannot be
  BOOST_TEST(meridian("unwrap plate.obj ball.obj -o a.obj b.obj --max-stretch 1.0001").status == 2);
  BOOST_TEST(meridian("unwrap plate.obj none.obj -o c.obj d.obj").status == 1);
  for (const std::string wrong : {"-o c.obj", "-o c.obj c.obj", "-o c.obj ball.obj", "-o c.obj d.obj --svg d.svg",
                                  "-o c.obj d.obj --geometry-image 33", "-o c.obj d.obj --seams paths.txt"})
  {
    BOOST_TEST(meridian("unwrap plate.obj ball.obj " + wrong).status == 64, wrong);
  }
  BOOST_TEST(!std::filesystem::exists(folder() / "c.obj"));
}

BOOST_FIXTURE_TEST_CASE(what_cannot_be_packed_is_refused, Fixture)
{
  write("a.obj", squares(3));
  write("none.obj", written::obj(sample::sphere(1)));
  write("wrong.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nf 1/1 2/2 3/3\n");
  write("infinite.obj", "v 0 0 0\nvt 1e999 0\nf 1/1 1/1 1/1\n");
  write("long.obj", squares(1) + "g \\\n a\n");
  const auto expect = [&](const std::string& arguments, int status, const std::string& message) {
    const auto r = meridian("pack " + arguments);
    BOOST_TEST(r.status == status, arguments);
    BOOST_TEST(contains(r.error, message), r.error);
    BOOST_TEST(!std::filesystem::exists(folder() / "out.obj"));
  };
  expect("none.obj -o out.obj", 1, "no face has texture coordinates");
  expect("wrong.obj -o out.obj", 1, "line 6: a corner names texture vertex 3, and 2 stand above it");
  expect("infinite.obj -o out.obj", 1, "not a finite number");
  expect("long.obj -o out.obj", 1, "behind a backslash");
  expect("a.obj -o out.ply", 1, "OBJ files");
  expect("a.obj none.obj -o out.obj", 64, "as many names");
  expect("a.obj -o a.obj", 64, "written twice, or over a file that is read");
  expect("a.obj a.obj -o out.obj out.obj", 64, "written twice");
  expect("a.obj -o out.obj --keep-scale --density 3", 64, "--keep-scale");
  expect("a.obj -o out.obj --padding 20 --resolution 64", 64, "--padding");
  // a chart that is too large is not drawn in texels to find that out
  for (const std::string density : {"10000", "1e9", "1e20"})
  {
    expect("a.obj -o out.obj --density " + density, 1, "cannot hold all charts");
  }
  expect("a.obj -o out.obj --density nan", 64, "nan is not a number");
  expect("a.obj -o out.obj --padding nan", 64, "nan is not a number");
  write("tiny.obj",
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 5 0 0\nv 6 0 0\nv 6 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 0\nvt 1e-20 0\nvt "
        "1e-20 1e-20\nf 1/1 2/2 3/3\nf 4/4 5/5 6/6\n");
  expect("tiny.obj -o out.obj --keep-scale", 2, "1 faces were turned over or lost their area");
}

BOOST_FIXTURE_TEST_CASE(a_texture_need_not_be_a_square, Fixture)
{
  write("mesh.obj", written::obj(sample::noisy(sample::plate(2, 3), 0.05, 1)));
  const auto stretch_with = [&](const std::string& options) {
    const auto r =
      meridian("unwrap mesh.obj -o uv.obj --charts 3 --report r.json --png board.png --svg layout.svg " + options);
    BOOST_TEST(r.status == 0, r.error);
    BOOST_TEST(meridian("verify mesh.obj uv.obj").status == 0);
    return nlohmann::json::parse(text("r.json"))["components"][0]["parameterization"]["stretch_l2"].get<double>();
  };
  const double square = stretch_with("");
  BOOST_TEST(stretch_with("--resolution 1024x256") == square, boost::test_tools::tolerance(1e-9));
  const auto report = nlohmann::json::parse(text("r.json"));
  BOOST_TEST((report["texture"]["resolution"] == std::vector<int>{1024, 256}));
  const double coverage = report["texture"]["coverage"], density = report["texture"]["density"];
  BOOST_TEST(coverage > 0.25);
  const files::Image board = files::read_png((folder() / "board.png").string());
  BOOST_TEST((board.width == 1024 && board.height == 256));
  const auto packed = meridian("pack uv.obj -o packed.obj --from 1024x256 --resolution 256x512 --report p.json");
  BOOST_TEST(packed.status == 0, packed.error);
  const auto again = nlohmann::json::parse(text("p.json"));
  BOOST_TEST(std::pow(again["density"].get<double>() / density, 2)
               == again["coverage"].get<double>() * 512 / (coverage * 1024),
             boost::test_tools::tolerance(1e-6));
  const files::Texture_text before("uv.obj", text("uv.obj")), after("packed.obj", text("packed.obj"));
  double scale = 0; // of all sides, where texels are squares
  for (const auto& t : after.texture_triangles())
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Plane_point one = before.texture()[t[k]] - before.texture()[t[(k + 1) % 3]],
                        other = after.texture()[t[k]] - after.texture()[t[(k + 1) % 3]];
      const double factor = std::hypot(other[0], 2 * other[1]) / std::hypot(4 * one[0], one[1]);
      if (scale == 0) { scale = factor; }
      BOOST_TEST(factor == scale, boost::test_tools::tolerance(1e-6));
    }
  for (const std::string wrong :
       {"1024x", "1024x15", "x256", "1024x256x3", "1e3", "8", "70000x1024", "64 --padding 20", "1024x64 --padding 20"})
  {
    BOOST_TEST(meridian("unwrap mesh.obj -o uv.obj --resolution " + wrong).status == 64, wrong);
  }
  BOOST_TEST(meridian("unwrap mesh.obj -o uv.obj --resolution 64x128 --geometry-image 33").status == 64);
}

// Islands without area in space or in the texture are packed too, and say nothing about the density.
BOOST_FIXTURE_TEST_CASE(the_density_is_that_of_charts_with_an_area, Fixture)
{
  write("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 5 5\nvt 0 0\nvt 3 0\nvt 0 3\n"
                 "f 1/1 2/2 3/3\nf 1/4 3/4 4/4\nf 1/5 2/6 5/7\n");
  const auto r = meridian("pack a.obj -o b.obj --density 100 --report r.json");
  BOOST_TEST(r.status == 0, r.error);
  BOOST_TEST(nlohmann::json::parse(text("r.json"))["density"].get<double>() == 100, boost::test_tools::tolerance(1e-9));
  write("twice.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 0 2\nv 1 0 2\nv 1 1 2\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                     "f 1/1 2/2 3/3\nf 4/1 5/2 6/3\nf 4/1 5/2 6/3\nf 1/1 3/3 2/4\n");
  BOOST_TEST(contains(meridian("pack twice.obj -o b.obj").out, "note: faces of a chart overlap"));
}

BOOST_AUTO_TEST_CASE(packed_charts_are_recounted)
{
  const Triangles faces{{0, 1, 2}, {2, 3, 4}, {5, 6, 7}}; // the first two are one chart
  const std::vector<Plane_point> apart{{0, 0},   {0.2, 0}, {0.2, 0.2}, {0.1, 0.3},
                                       {0, 0.3}, {0.5, 0}, {0.9, 0},   {0.5, 0.4}};
  BOOST_TEST(verify_packing(faces, apart, 0.29).failures.empty());
  const auto expect = [&](const std::vector<Plane_point>& texture, const std::string& message) {
    const Verification found = verify_packing(faces, texture, 0.1);
    BOOST_TEST_REQUIRE(found.failures.size() == 1u);
    BOOST_TEST(contains(found.failures[0], message), found.failures[0]);
  };
  BOOST_TEST(!verify_packing(faces, apart, 0.31));
  BOOST_TEST(verify_packing(faces, apart, {3 * 0.29, 3, 100}).failures.empty()); // to the right
  BOOST_TEST(!verify_packing(faces, apart, {3 * 0.31, 3, 100}));
  BOOST_TEST(!verify_packing(faces, apart, {100 * 0.29, 3, 100}));
  auto above = apart;
  for (Plane_point& p : above) { std::swap(p[0], p[1]); }
  BOOST_TEST(verify_packing(faces, above, {3 * 0.29, 100, 3}).failures.empty());
  BOOST_TEST(!verify_packing(faces, above, {3 * 0.31, 100, 3}));
  auto moved = apart;
  for (std::size_t v = 5; v < 8; ++v) { moved[v][0] -= 0.25; }
  expect(moved, "nearer to another chart");
  moved = apart;
  moved[6][0] = 1.01;
  expect(moved, "not in one tile");
  moved = apart;
  moved[5] = {0.05, 0.01};
  for (std::size_t v = 0; v < 5; ++v) { moved[v] = {0.7 + 0.01 * apart[v][0], 0.13 + 0.01 * apart[v][1]}; }
  moved[7] = {0.9, 0.6};
  expect(moved, "inside others");
  for (const std::vector<Plane_point>* texture : {&std::as_const(moved), &apart}) // in another tile
  {
    auto other = *texture;
    for (Plane_point& p : other) { p = p + Plane_point{7, 1}; }
    BOOST_TEST(static_cast<bool>(verify_packing(faces, other, 0.1, 20)) == (texture == &apart));
    BOOST_TEST(!verify_packing(faces, other, 0.1, 17));
  }
  moved = apart; // beside each other, in two tiles
  for (std::size_t v = 0; v < 8; ++v) { moved[v][0] += v < 5 ? 0.79 : 0.5; }
  BOOST_TEST(verify_packing(faces, moved, 0.1, 2).failures.empty());
}
