// Cuts real meshes with the program, and compares what it counts with a list: MERIDIAN_CORPUS names a folder that holds
// MANIFEST.csv with the columns file, F, components, genus_sum and loops_sum. Exit status 77 if the variable is not
// set.
//
// test_corpus manifest  all meshes of the list but the largest
// test_corpus large     the largest, and the folder xl
// test_corpus generators  those of up to 120 thousand faces; `generators all` takes all, and the folder xl
// test_corpus choices   small meshes of the list with every choice of a field, a preference, a method and so on;
//                       `choices all` takes all
// test_corpus unwrap    small meshes of the list with texture coordinates, in a table; `unwrap all` takes those of up
//                       to 120 thousand faces
// test_corpus bad       the folder bad: each is repaired and cut, or refused with a reason
#include "support/run_program.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <map>
#include <vector>

namespace {

namespace fs = std::filesystem;
constexpr std::uintmax_t large_size = 1900000; // bytes of a packed file
constexpr int small_mesh = 12000;              // faces
constexpr int middle_mesh = 120000;

int failures = 0, passed = 0;

void check(bool holds, const std::string& file, const std::string& text)
{
  if (holds) { return; }
  ++failures;
  std::cout << "FAILED " << file << ": " << text << '\n';
}

std::vector<std::map<std::string, std::string>> read_manifest(const fs::path& path)
{
  std::vector<std::map<std::string, std::string>> rows;
  std::vector<std::string> names;
  std::istringstream lines(program::read(path));
  for (std::string line; std::getline(lines, line);)
  {
    std::vector<std::string> fields(1);
    bool is_quoted = false;
    for (char c : line)
    {
      if (c == '"') { is_quoted = !is_quoted; }
      else if (c == ',' && !is_quoted) { fields.emplace_back(); }
      else { fields.back() += c; }
    }
    if (names.empty())
    {
      names = fields;
      continue;
    }
    rows.emplace_back();
    for (std::size_t i = 0; i < names.size() && i < fields.size(); ++i) { rows.back()[names[i]] = fields[i]; }
  }
  return rows;
}

std::string quoted(const fs::path& path) { return "'" + path.string() + "'"; }

// Cuts and recounts one mesh; returns its report.
nlohmann::json cut(const program::Workplace& workplace, const fs::path& mesh)
{
  const std::string name = mesh.filename().string();
  const auto r = workplace.meridian("cut " + quoted(mesh) + " -o out.ply --report report.json");
  check(r.status == 0, name, "exit status " + std::to_string(r.status) + ": " + r.error);
  if (r.status != 0) { return {}; }
  const auto report = nlohmann::json::parse(program::read(workplace.folder() / "report.json"));
  check(report["verified"] == true, name, "not verified");
  const auto verify = workplace.meridian("verify " + quoted(mesh) + " out.ply");
  check(verify.status == 0, name, "verify: exit status " + std::to_string(verify.status) + ": " + verify.error);
  std::cout << name << ": " << r.out.substr(r.out.rfind("verified")) << std::flush;
  workplace.shell("rm -f out.ply out.map.json report.json");
  ++passed;
  return report;
}

// Finds and recounts the generators of one mesh.
void find_generators(const program::Workplace& workplace, const fs::path& mesh)
{
  const std::string name = mesh.filename().string();
  const auto r = workplace.meridian("generators " + quoted(mesh) + " -o out.obj --report report.json");
  check(r.status == 0, name, "generators: exit status " + std::to_string(r.status) + ": " + r.error);
  if (r.status != 0) { return; }
  const auto report = nlohmann::json::parse(program::read(workplace.folder() / "report.json"));
  int flow = 0, pairs = 0;
  for (const auto& c : report["components"])
  {
    check(c["generators"].size() == c["genus"], name, "the pairs are not as many as the genus");
    check(c["intersection_matrix"] == "symplectic", name, "the intersection matrix is not symplectic");
    check(c["is_basis"] == true, name, "not a basis");
    for (const auto& pair : c["generators"])
    {
      ++pairs;
      flow += pair["longitude"]["was_flow"] == true;
    }
  }
  const auto verify = workplace.meridian("verify " + quoted(mesh) + " out.obj");
  check(verify.status == 0, name, "verify: exit status " + std::to_string(verify.status) + ": " + verify.error);
  std::cout << name << ": " << r.out.substr(r.out.rfind("verified")) << name << ": " << flow << " of " << pairs
            << " longitudes came from flow lines\n"
            << std::flush;
  workplace.shell("rm -f out.obj out.map.json report.json");
  ++passed;
}

void run_manifest(const fs::path& corpus, bool large)
{
  const program::Workplace workplace;
  const auto rows = read_manifest(corpus / "MANIFEST.csv");
  check(!rows.empty(), "MANIFEST.csv", "no meshes");
  for (const auto& row : rows)
  {
    const fs::path mesh = corpus / row.at("file");
    if ((fs::file_size(mesh) > large_size) != large) { continue; }
    const auto report = cut(workplace, mesh);
    if (report.is_null()) { continue; }
    int genus = 0, loops = 0;
    for (const auto& c : report["components"])
    {
      genus += c["genus"].get<int>();
      loops += c["boundary_loops"].get<int>();
      check(c["field"]["saddles"]
              == (c["genus"] == 0 ? 0
                                  : 2 * c["genus"].get<int>() + c["field"]["minima"].get<int>()
                                      + c["field"]["maxima"].get<int>() - 2),
            row.at("file"), "the saddles are not 2g + minima + maxima - 2");
      const auto& graph =
        c["cut"]; // that was tightened: if all meridians keep their names, links do, and otherwise none
      const bool has_all = graph["meridians"].size() == c["genus"];
      check(graph["meridians"].size() <= c["genus"] && (has_all ? graph["paths"] : graph["links"]).empty(),
            row.at("file"), "the names of curves are not those that a graph may keep");
    }
    const auto expect = [&](const char* column, int found) {
      check(std::stoi(row.at(column)) == found, row.at("file"),
            std::string(column) + " is " + row.at(column) + ", counted " + std::to_string(found));
    };
    expect("components", static_cast<int>(report["components"].size()));
    expect("genus_sum", genus);
    expect("loops_sum", loops);
  }
  if (large && fs::exists(corpus / "xl"))
    for (const auto& entry : fs::directory_iterator(corpus / "xl")) { cut(workplace, entry.path()); }
}

void run_generators(const fs::path& corpus, bool all)
{
  const program::Workplace workplace;
  for (const auto& row : read_manifest(corpus / "MANIFEST.csv"))
  {
    if (all || std::stoi(row.at("F")) <= middle_mesh) { find_generators(workplace, corpus / row.at("file")); }
  }
  if (all && fs::exists(corpus / "xl"))
    for (const auto& entry : fs::directory_iterator(corpus / "xl")) { find_generators(workplace, entry.path()); }
}

// Every field, preference, level, method and tightening: verified, or refused for one of the reasons that the manual
// gives.
void run_choices(const fs::path& corpus, bool all)
{
  const program::Workplace workplace;
  std::map<std::string, int> refused;
  for (const auto& row : read_manifest(corpus / "MANIFEST.csv"))
  {
    if (!all && std::stoi(row.at("F")) > small_mesh) { continue; }
    const fs::path mesh = corpus / row.at("file");
    for (const std::string option : {"--field eigenfunction",
                                     "--field eigenfunction --weights intrinsic-delaunay --eigenfunction 1",
                                     "--field distance",
                                     "--weights intrinsic-delaunay",
                                     "--weights cotangent --extrema curved",
                                     "--weights mean-value",
                                     "--prefer mean-curvature --levels tight",
                                     "--prefer length",
                                     "--prefer hidden --direction 1 2 3",
                                     "--prefer position --direction 0 1 0 --tighten no",
                                     "--tighten graph",
                                     "--on-edges",
                                     "--on-edges --refine-where-needed",
                                     "--on-edges --tighten graph",
                                     "--method geodesic --links plane",
                                     "--method generators --tighten graph",
                                     "--method morse",
                                     "--method tree-cotree",
                                     "--method geometry-image",
                                     "--bifurcations --levels tight"})
    {
      const std::string name = mesh.filename().string() + " " + option;
      const auto r = workplace.meridian("cut " + quoted(mesh) + " -o out.ply " + option);
      if (r.status == 0)
      {
        const auto verify = workplace.meridian("verify " + quoted(mesh) + " out.ply");
        check(verify.status == 0, name, "verify: exit status " + std::to_string(verify.status) + ": " + verify.error);
        ++passed;
      }
      else
      {
        check(r.status == 1 && option == "--on-edges" && r.error.find("too coarse") != std::string::npos, name,
              "exit status " + std::to_string(r.status) + ": " + r.error);
        ++refused[option];
      }
      workplace.shell("rm -f out.ply out.map.json");
    }
    std::cout << row.at("file") << '\n' << std::flush;
  }
  for (const auto& [option, count] : refused)
  {
    std::cout << option << ": " << count << " meshes refused as too coarse\n";
  }
}

// Charts: each a disc, none over another, at the stretch that was asked for or with a word that it is not.
void check_charts(const program::Workplace& workplace, const fs::path& mesh, const std::string& name)
{
  const auto r = workplace.meridian("unwrap " + quoted(mesh) + " -o out.obj --charts auto --report report.json");
  const auto report = nlohmann::json::parse(program::read(workplace.folder() / "report.json"));
  check(r.status == 0 || (r.status == 2 && !report["missed"].empty()), name,
        "unwrap --charts auto: exit status " + std::to_string(r.status) + ": " + r.error);
  check(report["failures"].empty(), name, "charts: " + report["failures"].dump());
  const auto verify = workplace.meridian("verify " + quoted(mesh) + " out.obj");
  check(verify.status == 0, name, "verify: exit status " + std::to_string(verify.status) + ": " + verify.error);
  for (const auto& c : report["components"])
  {
    check(r.status == 2 || c["parameterization"]["stretch_l2"] <= 1.02, name, "charts stretch to more than 1.02");
    check(c["cut"]["euler_characteristic"] == c["parameterization"]["charts"], name, "charts are no discs");
  }
  check(report["texture"]["coverage"] >= 0.3, name, "charts fill less than 0.3 of the square");
  workplace.shell("rm -f out.obj out.map.json report.json");
}

// Texture coordinates: verified, without flipped faces, and one-to-one.
void run_unwrap(const fs::path& corpus, bool all)
{
  const program::Workplace workplace;
  std::cout << "| mesh | faces | genus | loops | charts | method | L2 stretch | Linf stretch | angle | area | seconds "
               "|\n|---|---|---|---|---|---|---|---|---|---|---|\n";
  for (const auto& row : read_manifest(corpus / "MANIFEST.csv"))
  {
    constexpr int quick_mesh = 15000; // all others take minutes
    if (std::stoi(row.at("F")) > (all ? middle_mesh : quick_mesh)) { continue; }
    const fs::path mesh = corpus / row.at("file");
    const std::string name = mesh.filename().string();
    const auto r = workplace.meridian("unwrap " + quoted(mesh) + " -o out.obj --report report.json");
    check(r.status == 0, name, "unwrap: exit status " + std::to_string(r.status) + ": " + r.error);
    if (r.status != 0) { continue; }
    const auto verify = workplace.meridian("verify " + quoted(mesh) + " out.obj");
    check(verify.status == 0, name, "verify: exit status " + std::to_string(verify.status) + ": " + verify.error);
    const auto report = nlohmann::json::parse(program::read(workplace.folder() / "report.json"));
    std::map<std::string, int> methods;
    double faces = 0, seconds = 0, worst = 0;
    std::array<double, 3> sum{0, 0, 0}; // square of the stretch, angle and area, by faces
    for (const auto& c : report["components"])
    {
      const auto& p = c["parameterization"];
      check(p["flipped"] == 0, name, "flipped faces");
      check(p["one_to_one"] == true, name, "a chart overlaps itself");
      ++methods[p["method"]];
      const double n = c["faces"], stretch = p["stretch_l2"];
      faces += n;
      sum[0] += n * stretch * stretch;
      sum[1] += n * p["angle"].get<double>();
      sum[2] += n * p["area"].get<double>();
      worst = std::max(worst, p["stretch_linf"].get<double>());
      seconds += c["seconds"]["parameterize"].get<double>();
    }
    std::cout << "| " << row.at("file").substr(0, row.at("file").find('.')) << " | " << row.at("F") << " | "
              << row.at("genus_sum") << " | " << row.at("loops_sum") << " | " << report["components"].size() << " |";
    for (const auto& [method, count] : methods)
    {
      std::cout << ' ' << method << (methods.size() > 1 ? " (" + std::to_string(count) + ")" : "");
    }
    std::cout << std::flush;
    std::printf(" | %.3f | %.4g | %.1f | %.2f | %.1f |\n", std::sqrt(sum[0] / faces), worst, sum[1] / faces,
                sum[2] / faces, seconds);
    std::fflush(stdout);
    workplace.shell("rm -f out.obj out.map.json report.json");
    constexpr int small_enough = 15000; // the others take as long again
    if (all || std::stoi(row.at("F")) < small_enough) { check_charts(workplace, mesh, name); }
    ++passed;
  }
}

void run_bad(const fs::path& corpus)
{
  std::vector<fs::path> meshes;
  for (const auto& entry : fs::directory_iterator(corpus / "bad"))
  {
    if (entry.path().extension() != ".csv") { meshes.push_back(entry.path()); }
  }
  std::sort(meshes.begin(), meshes.end());
  check(!meshes.empty(), "bad", "no meshes");
  for (const fs::path& mesh : meshes)
    for (const char* option : {"", " --repair"})
    {
      const program::Workplace workplace;
      const std::string name = mesh.filename().string() + option;
      const auto r = workplace.meridian("cut " + quoted(mesh) + " -o out.off" + option);
      if (r.status == 0)
      {
        check(workplace.meridian("verify " + quoted(mesh) + " out.off").status == 0, name, "verify does not agree");
        std::cout << name << ": " << r.out << std::flush;
      }
      else
      {
        check(r.status == 1, name, "exit status " + std::to_string(r.status) + ": " + r.error);
        check(r.error.size() > 30, name, "refused without a reason");
        check(workplace.number_of_files() == 0, name, "a file was left behind");
        std::cout << name << ": " << r.error << std::flush;
      }
      ++passed;
    }
}

} // namespace

int main(int argc, char** argv)
{
  const char* corpus = std::getenv("MERIDIAN_CORPUS");
  if (!corpus || !*corpus)
  {
    std::cout << "MERIDIAN_CORPUS is not set\n";
    return 77;
  }
  const std::string set = argc > 1 ? argv[1] : "manifest";
  if (set == "bad") { run_bad(corpus); }
  else if (set == "generators") { run_generators(corpus, argc > 2 && std::string(argv[2]) == "all"); }
  else if (set == "unwrap") { run_unwrap(corpus, argc > 2 && std::string(argv[2]) == "all"); }
  else if (set == "choices") { run_choices(corpus, argc > 2 && std::string(argv[2]) == "all"); }
  else { run_manifest(corpus, set == "large"); }
  std::cout << passed << " runs, " << failures << " failures\n";
  return failures == 0 && passed > 0 ? 0 : 1;
}
