// What the program costs in measures of the same run: of reading and writing the files, of one factorization of the
// mesh's own Laplacian, of another command. usage: bench_targets PROGRAM [MESH | faces:N ...]
//
// Times are seconds of whole processes, the median of three; each ratio is one of CPU seconds within one round.
// Meshes of more than two million faces are cut once, and no more. Each answer
// is verified by the program before it counts.
#include "../child_process.h"
#include "support.h"
#include "support/sample_surfaces.h"

#include "files/read_mesh.h"
#include "files/write_mesh.h"

#include <meridian/base/Result_mesh.h>
#include <meridian/base/vectors.h>
#include <meridian/cut/Cut.h>
#include <meridian/cut/cut_to_disc.h>
#include <meridian/field/Laplace_system.h>
#include <meridian/field/edge_weights.h>
#include <meridian/proof/verify_cut.h>
#include <meridian/result/assemble_result.h>
#include <meridian/surface/Closed_model.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/examine_surface.h>
#include <meridian/surface/shortest_ways.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/OFF.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace {

using namespace meridian;
namespace fs = std::filesystem;

bool is_right = true; // every answer so far

// The cost of a child process, which must end with status 0.
Cost of_child(const std::function<void()>& work)
{
  const Child child = run_child(work);
  is_right = is_right && child.status == 0;
  return child.cost;
}

Cost of_program(std::vector<std::string> words)
{
  const Child child = run_program(std::move(words));
  is_right = is_right && child.status == 0;
  return child.cost;
}

// A mesh as a file, and what is measured on it.
class Mesh_costs
{
public:
  Mesh_costs(std::string program, const fs::path& folder, const Polygon_soup& soup)
    : m_program(std::move(program)), m_input(folder / "input.off"), m_folder(folder)
  {
    Examination e = examine_surface(soup);
    if (e.components.empty()) { std::exit(1); }
    m_genus = e.components.front().genus();
    m_surface = std::move(e.components.front().surface);
    m_soup = sample::soup(m_surface);
    Result_mesh mesh;
    mesh.points = m_surface.points;
    mesh.faces = m_surface.triangles;
    std::ofstream(m_input, std::ios::binary) << files::format_mesh(m_input, mesh);
  }

  Index faces() const { return m_surface.number_of_faces(); }
  Index vertices() const { return m_surface.number_of_vertices(); }
  int genus() const { return m_genus; }

  Cost run(const char* command, std::initializer_list<const char*> options = {}) const
  {
    std::vector<std::string> words{m_program, command, m_input, "-o", m_folder / "output.obj"};
    words.insert(words.end(), options.begin(), options.end());
    return of_program(words);
  }

  Cost read_and_write() const
  {
    return of_child([&] {
      CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> mesh;
      if (!CGAL::IO::read_OFF(m_input, mesh)) { _exit(1); }
      CGAL::IO::write_OFF(m_folder / "copy.off", mesh, CGAL::parameters::stream_precision(17));
    });
  }

  // Dijkstra's algorithm on edges once, and all edges sorted.
  Cost search_and_sort() const
  {
    return of_child([&] {
      const auto way = internal::find_shortest_ways(vertices(), {{0., 0}}, [&](Index v, const auto& reach) {
        m_surface.for_each_outgoing(v, [&](Index h) { reach(m_surface.target(h), m_surface.length(h)); });
      });
      std::vector<std::pair<double, Index>> edges;
      for (Index h = 0; h < m_surface.number_of_halfedges(); ++h)
      {
        if (m_surface.edge(h) == h) { edges.emplace_back(m_surface.length(h) + way[m_surface.source(h)], h); }
      }
      std::sort(edges.begin(), edges.end());
      if (!std::is_sorted(edges.begin(), edges.end())) { _exit(1); }
    });
  }

  // A cut without files: examined, cut and recounted.
  Cost cut_in_memory() const
  {
    return of_child([&] {
      const Examination e = examine_surface(m_soup);
      std::vector<Cut> cuts;
      Cut_options curves_alone;
      curves_alone.tightening = Tightening::CURVES;
      cuts.push_back(cut_to_disc(e.components.front().surface, curves_alone));
      if (!verify_cut(m_soup, assemble_result(m_soup, e, cuts).mesh)) { _exit(1); }
    });
  }

