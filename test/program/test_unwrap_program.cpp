// `meridian unwrap` and `compare` as a person runs them.
#include <boost/test/unit_test.hpp>

#include "support/run_program.h"
#include "support/sample_surfaces.h"
#include "support/written_meshes.h"

#include "files/Mesh_attributes.h"
#include "files/Texture_text.h"
#include "files/png.h"
#include "files/read_mesh.h"
#include "files/write_mesh.h"

#include <meridian/base/Polygon_soup.h>
#include <meridian/base/Result_mesh.h>
#include <meridian/base/vectors.h>
#include <meridian/surface/Triangle_surface.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <functional>
#include <sstream>
#include <utility>

using namespace meridian;
using written::contains;
using written::obj;

namespace {

std::vector<std::string> lines_of(const std::string& text, const std::string& key)
{
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
  {
    if (line.compare(0, key.size() + 1, key + " ") == 0) { lines.push_back(line); }
  }
  return lines;
}

struct Fixture : program::Workplace
{
  Fixture() { write("mesh.obj", obj(sample::noisy(sample::punctured(sample::plate(2, 4), {30}), 0.05, 1))); }
  nlohmann::json json(const std::string& name) const { return nlohmann::json::parse(program::read(folder() / name)); }
  std::string text(const std::string& name) const { return program::read(folder() / name); }
};

} // namespace

BOOST_FIXTURE_TEST_CASE(an_unwrapping_writes_its_files_and_verify_agrees, Fixture)
{
  const auto r = meridian("unwrap mesh.obj -o uv.obj --report report.json --svg layout.svg --png board.png "
                          "--distortion faces.vtp --curves curves.obj --view page.html");
  BOOST_TEST(r.status == 0, r.error);
  BOOST_TEST(r.error == "");
  BOOST_TEST(contains(r.out, "no face is turned over"));
  BOOST_TEST(number_of_files() == 10u); // those named, the map and the material
  const auto report = json("report.json");
  BOOST_TEST(report["verified"] == true);
  const auto& p = report["components"][0]["parameterization"];
  BOOST_TEST(p["method"] == "symmetric-dirichlet");
  BOOST_TEST(p["flipped"] == 0);
  BOOST_TEST(p["one_to_one"] == true);
  for (const char* key : {"stretch_l2", "stretch_linf", "conformal", "areal"})
  {
    BOOST_TEST(p[key].get<double>() >= 1);
  }
  for (const char* key : {"angle", "area"}) { BOOST_TEST(p[key].get<double>() > 0); }
  BOOST_TEST(report["texture"]["coverage"].get<double>() > 0.2);

  // One v a vertex: the file's first, as they stood.
  const auto before = lines_of(text("mesh.obj"), "v"), after = lines_of(text("uv.obj"), "v"),
             coordinates = lines_of(text("uv.obj"), "vt");
  BOOST_TEST_REQUIRE(after.size() >= before.size());
  for (std::size_t i = 0; i < before.size(); ++i) { BOOST_TEST(before[i] == after[i]); }
  BOOST_TEST(coordinates.size() == report["texture"]["coordinates"]);
  BOOST_TEST(coordinates.size() > after.size()); // seams
  const auto faces = lines_of(text("uv.obj"), "f");
  BOOST_TEST(contains(text("uv.obj"), "mtllib uv.mtl\n"));
  BOOST_TEST(contains(text("uv.mtl"), "map_Kd board.png"));
  BOOST_TEST(files::read_png((folder() / "board.png").string()).width == 1024);
  BOOST_TEST(contains(text("faces.vtp"), "Name=\"stretch_l2\""));
  BOOST_TEST(files::read_mesh((folder() / "faces.vtp").string()).number_of_polygons() == faces.size());

  const auto verify = meridian("verify mesh.obj uv.obj --report verified.json");
  BOOST_TEST(verify.status == 0, verify.error);
  BOOST_TEST(contains(verify.out, "no face is turned over in the plane"));
  BOOST_TEST(json("verified.json")["components"][0]["cut"]["euler_characteristic"] == 1);

  const std::string first =
    text("uv.obj") + text("uv.map.json") + text("layout.svg") + text("page.html") + text("board.png");
  BOOST_TEST(meridian("unwrap mesh.obj -o uv.obj --svg layout.svg --png board.png --view page.html --quiet").out == "");
  // to the byte
  BOOST_TEST(
    (first == text("uv.obj") + text("uv.map.json") + text("layout.svg") + text("page.html") + text("board.png")));
}

BOOST_FIXTURE_TEST_CASE(on_edges_the_mesh_comes_back_unchanged_but_for_its_coordinates, Fixture)
{
  // Quadrangles and a triangle: a torus of 12 x 8 of them.
  std::string mesh;
  const Triangle_surface t = sample::torus(12, 8);
  for (const Point& p : t.points)
  {
    mesh += "v " + std::to_string(p[0]) + ' ' + std::to_string(p[1]) + ' ' + std::to_string(p[2]) + '\n';
  }
  for (int i = 0; i < 12; ++i)
    for (int j = 0; j < 8; ++j)
    {
      const auto at = [&](int a, int b) { return std::to_string((a % 12) * 8 + b % 8 + 1); };
      if (i + j == 0)
      {
        mesh += "f " + at(0, 0) + ' ' + at(1, 0) + ' ' + at(1, 1) + "\nf " + at(0, 0) + ' ' + at(1, 1) + ' ' + at(0, 1)
                + '\n';
      }
      else { mesh += "f " + at(i, j) + ' ' + at(i + 1, j) + ' ' + at(i + 1, j + 1) + ' ' + at(i, j + 1) + '\n'; }
    }
  write("quads.obj", mesh);
  BOOST_TEST_REQUIRE(meridian("unwrap quads.obj -o uv.obj --on-edges --tighten graph --quiet").status == 0);
  BOOST_TEST(meridian("verify quads.obj uv.obj --quiet").status == 0);
  const auto before = lines_of(mesh, "v"), after = lines_of(text("uv.obj"), "v");
  BOOST_TEST(before.size() == after.size());
  std::size_t whole = 0, next = 0;
  const auto faces = lines_of(text("uv.obj"), "f"), old = lines_of(mesh, "f");
  for (const std::string& line : old)
  {
    BOOST_TEST_REQUIRE(next < faces.size());
    std::istringstream in(faces[next]);
    std::string plain, word;
    while (in >> word) { plain += (plain.empty() ? "" : " ") + word.substr(0, word.find('/')); }
    if (plain == line)
    {
      ++whole;
      ++next;
    }
    else { next += 2; } // a seam divides it
  }
  BOOST_TEST(next == faces.size());
  BOOST_TEST(whole > old.size() * 3 / 4);

  BOOST_TEST_REQUIRE(meridian("unwrap mesh.obj -o uv.obj --on-edges --quiet").status == 0);
  BOOST_TEST((lines_of(text("mesh.obj"), "v") == lines_of(text("uv.obj"), "v")));
}

