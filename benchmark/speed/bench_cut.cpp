// Each part of a cut, and the whole, on plates with holes: 10 thousand to 1 million faces, genus 1 to 1000. Every
// answer is checked before it is timed. Beside the whole stand the time to read the file and the yardstick, one
// assembly, ordering, factorization and solve, measured in the same run with one thread; `of_yardstick` is their ratio.
#include "support.h"
#include "support/sample_surfaces.h"

#include "files/read_mesh.h"
#include "files/write_mesh.h"

#include <meridian/base/Polygon_soup.h>
#include <meridian/base/Result_mesh.h>
#include <meridian/base/Verification.h>
#include <meridian/base/vectors.h>
#include <meridian/curves/contours.h>
#include <meridian/curves/project_contours.h>
#include <meridian/cut/Cut.h>
#include <meridian/cut/cut_to_disc.h>
#include <meridian/cut/link_boundaries.h>
#include <meridian/field/Laplace_system.h>
#include <meridian/field/Node_order.h>
#include <meridian/field/Ordered_surface.h>
#include <meridian/field/Scalar_field.h>
#include <meridian/field/critical_points.h>
#include <meridian/field/edge_weights.h>
#include <meridian/field/solve_harmonic_field.h>
#include <meridian/handles/find_generators.h>
#include <meridian/handles/preference.h>
#include <meridian/handles/select_meridians.h>
#include <meridian/proof/verify_cut.h>
#include <meridian/proof/verify_generators.h>
#include <meridian/result/Assembled_result.h>
#include <meridian/result/assemble_result.h>
#include <meridian/result/recount.h>
#include <meridian/surface/Closed_model.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/Surface_curve.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/examine_surface.h>
#include <meridian/surface/insert_curves.h>
#include <meridian/surface/measures.h>
#include <meridian/surface/open_along.h>
#include <meridian/surface/root_edges.h>

#include <benchmark/benchmark.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <memory>

namespace {

using namespace meridian;

// Everything that the parts start from, made once for a surface.
struct Stages
{
  Polygon_soup soup;
  Triangle_surface root;
  int genus;
  Closed_model graph;
  std::vector<double> weights;
  std::vector<Dirichlet_value> prescribed;
  Scalar_field field;
  Ordered_surface ordered;
  std::vector<Contour> loops;
  std::vector<Loop_candidate> candidates;
  std::vector<Surface_curve> curves;
  Examination examination;
  std::vector<Cut> cuts;
  Assembled_result assembled;