  // The Laplacian assembled, ordered and factorized once by the direct solver, and one solution.
  Cost factorization() const
  {
    return of_child([&] {
      const Closed_model graph = make_closed_model(m_surface);
      const auto weights = edge_weights(m_surface, Weights::POSITIVE);
      std::vector<Index> unknown;
      for (Index a = 1; a < graph.number_of_nodes; ++a) { unknown.push_back(a); }
      std::vector<double> x(graph.number_of_nodes, 0);
      x[0] = 1;
      internal::Laplace_system(graph, weights)
        .solve(
          unknown, [](Index) { return 1.; }, x);
    });
  }

private:
  std::string m_program;
  fs::path m_input, m_folder;
  Triangle_surface m_surface;
  Polygon_soup m_soup; // of the same
  int m_genus = 0;
};

// Prints the median of the ratios of two costs, the first of them at its median.
void print(const std::string& mesh, const char* what, const char* of, double target, std::vector<Cost> costs,
           const std::vector<Cost>& measures)
{
  std::vector<double> ratio;
  for (std::size_t i = 0; i < costs.size(); ++i) { ratio.push_back(costs[i].seconds / measures[i].seconds); }
  std::sort(costs.begin(), costs.end(), [](const Cost& a, const Cost& b) { return a.seconds < b.seconds; });
  const Cost& c = costs[costs.size() / 2];
  std::printf("| %s | %s | %.2f | %.2f | %.0f | %s | %.2f | %.1f |\n", mesh.c_str(), what, c.seconds, c.wall,
              c.megabytes, of, median(ratio), target);
  std::fflush(stdout);
}

void measure(const std::string& name, const Mesh_costs& mesh)
{
  constexpr Index most_unwrapped = 400000, small = 110000, huge = 2000000; // faces
  constexpr int few = 110;                                                 // handles
  std::map<std::string, std::vector<Cost>> all;
  const bool is_huge = mesh.faces() > huge;
  for (int i = 0; i < (is_huge ? 1 : 3); ++i)
  {
    all["files"].push_back(mesh.read_and_write());
    all["cut"].push_back(mesh.run("cut"));
    all["curves"].push_back(mesh.run("cut", {"--tighten", "curves"}));
    if (is_huge) { continue; }
    all["tree"].push_back(mesh.run("cut", {"--method", "tree-cotree", "--bases", "1"}));
    all["search"].push_back(mesh.search_and_sort());
    all["search"].back().seconds += all["files"].back().seconds;
    all["generators"].push_back(mesh.run("generators"));
    all["factorization"].push_back(mesh.factorization());
    all["memory"].push_back(mesh.cut_in_memory());
    if (mesh.faces() <= most_unwrapped)
    {
      all["unwrap"].push_back(mesh.run("unwrap"));
      all["seams"].push_back(mesh.run("unwrap", {"--shortest-seams"}));
    }
  }
  print(name, "cut, curves tightened", "reading and writing", 1.5, all["curves"], all["files"]);
  print(name, "cut", "the same", 1.5, all["cut"], all["curves"]);
  if (is_huge) { return; }
  print(name, "cut, curves, files not", "factorization", 0.6, all["memory"], all["factorization"]);
  print(name, "cut, tree-cotree", "Dijkstra, sorting, reading and writing", 1.2, all["tree"], all["search"]);
  print(name, "generators", "cut", mesh.genus() < few ? 2 : 4, all["generators"], all["cut"]);
  if (all["unwrap"].empty()) { return; }
  const double aim = mesh.faces() < small ? 20 : 40;
  print(name, "unwrap", "factorization", aim, all["unwrap"], all["factorization"]);
  print(name, "unwrap, shortest seams", "factorization", aim, all["seams"], all["factorization"]);
}

} // namespace

int main(int argc, char** argv)
{
  set_up();
  if (argc < 2)
  {
    std::fputs("usage: bench_targets PROGRAM [MESH | faces:N ...]\n", stderr);
    return 64;
  }
  const fs::path folder = fs::temp_directory_path() / ("meridian-targets-" + std::to_string(getpid()));
  fs::create_directory(folder);
  std::vector<std::string> meshes(argv + 2, argv + argc);
  if (meshes.empty()) { meshes = {"faces:100000", "faces:300000"}; }
  std::puts("| mesh | what | CPU s | s | MB | measure | ratio | target |\n|---|---|---|---|---|---|---|---|");
  for (const std::string& name : meshes)
  {
    const bool is_made = name.rfind("faces:", 0) == 0;
    const Mesh_costs mesh(fs::absolute(argv[1]), folder,
                          is_made ? sample::soup(plate(std::atoi(name.c_str() + 6), 3)) : files::read_mesh(name));
    measure(is_made ? "plate, " + std::to_string(mesh.faces()) : fs::path(name).filename().string(), mesh);
  }
  fs::remove_all(folder);
  if (!is_right) { std::puts("ERROR: not every answer was right"); }
  return is_right ? 0 : 1;
}