BOOST_FIXTURE_TEST_CASE(a_result_that_was_changed_is_not_verified, Fixture)
{
  BOOST_TEST_REQUIRE(meridian("unwrap mesh.obj -o uv.obj --quiet").status == 0);
  const std::string good = text("uv.obj");
  const auto expect = [&](const std::string& bytes, const std::string& reason) {
    write("uv.obj", bytes);
    const auto v = meridian("verify mesh.obj uv.obj");
    BOOST_TEST(v.status != 0);
    BOOST_TEST(contains(v.error, reason), v.error);
  };
  const std::size_t at = good.find("\nvt ") + 4, end = good.find('\n', at);
  expect(good.substr(0, at) + "0.99 0.99" + good.substr(end), "turned over");
  expect(good.substr(0, at) + "3 4" + good.substr(end), "not in one tile");
  const std::size_t point = good.find("v ");
  expect(good.substr(0, point) + "v 9 9 9" + good.substr(good.find('\n', point)), "not at the position");
  const std::size_t face = good.find("\nf ") + 1;
  expect(good.substr(0, face) + good.substr(good.find('\n', face) + 1), "not of this mesh");
}

BOOST_FIXTURE_TEST_CASE(every_method_of_the_program_is_verified, Fixture)
{
  for (const std::string option :
       {"--parameterization conformal", "--parameterization conformal --charts auto",
        "--parameterization authalic --border square", "--parameterization mean-value",
        "--parameterization tutte --border square --on-edges", "--parameterization positive", "--border square",
        "--parameterization stretch --border square", "--border circle", "--family 3", "--family 3 --stretch-weight 1",
        "--max-stretch 1.02", "--method generators"})
  {
    const auto r = meridian("unwrap mesh.obj -o uv.obj --report report.json " + option);
    BOOST_TEST(r.status == 0, option + ": " + r.error);
    const auto verify = meridian("verify mesh.obj uv.obj");
    BOOST_TEST(verify.status == 0, option + ": " + verify.error);
    const auto p = json("report.json")["components"][0]["parameterization"];
    if (contains(option, "--family")) { BOOST_TEST(p["family"].size() == 3u); }
    if (contains(option, "--border square") && !contains(option, "on-edges"))
    {
      BOOST_TEST(p["border"] == "square", option);
    }
    if (p["attempts"].size() > 1) { BOOST_TEST(contains(r.out, "note: component 0: mapped by"), option); }
  }
}

BOOST_FIXTURE_TEST_CASE(geometry_images_are_written_and_come_back, Fixture)
{
  write("torus.obj", obj(sample::torus(24, 16)));
  const auto r = meridian("unwrap torus.obj -o uv.obj --geometry-image 65 --report report.json");
  BOOST_TEST_REQUIRE(r.status == 0, r.error);
  BOOST_TEST(meridian("verify torus.obj uv.obj").status == 0);
  const auto image = json("report.json")["geometry_image"];
  BOOST_TEST(image["genus"] == 1);
  BOOST_TEST(image["boundary_loops"] == 0);
  BOOST_TEST(image["psnr"].get<double>() > 50);
  BOOST_TEST(image["hausdorff"].get<double>() > 0);
  const auto png = files::read_png((folder() / "uv.geometry.png").string());
  BOOST_TEST(png.width == 65);
  BOOST_TEST(png.height == 65);
  BOOST_TEST(png.bits == 16);
  BOOST_TEST(png.channels == 3);
  // The lower left pixel is the point with the texture coordinates (0, 0).
  const auto remesh = files::read_mesh((folder() / "uv.remesh.obj").string());
  BOOST_TEST(remesh.number_of_polygons() == 2u * 64 * 64);
  BOOST_TEST(contains(meridian("info uv.remesh.obj").out, "genus 1"));
  const auto small = meridian("unwrap mesh.obj -o no.obj --geometry-image 5");
  BOOST_TEST(small.status == 1);
  BOOST_TEST(contains(small.error, "least size"));
  write("two.obj", obj(sample::torus(8, 6)) + "v 9 0 0\nv 9 1 0\nv 9 0 1\nf 49 50 51\n");
  const auto two = meridian("unwrap two.obj -o no.obj --geometry-image 33");
  BOOST_TEST(two.status == 1);
  BOOST_TEST(contains(two.error, "one component"));
  BOOST_TEST(meridian("unwrap two.obj -o two_uv.obj --quiet").status == 0);
  BOOST_TEST(meridian("verify two.obj two_uv.obj").status == 0);
}

BOOST_FIXTURE_TEST_CASE(two_cuts_are_compared, Fixture)
{
  write("torus.obj", obj(sample::torus(40, 24)));
  BOOST_TEST_REQUIRE(meridian("cut torus.obj -o a.off --tighten curves --quiet").status == 0);
  BOOST_TEST_REQUIRE(meridian("unwrap torus.obj -o b.obj --method tree-cotree --quiet").status == 0);
  const auto r = meridian("compare torus.obj --cut a.off --cut b.obj --report report.json");
  BOOST_TEST(r.status == 0, r.error);
  const auto c = json("report.json")["components"][0];
  BOOST_TEST(c["untouched"] > 100);
  BOOST_TEST(c["bound"].get<double>() > 0);
  BOOST_TEST(c["bound"].get<double>() <= c["variation"].get<double>());
  BOOST_TEST(c["maps"].size() == 2u);
  // the first of the family is the cut as chosen
  const auto same = meridian("compare torus.obj --cut a.off --cut 0 --report report.json --quiet");
  BOOST_TEST(same.status == 0);
  BOOST_TEST(json("report.json")["components"][0]["variation"].get<double>() < 1e-12);
  BOOST_TEST(meridian("compare torus.obj --cut 0 --cut 2 --weights cotangent --quiet").status == 0);
  const auto wrong = meridian("compare mesh.obj --cut a.off --cut 0");
  BOOST_TEST(wrong.status == 2);
  BOOST_TEST(contains(wrong.error, "a.off"));
  BOOST_TEST(meridian("compare torus.obj --cut 0").status == 64);
  write("small.obj", obj(sample::torus(4, 3)));
  const auto many = meridian("compare small.obj --cut 0 --cut 999");
  BOOST_TEST(many.status == 64);
  BOOST_TEST(contains(many.error, "members"), many.error);
  BOOST_TEST(meridian("compare torus.obj --cut 0 --cut none.off").status == 1);
}

