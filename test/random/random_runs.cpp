// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the program on random meshes with random options, and counts each result twice: by `meridian verify` and by the
// second recount. `random_runs FIRST COUNT` runs seeds FIRST to FIRST + COUNT - 1; each is a run that can be repeated.
// A run that fails is made smaller, of its options and of its faces, and left in the current folder.
#include "random/random_mesh.h"

#include "recount/recount.h"
#include "support/run_program.h"

#include <algorithm>
#include <iostream>
#include <map>
#include <string>
#include <vector>

namespace random_runs {

namespace {

using Options = std::vector<std::string>; // each with its values

struct Run
{
  Mesh mesh;
  std::string command;
  Options options;

  std::string line() const
  {
    std::string text = command + " mesh.off -o out.obj";
    for (const std::string& option : options) { text += ' ' + option; }
    return text;
  }
};

enum class Outcome
{
  COMPUTED,
  MISSED, // a wish, and the program says so
  REFUSED,
  FAILED
};

struct Judgement
{
  Outcome outcome;
  std::string text;
};

const char* const too_long = "it takes too long";

Options field_options(Random& random, int vertices)
{
  const std::string v = std::to_string(random.below(vertices)), w = std::to_string(random.below(vertices));
  Options all{"--field eigenfunction",
              "--field distance",
              "--field distance --from " + v,
              "--eigenfunction 2",
              "--weights mean-value",
              "--weights cotangent",
              "--weights intrinsic-delaunay",
              "--extrema curved",
              "--minimum " + v + " --maximum " + w,
              "--prefer mean-curvature",
              "--prefer length",
              "--prefer position --direction 1 0.5 0.25",
              "--prefer hidden --direction 0 0 1",
              "--levels tight"};
  return {random.one_of(all)};
}

Options cut_options(Random& random, int vertices)
{
  const Options all{"--method generators",
                    "--method generators --join complex",
                    "--method generators --join saddles",
                    "--method morse",
                    "--method geodesic",
                    "--method tree-cotree",
                    "--method tree-cotree --bases 3",
                    "--method geometry-image",
                    "--tighten no",
                    "--tighten curves",
                    "--tighten graph",
                    "--on-edges",
                    "--on-edges --refine-where-needed",
                    "--links plane",
                    "--bifurcations",
                    "--source " + std::to_string(random.below(vertices))};
  return {random.one_of(all)};
}

Options unwrap_options(Random& random)
{
  const Options all{"--charts 3",
                    "--charts auto",
                    "--parameterization conformal",
                    "--parameterization positive --border square",
                    "--parameterization stretch",
                    "--parameterization tutte",
                    "--parameterization mean-value",
                    "--border circle",
                    "--max-stretch 1.05",
                    "--shortest-seams",
                    "--stretch-weight 0.5 --family 2",
                    "--resolution 64x256 --padding 1",
                    "--seams sharp:40",
                    "--chart-per smooth-angle",
                    "--symmetry",
                    "--geometry-image 9"};
  return {random.one_of(all)};
}

Options generator_options(Random& random)
{
  const Options all{"--basis shortest", "--basis shortest --no-tighten",
                    "--longitudes arc", "--no-tighten",
                    "--mode open",      "--complex"};
  return {random.one_of(all)};
}

Run make_run(unsigned seed)
{
  Random random(seed);
  Run run;
  run.mesh = random_mesh(random);
  run.command = random.one_of(std::vector<std::string>{"cut", "unwrap", "generators"});
  const int vertices = static_cast<int>(run.mesh.points.size());
  const auto add = [&](const Options& more) { run.options.insert(run.options.end(), more.begin(), more.end()); };
  if (random.once_in(2)) { add(field_options(random, vertices)); }
  if (run.command != "generators" && random.once_in(2)) { add(cut_options(random, vertices)); }
  if (run.command == "unwrap" && random.once_in(2)) { add(unwrap_options(random)); }
  if (run.command == "generators" && random.once_in(2)) { add(generator_options(random)); }
  if (random.once_in(2)) { run.options.emplace_back("--repair"); }
  return run;
}

Judgement judge(const Run& run)
{
  constexpr int unusable = 1, missed = 2, numerical = 3, wrong_usage = 64, killed = 137, used_up = 152;
  const program::Workplace place;
  place.write("mesh.off", format_off(run.mesh));
  const std::string program = "ulimit -t 20; timeout -s KILL 200 '" MERIDIAN_PROGRAM "' ";
  const program::Result r = place.shell(program + run.line());
  const bool has_result = program::fs::exists(place.folder() / "out.obj");
  if (r.status == killed || r.status == used_up) { return {Outcome::FAILED, too_long}; }
  if (r.error.find("internal error") != std::string::npos) { return {Outcome::FAILED, r.error}; }
  if (r.status == unusable || r.status == wrong_usage)
  {
    if (place.number_of_files() != 1) { return {Outcome::FAILED, "it was refused, and left files"}; }
    return {Outcome::REFUSED, r.error};
  }
  if (r.status == numerical && r.error.find("the symmetric positive weights are the safest") != std::string::npos)
  {
    return {Outcome::MISSED, r.error};
  }
  if (r.status != 0 && (r.status != missed || r.error.find("not verified:") != std::string::npos))
  {
    return {Outcome::FAILED, "status " + std::to_string(r.status) + ": " + r.error};
  }
  if (!has_result) { return {r.status == missed ? Outcome::MISSED : Outcome::FAILED, r.error}; }
  const program::Result verified = place.shell(program + "verify mesh.off out.obj");
  if (verified.status != 0) { return {Outcome::FAILED, "verify: " + verified.error}; }
  const auto failures =
    recount::failures_of((place.folder() / "mesh.off").string(), (place.folder() / "out.obj").string());
  if (!failures.empty()) { return {Outcome::FAILED, "recount: " + failures.front()}; }
  return {r.status == missed ? Outcome::MISSED : Outcome::COMPUTED, r.error};
}

// Leaves out options, and then faces, as long as the run fails.
void reduce(Run& run)
{
  int tries = 200;
  const auto still_fails = [&](const Run& r) { return tries-- > 0 && judge(r).outcome == Outcome::FAILED; };
  for (std::size_t i = run.options.size(); i-- > 0;)
  {
    Run less = run;
    less.options.erase(less.options.begin() + static_cast<std::ptrdiff_t>(i));
    if (still_fails(less)) { run = less; }
  }
  for (std::size_t step = run.mesh.faces.size() / 2; step > 0 && tries > 0; step /= 2)
    for (std::size_t i = 0; i + step <= run.mesh.faces.size();)
    {
      Run less = run;
      const auto first = less.mesh.faces.begin() + static_cast<std::ptrdiff_t>(i);
      less.mesh.faces.erase(first, first + static_cast<std::ptrdiff_t>(step));
      if (!less.mesh.faces.empty() && still_fails(less)) { run = less; }
      else { i += step; }
    }
}

} // namespace

} // namespace random_runs

