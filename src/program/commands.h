// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_COMMANDS_H
#define MERIDIAN_COMMANDS_H

#include <meridian/base/vectors.h>

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace meridian {
namespace program {

// The exit statuses of the program.
enum Exit_status
{
  VERIFIED = 0,
  UNUSABLE_INPUT = 1,
  NOT_VERIFIED = 2,
  NUMERICAL_FAILURE = 3,
  WRONG_USAGE = 64,
  INTERRUPTED = 130
};

// An option whose value does not fit the mesh.
struct Usage_error : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

// What all subcommands share.
struct Common_arguments
{
  std::string report; // a path, or empty
  bool quiet = false;
  bool repair = false;
};

struct Info_arguments : Common_arguments
{
  std::vector<std::string> meshes;
};

// What the commands share that make something of a field.
struct Field_arguments : Common_arguments
{
  std::string mesh, out, view, curves;
  std::vector<Index> minima, maxima; // vertices of the file
  bool has_direction = false, has_from = false, has_extrema = false;
  std::string weights = "positive", field = "harmonic", values, extrema = "distant";
  int eigenfunction = 0; // 0: the genus + 1
  Index from = 0;        // where distances begin, or the loops of tree-cotree
  std::string prefer = "gaussian-curvature", vertex_weights, levels = "saddle";
  std::vector<double> direction{0, 0, 1};
};

struct Cut_arguments : Field_arguments
{
  Index source = 0;
  bool has_source = false;
  std::string method = "contours", join = "surface", links = "surface";
  bool bifurcations = false;
  std::string tighten = "curves";
  bool on_edges = false, refine_where_needed = false;
  int bases = 16;
  bool has_bases = false;
  int family = 0; // how many cuts; 0: one, as chosen
};

struct Unwrap_arguments : Cut_arguments // with a family, the best of its members
{
  std::string parameterization = "symmetric-dirichlet", border = "free";
  bool has_border = false;
  double stretch_weight = 0, max_stretch = 0;
  std::string layout, texture, distortion; // paths, or empty
  int geometry_image = 0;                  // pixels along a side, or 0
};

struct Compare_arguments : Common_arguments
{
  std::string mesh;
  std::vector<std::string> cuts; // a result of `cut` or `unwrap`, or the number of a member of the family
  std::string weights = "positive";
};

struct Generator_arguments : Field_arguments
{
  std::string basis = "pairs", longitudes = "flow", mode = "closed";
  bool no_tighten = false, complex = false;
};

struct Verify_arguments : Common_arguments
{
  std::string mesh, result;
};

// A command as it was added to the parser, and what it does once its options are parsed.
struct Command
{
  const CLI::App* parser;
  std::function<int()> run; // returns the exit status
};

Command add_info(CLI::App& app);
Command add_cut(CLI::App& app);
Command add_unwrap(CLI::App& app);
Command add_compare(CLI::App& app);
Command add_generators(CLI::App& app);
Command add_verify(CLI::App& app);

int run_family(const Cut_arguments& arguments); // of `cut`

// From the first call on, an interrupting signal only sets what the second tells, and the run ends at its next step and
// takes what it has written with it. Until then signals end the program at once, so that a read that blocks can be
// ended.
void heed_interrupts();
bool is_interrupted();

} // namespace program
} // namespace meridian

#endif // MERIDIAN_COMMANDS_H