// A wish that is missed is said everywhere, and nothing is called verified beside it.
BOOST_FIXTURE_TEST_CASE(a_missed_stretch_ends_with_its_own_status, Fixture)
{
  write("ball.obj", obj(sample::sphere(2)));
  const auto met = meridian("unwrap ball.obj -o uv.obj --max-stretch 1.05 --report report.json");
  BOOST_TEST(met.status == 0, met.error);
  BOOST_TEST(contains(met.out, "verified: "), met.out);
  BOOST_TEST(contains(met.out, "note: component 0: the cut was extended to "), met.out);
  const auto good = json("report.json");
  BOOST_TEST(good["verified"] == true);
  BOOST_TEST(good["missed"].empty());
  BOOST_TEST(good["components"][0]["parameterization"]["extended_to"] > 0);
  BOOST_TEST(good["components"][0]["parameterization"]["stretch_l2"] <= 1.05);
  const auto missed = meridian("unwrap ball.obj -o uv.obj --max-stretch 1 --report report.json");
  BOOST_TEST(missed.status == 2);
  BOOST_TEST(!contains(missed.out, "verified"), missed.out);
  BOOST_TEST(contains(missed.error, "not met: component 0: the L2 stretch is 1.0"), missed.error);
  BOOST_TEST(contains(missed.error, "extended to "), missed.error);
  BOOST_TEST(json("report.json")["verified"] == false);
  BOOST_TEST(json("report.json")["missed"].size() == 1u);
  BOOST_TEST(meridian("verify ball.obj uv.obj").status == 0); // the file is written, and right
  const auto quiet = meridian("unwrap ball.obj -o uv.obj --max-stretch 1 --quiet");
  BOOST_TEST(quiet.status == 2);
  BOOST_TEST(contains(quiet.error, "not met"), quiet.error);
}

// What cannot be written is found before the mesh is even read, and leaves nothing behind.
BOOST_FIXTURE_TEST_CASE(a_missing_folder_is_found_at_once, Fixture)
{
  write("broken.obj", "v 1\n");
  for (const std::string option : {"--png", "--svg", "--view", "--report", "--curves"})
  {
    const auto r = meridian("unwrap broken.obj -o uv.obj " + option + " none/file.png");
    BOOST_TEST(r.status == 1);
    BOOST_TEST(contains(r.error, "none/file.png: cannot be written: No such file"), r.error);
    const auto cut = meridian("cut broken.obj -o none/file.obj");
    BOOST_TEST(cut.status == 1);
    BOOST_TEST(contains(cut.error, "none/file.obj: cannot be written: No such file"), cut.error);
  }
  BOOST_TEST(contains(meridian("unwrap broken.obj -o uv.obj").error, "broken.obj"));
  BOOST_TEST(number_of_files() == 2u);
}

// The end of a tube shrinks to what single precision cannot tell apart, while double precision can.
BOOST_FIXTURE_TEST_CASE(faces_that_vanish_in_single_precision_are_counted, Fixture)
{
  write("tube.obj", obj(sample::tube_with_cap(8, 56)));
  const auto r = meridian("unwrap tube.obj -o uv.obj --parameterization positive --report report.json");
  BOOST_TEST(r.status == 0, r.error);
  const auto report = json("report.json");
  BOOST_TEST(report["components"][0]["parameterization"]["method"] == "positive");
  const int flipped = report["texture"]["flipped_in_single_precision"];
  BOOST_TEST(flipped > 50);
  BOOST_TEST(flipped < 1000);
  BOOST_TEST(contains(r.out, "read in single precision, the coordinates leave " + std::to_string(flipped) + " faces"));
  const auto low = meridian("unwrap tube.obj -o uv.obj --report report.json");
  BOOST_TEST(low.status == 0, low.error);
  BOOST_TEST(json("report.json")["texture"]["flipped_in_single_precision"] == 0);
  BOOST_TEST(!contains(low.out, "single precision"), low.out);
}

BOOST_FIXTURE_TEST_CASE(a_map_that_smears_is_warned_of, Fixture)
{
  write("torus.obj", obj(sample::thorny_torus(8)));
  const auto r = meridian("unwrap torus.obj -o uv.obj --parameterization tutte --report report.json");
  BOOST_TEST(r.status == 0, r.error);
  BOOST_TEST(contains(r.out, "WARNING: stretched to more than 2"), r.out);
  BOOST_TEST(contains(r.out, "warning: component 0: the L2 stretch is "), r.out);
  BOOST_TEST(json("report.json")["warnings"].size() == 1u);
  const auto fair = meridian("unwrap torus.obj -o uv.obj --shortest-seams --report report.json");
  BOOST_TEST(fair.status == 0, fair.error);
  BOOST_TEST(!contains(fair.out, "arning"), fair.out);
  BOOST_TEST(json("report.json")["warnings"].empty());
  const double shortest = json("report.json")["components"][0]["cut"]["length"];
  BOOST_TEST(meridian("unwrap torus.obj -o uv.obj --report report.json").status == 0);
  BOOST_TEST(json("report.json")["components"][0]["cut"]["length"] > shortest);
}

BOOST_FIXTURE_TEST_CASE(a_mesh_is_divided_into_charts_and_recounted, Fixture)
{
  for (const std::string option :
       {"--charts 5", "--charts auto --max-stretch 1.01", "--charts 3 --on-edges --map cbor"})
  {
    const auto r =
      meridian("unwrap mesh.obj -o uv.obj --report report.json --svg uv.svg --view uv.html --curves c.obj " + option);
    BOOST_TEST_REQUIRE(r.status == 0, option + r.error);
    const auto report = json("report.json");
    const int charts = report["components"][0]["parameterization"]["charts"];
    BOOST_TEST(report["verified"] == true);
    BOOST_TEST(contains(r.out, "boundary loops; " + std::to_string(charts) + " charts, cut length"), r.out);
    BOOST_TEST((option[9] == 'a' || charts == option[9] - '0'));
    BOOST_TEST(report["components"][0]["cut"]["arcs"].size() == static_cast<std::size_t>(charts) - 1);
    BOOST_TEST(report["components"][0]["cut"]["euler_characteristic"] == charts);
    const auto v = meridian("verify mesh.obj uv.obj");
    BOOST_TEST(v.status == 0, v.error);
    BOOST_TEST(contains(v.out, "became " + std::to_string(charts) + " piece"), v.out);
    BOOST_TEST(lines_of(text("c.obj"), "g").size() >= static_cast<std::size_t>(charts) - 1);
    std::filesystem::remove(folder() / "uv.map.json");
    std::filesystem::remove(folder() / "uv.map.cbor");
  }
}