int main(int argc, char** argv)
{
  using namespace random_runs;
  const auto [first, count] = read_arguments(argc, argv);
  std::map<Outcome, unsigned> outcomes;
  for (unsigned seed = first; seed < first + count; ++seed)
  {
    Run run = make_run(seed);
    const Judgement j = judge(run);
    ++outcomes[j.outcome];
    if (j.outcome != Outcome::FAILED) { continue; }
    std::cout << "seed " << seed << ": " << run.line() << "\n  " << run.mesh.faces.size()
              << " faces:" << run.mesh.description << "\n  " << j.text << std::endl;
    if (j.text != too_long) { reduce(run); }
    const std::string name = "random-" + std::to_string(seed) + ".off";
    std::ofstream(name) << format_off(run.mesh);
    std::cout << "  smaller: " << run.line() << ", " << run.mesh.faces.size() << " faces, in " << name << std::endl;
  }
  std::cout << count << " runs: " << outcomes[Outcome::COMPUTED] << " verified and counted twice, "
            << outcomes[Outcome::MISSED] << " missed a wish and said so, " << outcomes[Outcome::REFUSED] << " refused, "
            << outcomes[Outcome::FAILED] << " failed\n";
  return outcomes[Outcome::FAILED] == 0 && outcomes[Outcome::COMPUTED] > count / 3 ? 0 : 1;
}
