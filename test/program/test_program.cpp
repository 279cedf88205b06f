#include <boost/test/unit_test.hpp>

#include "support/run_program.h"
#include "support/sample_surfaces.h"
#include "support/written_meshes.h"

#include "files/read_mesh.h"
#include "files/write_mesh.h"

#include <meridian/base/Result_mesh.h>
#include <meridian/base/names.h>
#include <meridian/base/vectors.h>
#include <meridian/curves/contours.h>
#include <meridian/cut/Cut_options.h>
#include <meridian/cut/join_generators.h>
#include <meridian/field/edge_weights.h>
#include <meridian/map/Map_method.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/unwrap/compare_parameterizations.h>

#include <nlohmann/json.hpp>

using namespace meridian;
using written::contains;
using written::obj;

namespace {

struct Fixture : program::Workplace
{
  Fixture() { write("mesh.obj", obj(sample::noisy(sample::punctured(sample::plate(2, 4), {30}), 0.05, 1))); }
  nlohmann::json json(const std::string& name) const { return nlohmann::json::parse(program::read(folder() / name)); }
};

} // namespace

BOOST_FIXTURE_TEST_CASE(a_cut_writes_its_files_and_verify_agrees, Fixture)
{
  const auto cut = meridian("cut mesh.obj -o disc.ply --report report.json --view page.html --curves curves.obj "
                            "--tighten curves");
  BOOST_TEST(cut.status == 0);
  BOOST_TEST(cut.error == "");
  BOOST_TEST(contains(cut.out, "verified"));
  BOOST_TEST(number_of_files() == 6u);
  const auto report = json("report.json");
  BOOST_TEST(report["verified"] == true);
  BOOST_TEST(report["meridian"] == "0.1.0");
  BOOST_TEST(report["input"]["vertices"] > 100);
  const auto& c = report["components"][0];
  BOOST_TEST(c["genus"] == 2);
  BOOST_TEST(c["boundary_loops"] == 1);
  BOOST_TEST(c["field"]["saddles"] == 4);
  BOOST_TEST(c["cut"]["euler_characteristic"] == 1);
  BOOST_TEST(c["cut"]["connected"] == true);
  BOOST_TEST(c["cut"]["boundary_loops"] == 1);
  BOOST_TEST(c["cut"]["meridians"].size() == 2u);
  BOOST_TEST(c["cut"]["meridians"][1]["genus_after"] == 0);
  BOOST_TEST(c["cut"]["length"].get<double>() > 0);
  for (const char* stage : {"field", "order", "links"}) { BOOST_TEST(c["seconds"].contains(stage)); }
  BOOST_TEST(contains(program::read(folder() / "curves.obj"), "g meridian_1\nl "));
  BOOST_TEST(contains(program::read(folder() / "curves.obj"), "g boundary_0\nl "));
  const auto verify = meridian("verify mesh.obj disc.ply");
  BOOST_TEST(verify.status == 0);
  BOOST_TEST(contains(verify.out, "verified: 1 component (genus 2, boundary loops 1) became 1 piece, each a disc"));
}

BOOST_FIXTURE_TEST_CASE(the_files_vertices_come_first_bit_for_bit, Fixture)
{
  BOOST_REQUIRE(meridian("cut mesh.obj -o disc.obj --quiet").status == 0);
  const std::string before = program::read(folder() / "mesh.obj"), after = program::read(folder() / "disc.obj");
  const std::string vertices = before.substr(0, before.find("f "));
  BOOST_TEST(after.compare(0, vertices.size(), vertices) == 0);
}

BOOST_FIXTURE_TEST_CASE(the_same_input_gives_the_same_bytes, Fixture)
{
  BOOST_REQUIRE(meridian("cut mesh.obj -o a.obj --curves ca.obj --quiet").status == 0);
  BOOST_REQUIRE(meridian("cut mesh.obj -o b.obj --curves cb.obj --quiet").status == 0);
  for (const auto& [a, b] : {std::pair("a.obj", "b.obj"), {"a.map.json", "b.map.json"}, {"ca.obj", "cb.obj"}})
    BOOST_TEST((program::read(folder() / a) == program::read(folder() / b)));
}