// The claim that charts are discs is in the map, and is not believed.
BOOST_FIXTURE_TEST_CASE(a_map_that_says_nothing_of_charts_is_not_verified_beside_them, Fixture)
{
  BOOST_TEST_REQUIRE(meridian("unwrap mesh.obj -o uv.obj --charts 4").status == 0);
  auto map = json("uv.map.json");
  BOOST_TEST_REQUIRE(map.contains("chart_of"));
  auto claim = map;
  claim["chart_of"][0] = 1 - claim["chart_of"][0].get<int>();
  write("uv.map.json", claim.dump());
  BOOST_TEST(contains(meridian("verify mesh.obj uv.obj").error, "in another chart"));
  map.erase("chart_of");
  write("uv.map.json", map.dump());
  const auto r = meridian("verify mesh.obj uv.obj");
  BOOST_TEST(r.status == 2);
  BOOST_TEST(contains(r.error, "did not become one disc"), r.error);
  BOOST_TEST_REQUIRE(meridian("unwrap mesh.obj -o uv.obj").status == 0);
  BOOST_TEST(!json("uv.map.json").contains("chart_of"));
}

BOOST_FIXTURE_TEST_CASE(charts_that_are_missing_are_said_so, Fixture)
{
  write("face.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const auto r = meridian("unwrap face.obj -o uv.obj --charts 2 --report report.json");
  BOOST_TEST(r.status == 2);
  BOOST_TEST(contains(r.error, "1 chart, fewer than the 2 asked for"), r.error);
  BOOST_TEST(json("report.json")["verified"] == false);
}

BOOST_FIXTURE_TEST_CASE(padding_keeps_components_apart, Fixture)
{
  std::string two = obj(sample::torus(9, 7));
  const auto once = sample::torus(9, 7);
  for (const auto& p : once.points)
  {
    two += "v " + std::to_string(p[0] + 9) + " " + std::to_string(p[1]) + " " + std::to_string(p[2]) + "\n";
  }
  const Index n = once.number_of_vertices() + 1;
  for (const auto& t : once.triangles)
  {
    two += "f " + std::to_string(t[0] + n) + " " + std::to_string(t[1] + n) + " " + std::to_string(t[2] + n) + "\n";
  }
  write("two.obj", two);
  double covered = 1;
  for (const std::string padding : {"0", "24"})
  {
    BOOST_TEST_REQUIRE(
      meridian("unwrap two.obj -o uv.obj --resolution 128 --padding " + padding + " --report report.json --quiet")
        .status
      == 0);
    BOOST_TEST(json("report.json")["texture"]["coverage"] < covered);
    covered = json("report.json")["texture"]["coverage"];
  }
}

// A plate with holes lies flat: the sides of its slits lie on each other, until they are opened.
BOOST_FIXTURE_TEST_CASE(padding_is_kept_within_a_chart, Fixture)
{
  const auto run = [&](const std::string& options) {
    const auto r = meridian("unwrap plate.obj -o uv.obj --report report.json --shortest-seams " + options);
    return std::make_pair(r, json("report.json")["texture"]["near_themselves"].get<int>());
  };
  write("plate.obj", obj(sample::noisy(sample::plate(5, 6), 0.02, 1)));
  const auto [by_itself, none] = run("");
  BOOST_TEST(by_itself.status == 0, by_itself.error);
  BOOST_TEST(none == 0);
  const auto [wide, few] = run("--padding 10 --resolution 1024");
  BOOST_TEST(wide.status == 0, wide.error);
  BOOST_TEST(few == 0);
  const auto [too_wide, many] = run("--padding 12 --resolution 64");
  BOOST_TEST(too_wide.status == 2);
  BOOST_TEST(many > 0);
  BOOST_TEST(contains(too_wide.error, std::to_string(many) + " faces are nearer than the padding"), too_wide.error);
  BOOST_TEST(json("report.json")["verified"] == false);
  BOOST_TEST(meridian("verify plate.obj uv.obj").status == 0);
}

BOOST_FIXTURE_TEST_CASE(a_density_is_kept_and_tiles_are_filled, Fixture)
{
  const auto run = [&](const std::string& options) {
    return meridian("unwrap mesh.obj -o uv.obj --charts 6 --resolution 256 --report report.json " + options);
  };
  BOOST_TEST_REQUIRE(run("").status == 0);
  const double fits = json("report.json")["texture"]["density"];
  std::ostringstream low, high;
  low << 0.5 * fits;
  high << 1.5 * fits;
  BOOST_TEST_REQUIRE(run("--density " + low.str()).status == 0);
  BOOST_TEST(json("report.json")["texture"]["density"].get<double>() == 0.5 * fits, boost::test_tools::tolerance(1e-5));
  const auto refused = run("--density " + high.str());
  BOOST_TEST(refused.status == 1);
  BOOST_TEST(contains(refused.error, "1 texture of 256 x 256 texels cannot hold all charts"), refused.error);
  const auto tiled = run("--density " + high.str() + " --tiles 20");
  BOOST_TEST(tiled.status == 0, tiled.error);
  const auto texture = json("report.json")["texture"];
  BOOST_TEST(texture["tiles"] > 1);
  BOOST_TEST(texture["density"].get<double>() == 1.5 * fits, boost::test_tools::tolerance(1e-5));
  const auto verified = meridian("verify mesh.obj uv.obj");
  BOOST_TEST(verified.status == 0);
  BOOST_TEST(contains(verified.out, "which is " + std::to_string(texture["tiles"].get<int>()) + " tiles"),
             verified.out);
}

BOOST_FIXTURE_TEST_CASE(options_that_do_not_go_together_are_wrong_usage, Fixture)
{
  for (const std::string option : {"--parameterization tutte --border free",
                                   "--geometry-image 33 --on-edges",
                                   "--geometry-image 33 --parameterization tutte",
                                   "--geometry-image 33 --border circle",
                                   "--tiles 3",
                                   "--seams \"\"",
                                   "--density 100 --tiles 3 --svg uv.svg",
                                   "--density 100 --geometry-image 33",
                                   "--density 0",
                                   "--seams sharp:0",
                                   "--seams sharp:x",
                                   "--seams sharp:30 --method generators",
                                   "--chart-per group --source 3",
                                   "--seams sharp:30 --family 3",
                                   "--seams uv --geometry-image 33",
                                   "--keep-out \"\"",
                                   "--keep-out red --geometry-image 33",
                                   "--keep-out red --family 3",
                                   "--symmetry --keep-out red",
                                   "--pin \"\"",
                                   "--pin pins.txt --symmetry",
                                   "--pin pins.txt --density 3",
                                   "--pin pins.txt --family 3",
                                   "--pin pins.txt --method morse",
                                   "--symmetry --seams sharp:30",
                                   "--symmetry --geometry-image 33",
                                   "--symmetry --family 2",
                                   "--symmetry --method generators",
                                   "--keep-out red --method generators",
                                   "--png board.jpg",
                                   "--distortion faces.obj",
                                   "--stretch-weight 2",
                                   "--max-stretch 0.5",
                                   "--max-stretch nan",
                                   "--stretch-weight nan",
                                   "--stretch-weight 1.5",
                                   "--png 'a b.png'",
                                   "--max-stretch 1.5 --shortest-seams",
                                   "--svg uv.obj",
                                   "--svg uv.map.json",
                                   "--png uv.mtl",
                                   "--parameterization best",
                                   "--charts 0",
                                   "--charts many",
                                   "--charts -1",
                                   "--charts 2.5",
                                   "--charts 3 --geometry-image 33",
                                   "--charts auto --family 3",
                                   "--charts auto --stretch-weight 0.5",
                                   "--resolution 64 --padding 30"})
  {
    const auto r = meridian("unwrap mesh.obj -o uv.obj " + option);
    BOOST_TEST(r.status == 64, option + ": " + std::to_string(r.status));
    BOOST_TEST(r.error.size() > 20u);
  }
  const auto r = meridian("unwrap mesh.obj -o uv.off");
  BOOST_TEST(r.status == 1);
  BOOST_TEST(contains(r.error, "OBJ"));
  BOOST_TEST(number_of_files() == 1u);
}

namespace {

// A cube of four quads on each side, with a group and a normal for each side and a material for each half; colours are
// half of the coordinates. Objects are not named.
std::string cube_with_parts()
{
  std::ostringstream out;
  const auto number = [](int x, int y, int z) { return 9 * x + 3 * y + z + 1; };
  out << "mtllib cube.mtl\n";
  for (int x = 0; x < 3; ++x)
    for (int y = 0; y < 3; ++y)
      for (int z = 0; z < 3; ++z)
      {
        out << "v " << x << ' ' << y << ' ' << z << ' ' << x / 2. << ' ' << y / 2. << ' ' << z / 2. << '\n';
      }
  for (int side = 0; side < 6; ++side)
  {
    const int out_of = side % 2 ? 1 : -1;
    out << "vn " << (side / 2 == 0) * out_of << ' ' << (side / 2 == 1) * out_of << ' ' << (side / 2 == 2) * out_of
        << '\n';
    out << "g side" << side << "\nusemtl " << (side < 3 ? "stone" : "wood\t") << '\n';
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j)
      {
        out << 'f';
        for (int k = 0; k < 4; ++k)
        {
          const int turn = side % 2 ? k : 3 - k, a = i + (turn == 1 || turn == 2), b = j + (turn == 2 || turn == 3);
          std::array<int, 3> p{};
          p[side / 2] = side % 2 ? 2 : 0;
          p[(side / 2 + 1) % 3] = a;
          p[(side / 2 + 2) % 3] = b;
          out << ' ' << number(p[0], p[1], p[2]) << "//" << side + 1;
        }
        out << '\n';
      }
  }
  return out.str();
}

} // namespace