  Stages(int faces, int wanted_genus) : root(plate(faces, static_cast<int>(std::lround(std::sqrt(wanted_genus)))))
  {
    soup = sample::soup(root);
    genus = (2 - sample::euler_characteristic(root)) / 2;
    graph = make_closed_model(root);
    weights = edge_weights(root, Weights::POSITIVE);
    const auto [a, b] = find_distant_nodes(root, graph);
    prescribed = {{a, 0}, {b, 1}};
    field = solve_harmonic_field(root, graph, weights, prescribed);
    ordered = order();
    loops = trace_saddle_loops(ordered);
    for (const Contour& c : loops)
    {
      const Index v = root_vertex(root, ordered.surface, c.saddle);
      candidates.push_back({v, root.points[v], curvature(root, v), length(ordered, c), c.is_longer, {}});
    }
    curves = project();
    examination = examine_surface(soup);
    cuts.push_back(cut_to_disc(root));
    assembled = assemble_result(soup, examination, cuts);
  }
  Ordered_surface order() const
  {
    Ordered_surface m;
    m.surface = divide_chords(root);
    m.graph = graph;
    m.field = field;
    m.order = order_nodes(graph, field);
    simplify_order(graph, m.order, {prescribed[0].node}, {prescribed[1].node});
    for (Index a : graph.node) { m.rank.push_back(m.order.rank[a]); }
    m.critical = find_critical_points(m.surface, m.rank);
    unfold_saddles(root, m);
    return m;
  }
  std::vector<Meridian_choice> select() const
  {
    return select_meridians(ordered, loops, rank_by_preference(candidates, preference::gaussian_curvature));
  }
  std::vector<Surface_curve> project() const
  {
    std::vector<const Contour*> chosen;
    for (const auto& c : select()) { chosen.push_back(&loops[c.loop]); }
    return project_contours(root, ordered, chosen);
  }
};

const Stages& stages(const benchmark::State& state)
{
  static std::pair<std::int64_t, std::int64_t> key;
  static std::unique_ptr<Stages> kept; // one at a time: the largest takes a gigabyte
  const auto wanted = std::make_pair(state.range(0), state.range(1));
  if (!kept || key != wanted)
  {
    kept.reset();
    kept = std::make_unique<Stages>(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
    key = wanted;
  }
  return *kept;
}

// Runs `work` once and checks it, then times it.
template <class Work, class Check> void run(benchmark::State& state, const Work& work, const Check& is_right)
{
  const Stages& s = stages(state);
  if (!is_right(s, work(s)))
  {
    state.SkipWithError("the answer is wrong");
    return;
  }
  for (auto _ : state) { benchmark::DoNotOptimize(work(s)); }
  state.counters["faces"] = static_cast<double>(s.root.number_of_faces());
  state.counters["genus"] = s.genus;
}

double seconds(const std::function<void()>& work)
{
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

void examine(benchmark::State& state)
{
  run(
    state, [](const Stages& s) { return examine_surface(s.soup); },
    [](const Stages& s, const Examination& e) {
      return e.components.size() == 1 && e.components[0].genus() == s.genus;
    });
}

void distant_nodes(benchmark::State& state)
{
  run(
    state, [](const Stages& s) { return find_distant_nodes(s.root, s.graph); },
    [](const Stages&, const auto& p) { return p.first != p.second; });
}

void assembly_and_factorization(benchmark::State& state)
{
  run(
    state,
    [](const Stages& s) {
      return solve_harmonic_field(s.root, s.graph, edge_weights(s.root, Weights::POSITIVE), s.prescribed);
    },
    [](const Stages& s, const Scalar_field& f) {
      return std::all_of(f.value.begin(), f.value.end(), [](double x) { return std::abs(x) <= 1; })
             && f(s.prescribed[1].node) == 1;
    });
}

void order(benchmark::State& state)
{
  run(
    state, [](const Stages& s) { return s.order(); },
    [](const Stages& s, const Ordered_surface& m) { return count(m.critical).saddles == 2 * s.genus; });
}

void contours(benchmark::State& state)
{
  run(
    state, [](const Stages& s) { return trace_saddle_loops(s.ordered); },
    [](const Stages& s, const std::vector<Contour>& l) { return static_cast<int>(l.size()) >= 2 * s.genus; });
}

void selection(benchmark::State& state)
{
  run(
    state, [](const Stages& s) { return s.select(); },
    [](const Stages& s, const auto& c) { return static_cast<int>(c.size()) == s.genus && c.back().genus_after == 0; });
}

void slicing(benchmark::State& state)
{
  run(
    state,
    [](const Stages& s) {
      Refined_surface refined(s.root);
      insert_curves(s.root, refined, s.curves);
      return refined;
    },
    [](const Stages& s, const Refined_surface& r) { return sample::euler_characteristic(r) == 2 - 2 * s.genus; });
}

void links(benchmark::State& state)
{
  run(
    state,
    [](const Stages& s) {
      Refined_surface refined(s.root);
      insert_curves(s.root, refined, s.curves);
      return link_boundaries(s.root, refined);
    },
    [](const Stages& s, const auto& l) { return static_cast<int>(l.size()) == 2 * s.genus - 1; });
}

void opening(benchmark::State& state)
{
  run(
    state, [](const Stages& s) { return open_along(s.cuts[0].surface); },
    [](const Stages& s, const Opened_surface& o) { return o.seams.size() == s.cuts[0].opened.seams.size(); });
}

void recount(benchmark::State& state)
{
  run(
    state, [](const Stages& s) { return verify_cut(s.soup, s.assembled.mesh); },
    [](const Stages&, const Verification& v) { return static_cast<bool>(v); });
}

void whole_cut(benchmark::State& state)
{
  const auto work = [](const Stages& s) {
    const Examination e = examine_surface(s.soup);
    std::vector<Cut> cuts;
    for (const auto& c : e.components) { cuts.push_back(cut_to_disc(c.surface)); }
    const Assembled_result r = assemble_result(s.soup, e, cuts);
    return verify_cut(s.soup, r.mesh);
  };
  run(state, work, [](const Stages&, const Verification& v) { return static_cast<bool>(v); });

  // Pairs of the whole and the yardstick, one after the other, so that a change of the machine's speed hits both.
  const Stages& s = stages(state);
  const std::string path =
    (std::filesystem::temp_directory_path() / ("meridian-" + std::to_string(getpid()) + ".off")).string();
  Result_mesh mesh;
  mesh.points = s.root.points;
  mesh.faces = s.root.triangles;
  std::ofstream(path, std::ios::binary) << files::format_mesh(path, mesh);
  std::vector<double> ratio, yardstick, reading;
  for (int i = 0; i < 5; ++i)
  {
    std::vector<Index> unknown;
    for (Index a = 0; a < s.graph.number_of_nodes; ++a)
      if (a != s.prescribed[0].node && a != s.prescribed[1].node) { unknown.push_back(a); }
    std::vector<double> x(s.graph.number_of_nodes, 0);
    x[s.prescribed[1].node] = 1;
    yardstick.push_back(seconds([&] {
      const auto weights = edge_weights(s.root, Weights::POSITIVE);
      internal::Laplace_system system(s.graph, weights);
      system.solve(
        unknown, [&](Index a) { return x[a]; }, x);
    }));
    ratio.push_back(seconds([&] { benchmark::DoNotOptimize(work(s)); }) / yardstick.back());
    reading.push_back(seconds([&] { benchmark::DoNotOptimize(files::read_mesh(path)); }));
  }
  std::filesystem::remove(path);
  state.counters["yardstick_s"] = median(yardstick);
  state.counters["read_s"] = median(reading);
  state.counters["of_yardstick"] = median(ratio);
}

// Generators, and how long they take in lengths of a cut of the same surface.
void whole_generators(benchmark::State& state)
{
  const Stages& s = stages(state);
  run(
    state, [](const Stages& st) { return verify_generators(st.root, find_generators(st.root)); },
    [](const Stages&, const Generator_verification& v) {
      return static_cast<bool>(v) && v.curves.front().is_symplectic;
    });
  std::vector<double> ratio;
  for (int i = 0; i < 3; ++i)
  {
    const double cut = seconds([&] { benchmark::DoNotOptimize(verify_cut(s.root, cut_to_disc(s.root))); });
    ratio.push_back(seconds([&] { benchmark::DoNotOptimize(verify_generators(s.root, find_generators(s.root))); })
                    / cut);
  }
  state.counters["of_cut"] = median(ratio);
}

} // namespace

int main(int argc, char** argv)
{
  set_up();
  benchmark::Initialize(&argc, argv);
  const std::vector<std::pair<const char*, void (*)(benchmark::State&)>> parts{
    {"examine", examine},
    {"distant_nodes", distant_nodes},
    {"assembly_and_factorization", assembly_and_factorization},
    {"order", order},
    {"contours", contours},
    {"selection", selection},
    {"slicing", slicing},
    {"links", links},
    {"opening", opening},
    {"verification", recount},
    {"whole_cut", whole_cut}};
  for (int faces : {10000, 100000, 1000000})
    for (int genus : {1, 36, 1000})
    {
      if (genus == 1000 && faces == 10000) { continue; } // it takes twenty faces a hole
      for (const auto& [name, part] : parts)
        benchmark::RegisterBenchmark(name, part)
          ->ArgNames({"faces", "genus"})
          ->Args({faces, genus})
          ->Unit(benchmark::kMillisecond);
    }
  for (int faces : {10000, 100000, 1000000})
    for (int genus : {1, 5, 31, 133, 713})
    {
      if (faces < 140 * genus) { continue; }
      benchmark::RegisterBenchmark("whole_generators", whole_generators)
        ->ArgNames({"faces", "genus"})
        ->Args({faces, genus})
        ->Unit(benchmark::kMillisecond);
    }
  benchmark::RunSpecifiedBenchmarks();
}