BOOST_FIXTURE_TEST_CASE(a_result_that_was_changed_is_not_verified, Fixture)
{
  BOOST_REQUIRE(meridian("cut mesh.obj -o disc.off --quiet").status == 0);
  std::string text = program::read(folder() / "disc.off");
  const std::size_t digit = text.find_last_of("123456789", text.find("\n3 ")); // the last digit of the last vertex
  text[digit] = text[digit] == '1' ? '2' : '1';
  write("disc.off", text);
  const auto verify = meridian("verify mesh.obj disc.off --report r.json");
  BOOST_TEST(verify.status == 2);
  BOOST_TEST(contains(verify.error, "vertices are not at the position of their origin"));
  BOOST_TEST(json("r.json")["verified"] == false);
  BOOST_TEST(meridian("verify mesh.obj missing.off").status == 1);
}

BOOST_FIXTURE_TEST_CASE(generators_are_written_reported_and_verified_from_their_files, Fixture)
{
  write("two.obj", obj(sample::noisy(sample::punctured(sample::plate(2, 3), {10}), 0.1, 4)));
  const auto r = meridian("generators two.obj -o out.obj --report r.json --view v.html --curves c.obj");
  BOOST_TEST(r.status == 0, r.error);
  BOOST_TEST(contains(r.out, "verified: 1 component: 2 handles"));
  const auto report = json("r.json");
  const auto& component = report["components"][0];
  BOOST_TEST(component["intersection_matrix"] == "symplectic");
  BOOST_TEST(component["is_basis"] == true);
  BOOST_TEST(component["generators"].size() == 2u);
  for (const auto& pair : component["generators"])
    for (const char* key : {"handle", "meridian", "longitude", "class", "bounding_box", "centre"})
    {
      BOOST_TEST(pair.contains(key), key);
    }
  const std::string text = program::read(folder() / "out.obj");
  for (const char* group : {"g meridian_0", "g longitude_0", "g meridian_1", "g longitude_1", "g boundary_0"})
  {
    BOOST_TEST(contains(text, group), group);
  }
  const auto verify = meridian("verify two.obj out.obj --report w.json");
  BOOST_TEST(verify.status == 0, verify.error);
  BOOST_TEST(json("w.json")["components"][0]["intersection_matrix"] == "symplectic");
  // The same bytes again, and a changed curve is found.
  BOOST_REQUIRE(meridian("generators two.obj -o again.obj --quiet").status == 0);
  BOOST_TEST((program::read(folder() / "again.obj") == text
              && program::read(folder() / "again.map.json") == program::read(folder() / "out.map.json")));
  std::string changed = text;
  changed.replace(changed.find("g longitude_0"), 13, "g longitude_9");
  write("again.obj", changed);
  const auto found = meridian("verify two.obj again.obj");
  BOOST_TEST(found.status == 2);
  BOOST_TEST(contains(found.error, "not numbered through"));
  BOOST_TEST(meridian("generators two.obj -o basis.obj --basis shortest --quiet").status == 0);
  BOOST_TEST(meridian("verify two.obj basis.obj").status == 0);
  BOOST_TEST(meridian("generators two.obj -o loose.obj --no-tighten --longitudes arc --quiet").status == 0);
  BOOST_TEST(meridian("verify two.obj loose.obj").status == 0);
  BOOST_TEST(
    meridian("generators two.obj -o open.obj --mode open --complex --curves o.obj --report o.json --quiet").status
    == 0);
  BOOST_TEST(meridian("verify two.obj open.obj").status == 0);
  BOOST_TEST(json("o.json")["components"][0]["field"]["mode"] == "open");
  BOOST_TEST(contains(program::read(folder() / "o.obj"), "g flow_line_0"));
  BOOST_TEST(meridian("generators two.obj -o out.off").status == 64);
}