BOOST_FIXTURE_TEST_CASE(charts_are_the_parts_that_a_file_names, Fixture)
{
  write("cube.obj", cube_with_parts());
  const auto charts_with = [&](const std::string& options) {
    const auto r = meridian("unwrap cube.obj -o uv.obj --report report.json " + options);
    BOOST_TEST(r.status == 0, options + r.error);
    BOOST_TEST(meridian("verify cube.obj uv.obj").status == 0);
    BOOST_TEST(json("report.json")["components"][0]["cut"]["new_vertices"] == 0);
    return json("report.json")["components"][0]["parameterization"]["charts"].get<int>();
  };
  BOOST_TEST(charts_with("--chart-per group") == 6);
  BOOST_TEST(charts_with("--chart-per smooth-angle") == 6);
  BOOST_TEST(charts_with("--seams sharp:89") == 6);
  BOOST_TEST(charts_with("--seams sharp:91 --on-edges") == 1); // there are none
  BOOST_TEST(charts_with("--chart-per material") == 2);
  for (const std::string part : {"object", "smoothing"})
  {
    const auto r = meridian("unwrap cube.obj -o none.obj --chart-per " + part);
    BOOST_TEST(r.status == 1);
    BOOST_TEST(contains(r.error, "names no"), r.error);
  }
}

// What stands in the file is linear on its polygons, so it is known at new vertices too.
BOOST_FIXTURE_TEST_CASE(normals_colours_and_parts_are_kept, Fixture)
{
  write("cube.obj", cube_with_parts());
  std::filesystem::create_directory(folder() / "below");
  for (const std::string options : {"", "--on-edges", "--charts 5", "--png board.png"})
  {
    BOOST_TEST_REQUIRE(meridian("unwrap cube.obj -o below/uv.obj --quiet " + options).status == 0);
    files::Mesh_attributes found;
    const Polygon_soup soup = files::read_mesh((folder() / "below/uv.obj").string(), &found);
    BOOST_TEST_REQUIRE(found.colours.size() == soup.points.size());
    for (std::size_t v = 0; v < soup.points.size(); ++v)
    {
      BOOST_TEST(norm(found.colours[v] - 0.5 * soup.points[v]) < 1e-12);
    }
    const auto &groups = found.of(files::Part_kind::GROUP), &materials = found.of(files::Part_kind::MATERIAL);
    BOOST_TEST(groups.names.size() == 6u);
    const bool is_own = options != "--png board.png";
    BOOST_TEST((materials.names
                == (is_own ? std::vector<std::string>{"stone", "wood"} : std::vector<std::string>{"checkerboard"})));
    BOOST_TEST((found.libraries == std::vector<std::string>{is_own ? "../cube.mtl" : "uv.mtl"}));
    for (std::size_t p = 0; p < soup.number_of_polygons(); ++p)
    {
      const int side = groups.names[groups.of[p]].back() - '0';
      if (is_own) { BOOST_TEST(materials.names[materials.of[p]] == (side < 3 ? "stone" : "wood")); }
      for (std::size_t k = soup.begin[p]; k < soup.begin[p + 1]; ++k)
      {
        BOOST_TEST(soup.points[soup.corners[k]][side / 2] == (side % 2 ? 2 : 0));
        BOOST_TEST_REQUIRE(found.normal_of[k] >= 0);
        BOOST_TEST(found.normals[found.normal_of[k]][side / 2] == (side % 2 ? 1 : -1));
      }
    }
    BOOST_TEST(meridian("verify cube.obj below/uv.obj").status == 0);
  }
}