BOOST_FIXTURE_TEST_CASE(nested_and_linked_tori_have_the_classes_of_one, Fixture)
{
  const auto joined = [](const Triangle_surface& a, const Triangle_surface& b) {
    Triangle_surface both = a;
    both.points.insert(both.points.end(), b.points.begin(), b.points.end());
    const Index first = a.number_of_vertices();
    for (const auto& t : b.triangles) { both.triangles.push_back({t[0] + first, t[1] + first, t[2] + first}); }
    return both;
  };
  Triangle_surface link = sample::rotated(sample::torus(24, 12), sample::pi / 2, 0); // through the hole of the other
  for (Point& p : link.points) { p[0] += 3; }
  for (const Triangle_surface& s :
       {joined(sample::torus(24, 12), sample::torus(24, 12, 3, 0.4)), joined(sample::torus(24, 12), link)})
  {
    write("two.obj", obj(s));
    BOOST_TEST(meridian("generators two.obj -o out.obj --report r.json --quiet").status == 0);
    const auto report = json("r.json");
    BOOST_TEST(report["components"].size() == 2u);
    for (const auto& component : report["components"])
    {
      BOOST_TEST(component["generators"][0]["meridian"]["class"] == "handle");
      BOOST_TEST(component["generators"][0]["longitude"]["class"] == "tunnel");
    }
  }
}

BOOST_FIXTURE_TEST_CASE(every_component_has_its_own_extrema, Fixture)
{
  const Triangle_surface a = sample::torus(12, 8), b = sample::torus(14, 9);
  Triangle_surface both = a;
  for (const Point& p : b.points) { both.points.push_back({p[0] + 10, p[1], p[2]}); }
  const Index first = a.number_of_vertices();
  for (const auto& t : b.triangles) { both.triangles.push_back({t[0] + first, t[1] + first, t[2] + first}); }
  write("both.obj", obj(both));
  const auto lengths = [&](const std::string& options) {
    BOOST_REQUIRE(meridian("cut both.obj -o x.off --report r.json --quiet" + options).status == 0);
    const auto report = json("r.json");
    return std::pair(report["components"][0]["cut"]["length"].get<double>(),
                     report["components"][1]["cut"]["length"].get<double>());
  };
  // Extrema beside each other on the first component change its cut, and not the other's.
  const auto by_default = lengths(""), chosen = lengths(" --minimum 0 --maximum 1");
  BOOST_TEST(chosen.first != by_default.first);
  BOOST_TEST(chosen.second == by_default.second);
}

BOOST_FIXTURE_TEST_CASE(every_method_of_a_cut_is_verified, Fixture)
{
  for (const char* method : {"generators", "generators --join complex", "generators --join saddles", "morse"})
  {
    BOOST_TEST(
      meridian(std::string("cut mesh.obj -o out.ply --report r.json --curves c.obj --view v.html --method ") + method)
          .status
        == 0,
      method);
    BOOST_TEST(meridian("verify mesh.obj out.ply").status == 0, method);
  }
  BOOST_TEST(meridian("cut mesh.obj -o out.ply --method morse --join complex").status == 64);
  BOOST_TEST(meridian("cut mesh.obj -o out.ply --method morse --links plane").status == 64);
}

BOOST_FIXTURE_TEST_CASE(refused_input_leaves_no_file_and_says_the_way_out, Fixture)
{
  write("crowded.off", "OFF\n5 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 -1 0\n3 0 1 2\n3 1 0 3\n3 0 1 4\n");
  write("broken.off", "OFF\n3 1 0\n0 0");
  const std::size_t before = number_of_files();
  const auto crowded = meridian("cut crowded.off -o out.off --report r.json --view v.html --curves c.obj");
  BOOST_TEST(crowded.status == 1);
  BOOST_TEST(contains(crowded.error, "1 edges have three or more faces (first: 0-1)"));
  BOOST_TEST(contains(crowded.error, "--repair"));
  BOOST_TEST(crowded.out == "");
  BOOST_TEST(meridian("cut broken.off -o out.off --report r.json").status == 1);
  BOOST_TEST(meridian("cut missing.off -o out.off").status == 1);
  BOOST_TEST(meridian("cut mesh.obj -o out.stl --report r.json").status == 1);
  BOOST_TEST(meridian("cut mesh.obj -o no/such/folder/out.off --report r.json").status == 1);
  BOOST_TEST(number_of_files() == before);
  const auto repaired = meridian("cut crowded.off -o out.off --repair");
  BOOST_TEST(repaired.status == 0);
  BOOST_TEST(contains(repaired.out, "note: 1 edges split"));
}