BOOST_FIXTURE_TEST_CASE(normals_between_those_of_a_file_are_of_length_one, Fixture)
{
  const Triangle_surface s = sample::sphere(2);
  std::ostringstream out; // as PLY, with colours in whole numbers
  out
    << "ply\nformat ascii 1.0\nelement vertex " << s.number_of_vertices()
    << "\nproperty float x\nproperty float y\nproperty float z\nproperty float nx\nproperty float ny\nproperty float nz"
       "\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nelement face "
    << s.number_of_faces() << "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Point& p : s.points)
  {
    for (int i = 0; i < 6; ++i) { out << p[i % 3] << ' '; }
    out << "255 51 0\n";
  }
  for (const auto& t : s.triangles) { out << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n'; }
  write("ball.ply", out.str());
  BOOST_TEST_REQUIRE(meridian("unwrap ball.ply -o uv.obj --charts 4 --quiet").status == 0);
  files::Mesh_attributes found;
  const Polygon_soup soup = files::read_mesh((folder() / "uv.obj").string(), &found);
  BOOST_TEST(soup.points.size() > s.points.size());
  BOOST_TEST(found.normals.size() > s.points.size());
  for (std::size_t k = 0; k < soup.corners.size(); ++k)
  {
    BOOST_TEST_REQUIRE(found.normal_of[k] >= 0);
    const Point n = found.normals[found.normal_of[k]], p = soup.points[soup.corners[k]];
    BOOST_TEST(norm(n) == 1, boost::test_tools::tolerance(1e-5));
    BOOST_TEST(norm(n - (1 / norm(p)) * p) < 0.05);
  }
  for (const Point& c : found.colours) { BOOST_TEST(norm(c - Point{1, 0.2, 0}) < 1e-12); }
}

BOOST_FIXTURE_TEST_CASE(doubled_vertices_are_those_of_the_texture, Fixture)
{
  for (const std::string file : {"doubled.vtp", "doubled.ply"})
  {
    BOOST_TEST_REQUIRE(meridian("unwrap mesh.obj -o uv.obj --charts 3 --quiet --doubled " + file).status == 0);
    const auto places = lines_of(text("uv.obj"), "vt"), points = lines_of(text("uv.obj"), "v");
    const Polygon_soup soup = files::read_mesh((folder() / file).string());
    BOOST_TEST_REQUIRE(soup.points.size() == places.size());
    BOOST_TEST(soup.number_of_polygons() == lines_of(text("uv.obj"), "f").size());
    const std::string all = text(file);
    std::istringstream texture, vertices;
    if (file == "doubled.vtp")
    {
      const auto after = [&](const std::string& name) {
        const std::size_t at = all.find("Name=\"" + name + "\"");
        const std::size_t begin = all.find('>', at) + 1;
        return all.substr(begin, all.find('<', begin) - begin);
      };
      texture.str(after("texture"));
      vertices.str(after("vertex"));
    }
    const char* raw = all.data() + all.find("end_header\n") + 11;
    for (std::size_t v = 0; v < places.size(); ++v, raw += 44)
    {
      Plane_point p, q;
      std::int32_t w = -1;
      std::memcpy(p.data(), raw + 24, 16);
      std::memcpy(&w, raw + 40, 4);
      if (file == "doubled.vtp")
      {
        texture >> p[0] >> p[1];
        vertices >> w;
      }
      std::sscanf(places[v].c_str(), "vt %lf %lf", &q[0], &q[1]);
      BOOST_TEST((p == q));
      Point at;
      std::sscanf(points[w].c_str(), "v %lf %lf %lf", &at[0], &at[1], &at[2]);
      BOOST_TEST((soup.points[v] == at));
    }
  }
  BOOST_TEST(meridian("unwrap mesh.obj -o uv.obj --doubled doubled.off").status == 64);
}

BOOST_FIXTURE_TEST_CASE(malformed_attributes_do_no_harm, Fixture)
{
  write("a.obj", "o\ng  two words \nv 0 0 0 1\nv 1 0 0 0.5 0.5 x\nv 0 1 0 1 0 0\nv 0 0 1\nvt x\nvt 0.5\nvn 1 2\n"
                 "s off\nf 1/9 3/-1 2/x\nf 1//7 2//1 4//\nf 2/ 3 4/1/1\nf 1 4 3\n");
  files::Mesh_attributes found;
  const Polygon_soup soup = files::read_mesh((folder() / "a.obj").string(), &found);
  BOOST_TEST(soup.number_of_polygons() == 4u);
  BOOST_TEST((found.colours == std::vector<Point>{{1, 1, 1}, {1, 1, 1}, {1, 0, 0}, {1, 1, 1}}));
  BOOST_TEST((found.texture == std::vector<Plane_point>{{0, 0}, {0.5, 0}}));
  BOOST_TEST((found.texture_of == std::vector<std::int32_t>{-1, 1, -1, -1, -1, -1, -1, -1, 0, -1, -1, -1}));
  BOOST_TEST((found.normal_of == std::vector<std::int32_t>{-1, -1, -1, -1, 0, -1, -1, -1, 0, -1, -1, -1}));
  BOOST_TEST((found.of(files::Part_kind::GROUP).names == std::vector<std::string>{"two words"}));
  BOOST_TEST((found.of(files::Part_kind::OBJECT).names == std::vector<std::string>{""}));
  BOOST_TEST(found.of(files::Part_kind::MATERIAL).of.empty());
  BOOST_TEST(found.of(files::Part_kind::SMOOTHING).of.empty()); // it is off
  BOOST_TEST(meridian("unwrap a.obj -o uv.obj --quiet").status == 0);
  BOOST_TEST(meridian("verify a.obj uv.obj").status == 0);
  write("a.obj", text("a.obj") + "v nan 0 0\n"); // that no face uses
  BOOST_TEST(meridian("unwrap a.obj -o uv.obj --quiet").status == 0);
  BOOST_TEST(meridian("verify a.obj uv.obj").status == 0);
}

BOOST_FIXTURE_TEST_CASE(seams_of_texture_coordinates_give_the_same_charts_again, Fixture)
{
  write("ball.obj", obj(sample::sphere(3))); // in one chart its seam has two ends inside
  for (const std::string mesh : {"mesh.obj --charts 3", "ball.obj --charts 1"})
  {
    BOOST_TEST_REQUIRE(meridian("unwrap -o uv.obj --on-edges --report report.json " + mesh).status == 0);
    const auto first = json("report.json")["components"][0];
    const auto r = meridian("unwrap uv.obj -o again.obj --seams uv --report report.json");
    BOOST_TEST(r.status == 0, r.error);
    BOOST_TEST(contains(r.out, "no more is cut"), r.out);
    const auto again = json("report.json")["components"][0];
    BOOST_TEST(again["parameterization"]["charts"] == first["parameterization"]["charts"]);
    BOOST_TEST(again["cut"]["edges"] == first["cut"]["edges"]);
    BOOST_TEST(again["cut"]["seams"].size() > 0u);
    BOOST_TEST(meridian("verify uv.obj again.obj").status == 0);
  }
  const auto without = meridian("unwrap mesh.obj -o again.obj --seams uv");
  BOOST_TEST(without.status == 1);
  BOOST_TEST(contains(without.error, "has no texture coordinates"), without.error);
}

BOOST_FIXTURE_TEST_CASE(seams_on_paths_of_a_file_are_kept_and_completed, Fixture)
{
  write("torus.obj", obj(sample::torus(8, 6)));
  const auto run = [&](const std::string& paths, const std::string& options = "") {
    write("seams.txt", paths);
    return meridian("unwrap torus.obj -o uv.obj --report report.json --seams seams.txt " + options);
  };
  const auto around = run("# around the tube\n0 1 2 3 4 5 0\n");
  BOOST_TEST(around.status == 0, around.error);
  BOOST_TEST(contains(around.out, "given: 6 edges; boundaries are joined by links, 1"), around.out);
  const std::string byte_order_mark = "\xEF\xBB\xBF"; // which some editors begin a text with
  BOOST_TEST(run(byte_order_mark + "0 1 2 3 4 5 0\n").status == 0);
  const auto open = run("0 1\n1 2 3 # goes on");
  BOOST_TEST(open.status == 0, open.error);
  BOOST_TEST(contains(open.out, "given: 3 edges; the handles that they leave are cut along meridian_0;"), open.out);
  BOOST_TEST(contains(run("0 1 2", "--on-edges").out, "are cut along path_0"));
  const auto expect = [&](const std::string& paths, const std::string& message) {
    const auto r = run(paths);
    BOOST_TEST(r.status == 1, paths);
    BOOST_TEST(contains(r.error, message), r.error);
  };
  expect("0 1\n0 3 15\n", "2 steps of its paths are no edges of the mesh, the first from vertex 0 to vertex 3");
  expect("0 1\n2\n", "line 2: a path of one vertex");
  expect("0 48\n", "vertex 48 is none of the mesh");
  expect("0 -1\n", "vertex -1 is none of the mesh");
  expect("# none\n", "no paths");
  expect("0 x\n", "expected a vertex, found 'x'");
  write("seams.txt", "0 1 2\n");
  BOOST_TEST(meridian("unwrap torus.obj -o uv.obj --seams seams.txt --report seams.txt").status == 64);
}

BOOST_FIXTURE_TEST_CASE(seams_keep_out_of_faces_that_are_marked, Fixture)
{
  const Triangle_surface torus = sample::torus(40, 20);
  write("torus.obj", obj(torus));
  const auto mark = [&](const std::function<bool(const Point&)>& is_marked) {
    std::string numbers;
    for (const Point& p : torus.points) { numbers += is_marked(p) ? "0.5\n" : "0\n"; }
    write("marked.txt", numbers);
  };
  const std::string command = "unwrap torus.obj -o uv.obj --report report.json --keep-out ";
  mark([](const Point& p) { return p[2] > 0.8; }); // a band that leaves the tube open below
  const auto crossed = meridian(command + "marked.txt");
  BOOST_TEST(crossed.status == 2, crossed.error);
  BOOST_TEST(contains(crossed.out + crossed.error, "seams go over faces to keep out of"), crossed.error);
  BOOST_TEST(json("report.json")["missed"].size() == 1u);
  BOOST_TEST(json("report.json")["verified"] == false);
  mark([](const Point& p) { return p[2] > 0.3 && p[0] > 0.5; });
  const auto kept = meridian(command + "marked.txt");
  BOOST_TEST(kept.status == 0, kept.error);
  BOOST_TEST(json("report.json")["missed"].empty());

  const auto uncoloured = meridian(command + "red");
  BOOST_TEST(uncoloured.status == 1);
  BOOST_TEST(contains(uncoloured.error, "its vertices have no colours"), uncoloured.error);
  std::string red, faces;
  for (const Point& p : torus.points)
  {
    red += "v " + std::to_string(p[0]) + " " + std::to_string(p[1]) + " " + std::to_string(p[2])
           + (p[2] > 0.8 ? " 1 0.2 0.2\n" : " 1 0.9 0.2\n"); // yellow is not red
  }
  for (const auto& t : torus.triangles)
  {
    faces += "f " + std::to_string(t[0] + 1) + " " + std::to_string(t[1] + 1) + " " + std::to_string(t[2] + 1) + "\n";
  }
  write("torus.obj", red + faces);
  BOOST_TEST(meridian(command + "red").status == 2);
  BOOST_TEST(meridian("unwrap torus.obj -o uv.obj --keep-out marked.txt --report marked.txt").status == 64);
  BOOST_TEST(meridian("unwrap torus.obj torus.obj -o a.obj b.obj --keep-out marked.txt").status == 64);
  write("marked.txt", "1 2 3\n");
  const auto few = meridian(command + "marked.txt");
  BOOST_TEST(few.status == 1);
  BOOST_TEST(contains(few.error, "it has 3 numbers"), few.error);
}

BOOST_FIXTURE_TEST_CASE(vertices_are_pinned, Fixture)
{
  const Triangle_surface torus = sample::torus(40, 20);
  write("torus.obj", obj(torus));
  const auto run = [&](const std::string& pins, const std::string& options = "") {
    write("pins.txt", pins);
    return meridian("unwrap torus.obj -o uv.obj --report report.json --pin pins.txt " + options);
  };
  const auto there = [&](std::size_t v) {
    std::istringstream line(lines_of(text("uv.obj"), "vt")[v].substr(3));
    Plane_point p{-1, -1};
    line >> p[0] >> p[1];
    return p;
  };
  const auto one = run("# a vertex\n105 0.5 0.375\n");
  BOOST_TEST(one.status == 0, one.error);
  BOOST_TEST((there(105) == Plane_point{0.5, 0.375}));
  const auto three = run("105 0.5 0.5\n109 0.53 0.5\n187 0.5 0.54\n", "--charts 3 --resolution 1024x512");
  BOOST_TEST(three.status == 0, three.error);
  BOOST_TEST((there(105) == Plane_point{0.5, 0.5}));
  BOOST_TEST((there(109) == Plane_point{0.53, 0.5}));
  BOOST_TEST((there(187) == Plane_point{0.5, 0.54}));
  BOOST_TEST(meridian("verify torus.obj uv.obj").status == 0);
  const auto impossible = run("105 0.5 0.5\n109 0.53 0.5\n187 0.5 0.54\n106 0.53 0.5\n");
  BOOST_TEST(impossible.status == 2);
  BOOST_TEST(contains(impossible.error, "of 4 pinned vertices are not where they should be"), impossible.error);
  const auto expect = [&](const std::string& pins, const std::string& message) {
    const auto r = run(pins);
    BOOST_TEST(r.status == 1, pins);
    BOOST_TEST(contains(r.error, message), r.error);
  };
  expect("105 0 0\n109 1 1\n", "reaches out of the texture");
  expect("105 0 0.5\n", "leaves the chart around it no room");
  expect("800 0.5 0.5\n", "vertex 800 is none of the mesh");
  expect("5 0.5\n", "a vertex and two coordinates");
  expect("5 0.5 0.5 0.5\n", "there is more");
  expect("5 0.5 1.5\n", "from 0 to 1");
  expect("5 0.5 nan\n", "from 0 to 1");
  expect("5 0.5 0.5\n5 0.5 0.5\n", "pinned twice");
  expect("# none\n", "no pins");
  BOOST_TEST(run("5 0.5 0.5\n", "--report pins.txt").status == 64);
}

BOOST_FIXTURE_TEST_CASE(symmetry_is_kept_or_missed, Fixture)
{
  write("ball.obj", obj(sample::sphere(3)));
  const auto kept = meridian("unwrap ball.obj -o uv.obj --symmetry --report report.json");
  BOOST_TEST(kept.status == 0, kept.error);
  BOOST_TEST(json("report.json")["components"][0]["parameterization"]["symmetric"] == true);
  BOOST_TEST(meridian("verify ball.obj uv.obj").status == 0);
  // each face has an image that is as large
  const files::Texture_text written("uv.obj", text("uv.obj"));
  std::vector<double> areas;
  for (const auto& t : written.texture_triangles())
  {
    const auto& at = written.texture();
    areas.push_back(cross(at[t[1]] - at[t[0]], at[t[2]] - at[t[0]]));
  }
  std::sort(areas.begin(), areas.end());
  BOOST_TEST_REQUIRE(areas.size() % 2 == 0u);
  for (std::size_t i = 0; i < areas.size(); i += 2)
  {
    BOOST_TEST(areas[i] == areas[i + 1], boost::test_tools::tolerance(1e-7));
  }
  const auto missed = meridian("unwrap mesh.obj -o uv.obj --symmetry --report report.json"); // noisy
  BOOST_TEST(missed.status == 2);
  BOOST_TEST(contains(missed.error, "its own mirror image"), missed.error);
  BOOST_TEST(json("report.json")["components"][0]["parameterization"]["symmetric"] == false);
  BOOST_TEST(meridian("verify mesh.obj uv.obj").status == 0);
}

#ifdef MERIDIAN_ASSIMP
// A reader that is not ours.
BOOST_FIXTURE_TEST_CASE(another_reader_sees_the_same_faces_with_coordinates_for_all, Fixture)
{
  BOOST_TEST_REQUIRE(meridian("unwrap mesh.obj -o uv.obj --png board.png --quiet").status == 0);
  BOOST_TEST_REQUIRE(shell("'" MERIDIAN_ASSIMP "' dump uv.obj uv.assxml").status == 0);
  const std::string dump = text("uv.assxml");
  const std::size_t faces = lines_of(text("uv.obj"), "f").size();
  BOOST_TEST(contains(dump, "<FaceList num=\"" + std::to_string(faces) + "\">"));
  const std::size_t at = dump.find("<Positions num=\"");
  BOOST_TEST_REQUIRE(at != std::string::npos);
  const std::string points = dump.substr(at + 16, dump.find('"', at + 16) - at - 16);
  BOOST_TEST(contains(dump, "<TextureCoords num=\"" + points + "\""), points);
}
#endif

#ifdef MERIDIAN_CHROMIUM
BOOST_FIXTURE_TEST_CASE(the_page_shows_the_checkerboard_beside_the_layout, Fixture)
{
  BOOST_TEST_REQUIRE(meridian("unwrap mesh.obj -o uv.obj --view page.html --quiet").status == 0);
  const auto shown = show("page.html", MERIDIAN_CHROMIUM);
  BOOST_TEST(shown.number("data-pixels") > 10000);
  BOOST_TEST(shown.number("data-layout-pixels") > 10000);
  BOOST_TEST(shown.number("data-cut-pixels") > 100);
  for (const std::string& line : shown.errors) { BOOST_ERROR(line); }
}
#endif