BOOST_FIXTURE_TEST_CASE(an_interrupted_run_leaves_no_file, Fixture)
{
  write("large.obj", obj(sample::noisy(sample::plate(3, 60), 0.001, 1)));
  const std::size_t before = number_of_files();
  for (const char* delay : {"0.05", "0.3", "0.6"})
  {
    const auto r = shell(std::string("timeout -s INT ") + delay
                         + " '" MERIDIAN_PROGRAM "' cut large.obj -o out.obj --report r.json --view v.html");
    BOOST_TEST((number_of_files() == before || r.status == 0));
    const auto killed = shell(std::string("timeout -s KILL ") + delay
                              + " '" MERIDIAN_PROGRAM "' cut large.obj -o out.obj --report r.json");
    BOOST_TEST((number_of_files() == before || killed.status == 0));
    shell("rm -f out.* r.json v.html");
  }
}

BOOST_FIXTURE_TEST_CASE(wrong_usage_has_its_own_status, Fixture)
{
  for (const char* arguments :
       {"", "frobnicate", "cut mesh.obj", "cut -o x.off", "cut mesh.obj -o x.off --weights heavy",
        "cut mesh.obj -o x.off --minimum 99999999 --maximum 1", "cut mesh.obj -o x.off --minimum 3",
        "cut mesh.obj -o x.off --minimum 3 --maximum 3", "cut mesh.obj -o x.off --direction 1 0 0",
        "cut mesh.obj -o x.off --links plane --bifurcations", "cut mesh.obj -o mesh.obj",
        "cut mesh.obj -o x.off --report x.off", "cut mesh.obj -o x.off --report ./x.map.json",
        "cut mesh.obj -o x.off --view v.html --curves v.html", "cut mesh.obj -o x.off --source -7", "verify mesh.obj"})
  {
    const auto r = meridian(arguments);
    BOOST_TEST(r.status == 64, arguments);
    BOOST_TEST(r.error != "");
  }
  BOOST_TEST(meridian("--help").status == 0);
  BOOST_TEST(contains(meridian("cut --help").out, "--repair"));
  BOOST_TEST(meridian("--version").out == "meridian 0.1.0\n");
}

BOOST_FIXTURE_TEST_CASE(links_are_followed_and_other_files_are_left_alone, Fixture)
{
  // ended while reading
  BOOST_TEST(
    shell("mkfifo blocked.off; timeout -s TERM -k 5 0.2 '" MERIDIAN_PROGRAM "' cut blocked.off -o y.off").status
    == 124);
  shell("echo old >target.json; ln -s target.json link.json; mkfifo pipe.json");
  BOOST_TEST(meridian("cut mesh.obj -o x.off --report link.json --quiet").status == 0);
  BOOST_TEST(json("target.json")["verified"] == true);
  BOOST_TEST(program::fs::is_symlink(folder() / "link.json"));
  const std::size_t before = number_of_files();
  const auto r = meridian("cut mesh.obj -o y.off --report pipe.json");
  BOOST_TEST(r.status == 1);
  BOOST_TEST(contains(r.error, "not a plain file"));
  BOOST_TEST(number_of_files() == before);
}

BOOST_FIXTURE_TEST_CASE(names_that_are_not_text_are_reported_all_the_same, Fixture)
{
  shell("cp mesh.obj \"$(printf 'bad\\377.obj')\"");
  BOOST_TEST(meridian("cut \"$(printf 'bad\\377.obj')\" -o x.off --report r.json").status == 0);
  BOOST_TEST(json("r.json")["verified"] == true);
}

BOOST_FIXTURE_TEST_CASE(extreme_coordinates_are_cut_and_verified, Fixture)
{
  for (double size : {1e-300, 1e-160, 1e-90, 1e78, 1e160, 1e299})
    for (const char* weights : {"positive", "cotangent"})
    {
      write("extreme.obj", obj(sample::scaled(sample::noisy(sample::torus(14, 9), 0.1, 1), size)));
      const auto r =
        meridian(std::string("cut extreme.obj -o x.off --report r.json --view v.html --weights ") + weights);
      BOOST_TEST(r.status == 0, size << " " << weights << ": " << r.error);
      BOOST_TEST(meridian("verify extreme.obj x.off").status == 0);
      BOOST_TEST(json("r.json")["components"][0]["cut"]["length"].get<double>() / size > 10);
    }
}

BOOST_FIXTURE_TEST_CASE(info_counts_and_goes_on_after_a_bad_file, Fixture)
{
  const auto r = meridian("info missing.off mesh.obj --report r.json");
  BOOST_TEST(r.status == 1);
  BOOST_TEST(contains(r.error, "missing.off"));
  BOOST_TEST(contains(r.out, "genus 2, boundary loops 1"));
  BOOST_TEST(json("r.json")[1]["components"][0]["euler_characteristic"] == -3);
}

BOOST_FIXTURE_TEST_CASE(every_option_of_cut_gives_a_verified_result, Fixture)
{
  for (const char* options : {"--weights cotangent", "--weights mean-value", "--prefer mean-curvature",
                              "--prefer length", "--prefer position --direction 1 0 0", "--minimum 5 --maximum 100 101",
                              "--links plane", "--bifurcations", "--source 77", "--links plane --prefer length"})
  {
    const auto r = meridian(std::string("cut mesh.obj -o x.off --report x.json ") + options);
    BOOST_TEST(r.status == 0, options << ": " << r.error);
    BOOST_TEST(meridian("verify mesh.obj x.off").status == 0, options);
  }
  BOOST_TEST(contains(meridian("cut mesh.obj -o x.off --minimum 5 --maximum 5").error, "are one vertex"));
}

namespace {

// Every value of an enum is listed with what it means, and taken.
template <class Enum> void check_listed(const std::string& help, const std::string& option)
{
  const std::string part = help.substr(std::min(help.find(option), help.size()));
  BOOST_TEST(!part.empty(), option);
  for (const auto& v : Names<Enum>::table)
  {
    BOOST_TEST(contains(part, std::string(v.name) + ": " + v.meaning), option << ' ' << v.name);
  }
}

} // namespace

BOOST_FIXTURE_TEST_CASE(help_lists_every_choice_and_another_word_is_refused, Fixture)
{
  const std::string help = meridian("unwrap --help").out;
  check_listed<Cut_method>(help, "--method");
  check_listed<Tightening>(help, "--tighten");
  check_listed<Field>(help, "--field");
  check_listed<Extrema>(help, "--extrema");
  check_listed<Weights>(help, "--weights");
  check_listed<Levels>(help, "--levels");
  check_listed<Generator_join>(help, "--join");
  check_listed<Link_domain>(help, "--links");
  check_listed<Map_method>(help, "--parameterization");
  check_listed<Map_border>(help, "--border");
  check_listed<Map_weights>(meridian("compare --help").out, "--weights");
  const auto refused = meridian("cut mesh.obj -o x.off --method contour");
  BOOST_TEST(refused.status == 64);
  BOOST_TEST(contains(refused.error, "contours"), refused.error);
}

// A map in binary does for every command what one of text does, and two of them beside one result are one too many.
BOOST_FIXTURE_TEST_CASE(maps_in_binary_are_written_and_recounted, Fixture)
{
  for (const std::string command : {"cut", "generators", "unwrap"})
  {
    const std::string out = command + "_binary";
    const auto written = meridian(command + " mesh.obj -o " + out + ".obj --map cbor --quiet");
    BOOST_TEST(written.status == 0, written.error);
    BOOST_TEST(std::filesystem::exists(folder() / (out + ".map.cbor")));
    BOOST_TEST(!std::filesystem::exists(folder() / (out + ".map.json")));
    const auto verify = meridian("verify mesh.obj " + out + ".obj");
    BOOST_TEST(verify.status == 0, verify.error);
    BOOST_REQUIRE(meridian(command + " mesh.obj -o " + out + ".obj --quiet").status == 0);
    const auto both = meridian("verify mesh.obj " + out + ".obj");
    BOOST_TEST(both.status == 1);
    BOOST_TEST(contains(both.error, "both the map of one result"), both.error);
  }
  BOOST_TEST(meridian("cut mesh.obj -o x.map.cbor --map cbor").status == 1); // no format of meshes
}

BOOST_FIXTURE_TEST_CASE(the_manual_and_the_shell_know_every_choice, Fixture)
{
  std::ifstream file(MERIDIAN_MANUAL);
  const std::string manual{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  const auto tables = meridian("completion --markdown");
  BOOST_TEST(tables.status == 0);
  BOOST_TEST(contains(tables.out, "| `tree-cotree` | "));
  BOOST_TEST(contains(manual, tables.out), "doc/manual.md must hold what `meridian completion --markdown` prints");
  const auto complete = [&](const std::string& words, int word) {
    const std::string script = (folder() / "complete.sh").string(), completed = (folder() / "completed").string();
    std::ofstream(script) << "source <(" << MERIDIAN_PROGRAM << " completion)\nCOMP_WORDS=(meridian " << words
                          << ")\nCOMP_CWORD=" << word << "\n_meridian\necho \"${COMPREPLY[@]}\" >" << completed << '\n';
    BOOST_TEST(std::system(("bash " + script).c_str()) == 0);
    std::ifstream in(completed);
    std::string line;
    std::getline(in, line);
    return line;
  };
  BOOST_TEST(complete("", 1) == "info cut unwrap pack compare generators verify");
  BOOST_TEST(complete("cut --method ge", 3) == "generators geodesic geometry-image");
  BOOST_TEST(complete("compare --weights p", 3) == "positive");
  BOOST_TEST(complete("unwrap --para", 2) == "--parameterization");
  BOOST_TEST(complete("verify a", 2) == ""); // files are left to the shell
}

#ifdef MERIDIAN_CHROMIUM
BOOST_FIXTURE_TEST_CASE(the_page_shows_the_surface_and_the_cut_without_an_error, Fixture)
{
  BOOST_REQUIRE(meridian("cut mesh.obj -o disc.off --view page.html --quiet").status == 0);
  const auto shown = show("page.html", MERIDIAN_CHROMIUM);
  BOOST_TEST(shown.number("data-pixels") > 10000);
  BOOST_TEST(shown.number("data-cut-pixels") > 100);
  for (const std::string& line : shown.errors) { BOOST_ERROR(line); }
}
#endif

// Every choice of a field, a preference and a method gives a result that its own files verify; the report names it.
BOOST_FIXTURE_TEST_CASE(choices_are_verified_and_reported, Fixture)
{
  std::string numbers;
  const auto vertices = files::read_mesh((folder() / "mesh.obj").string()).points.size();
  for (std::size_t v = 0; v < vertices; ++v) { numbers += std::to_string(v % 17) + (v % 5 ? " " : " # a comment\n"); }
  write("values.txt", numbers);
  for (const auto& [option, kind] : {std::pair("--field eigenfunction", "eigenfunction 3"),
                                     {"--field distance --from 5", "distance"},
                                     {"--values values.txt", "given"},
                                     {"--method geodesic", "distance"},
                                     {"--extrema curved --weights intrinsic-delaunay", "harmonic"},
                                     {"--method tree-cotree --bases 2", "none"},
                                     {"--prefer hidden --direction 1e200 0 1e200", "harmonic"},
                                     {"--prefer weights --vertex-weights values.txt --levels tight", "harmonic"},
                                     {"--method morse --field eigenfunction", "eigenfunction 3"}})
  {
    const auto cut = meridian(std::string("cut mesh.obj -o disc.obj --report r.json ") + option);
    BOOST_TEST(cut.status == 0);
    BOOST_TEST(cut.error == "");
    BOOST_TEST(meridian("verify mesh.obj disc.obj").status == 0);
    BOOST_TEST(json("r.json")["components"][0]["field"]["kind"] == kind);
  }
  BOOST_REQUIRE(meridian("cut mesh.obj -o disc.obj --report r.json --curves c.obj --tighten graph").status == 0);
  const auto graph = json("r.json")["components"][0]["cut"];
  BOOST_TEST(graph["paths"].size() > 2u);
  BOOST_TEST(graph["links"].empty());
  BOOST_TEST(graph["length"].get<double>() <= graph["length_found"].get<double>());
  BOOST_TEST(contains(program::read(folder() / "c.obj"), "g path_1\nl "));
  BOOST_REQUIRE(meridian("cut mesh.obj -o disc.obj --report r.json --on-edges").status == 0);
  BOOST_TEST(json("r.json")["components"][0]["cut"]["new_vertices"] == 0);
}

BOOST_FIXTURE_TEST_CASE(a_family_is_written_with_numbers, Fixture)
{
  const auto family = meridian("cut mesh.obj -o disc.obj.gz --family 5 --report r.json --curves c.obj");
  BOOST_TEST(family.status == 0);
  BOOST_TEST(contains(family.out, "verified: 5 different cuts"));
  BOOST_TEST(number_of_files() == 1 + 5 * 3 + 1u);
  const auto report = json("r.json");
  BOOST_REQUIRE(report["family"].size() == 5u);
  std::size_t best = 0;
  for (const auto& member : report["family"])
  {
    best += member["best"] == true;
    const auto verify = meridian("verify mesh.obj " + member["file"].get<std::string>());
    BOOST_TEST(verify.status == 0);
    BOOST_TEST(member["components"][0]["cut"]["euler_characteristic"] == 1);
  }
  BOOST_TEST(best >= 1u);
  BOOST_TEST(report["family"][3]["file"] == "disc_03.obj.gz");
}

// Nothing that is read is written over, and nothing twice.
BOOST_FIXTURE_TEST_CASE(choices_that_do_not_go_together_are_wrong_usage, Fixture)
{
  const std::string before = program::read(folder() / "mesh.obj");
  write("v_00.obj", before);
  write("few.txt", "1 2 3");
  write("bad.txt", "1 two");
  for (const char* wrong : {"--family 0",
                            "--family 2 --report d_01.obj",
                            "--family 2 --curves d.obj",
                            "--values few.txt --report few.txt",
                            "--direction 0 0 0 --prefer position",
                            "--prefer weights",
                            "--direction 1 0 0",
                            "--eigenfunction 3",
                            "--field eigenfunction --weights mean-value",
                            "--field distance --weights cotangent",
                            "--values few.txt --field distance",
                            "--extrema curved --minimum 3 --maximum 9",
                            "--from 3",
                            "--method geodesic --from 100000",
                            "--on-edges --links plane",
                            "--refine-where-needed",
                            "--method tree-cotree --weights cotangent",
                            "--method geometry-image --prefer length",
                            "--method morse --levels tight",
                            "--bases 3",
                            "--method tree-cotree --bases 3 --from 2",
                            "--source 3 --tighten graph",
                            "--method geodesic --extrema curved",
                            "--on-edges --refine-where-needed --tighten graph"})
  {
    const auto r = meridian(std::string("cut mesh.obj -o d.obj ") + wrong);
    BOOST_TEST_CONTEXT(wrong)
    {
      BOOST_TEST((r.status == 64));
      BOOST_TEST(r.error.size() > 20u);
      BOOST_TEST(number_of_files() == 4u);
    }
  }
  BOOST_TEST(meridian("cut v_00.obj -o v.obj --family 2").status == 64);
  BOOST_TEST((program::read(folder() / "v_00.obj") == before));
  for (const char* unusable :
       {"--values few.txt", "--values bad.txt", "--values none.txt", "--prefer weights --vertex-weights bad.txt",
        "--field eigenfunction --eigenfunction 100000"})
    BOOST_TEST(meridian(std::string("cut mesh.obj -o d.obj ") + unusable).status == 1);
  BOOST_TEST(program::read(folder() / "few.txt") == "1 2 3");
}
