// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_COMMANDS_H
#define MERIDIAN_COMMANDS_H

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace meridian {

namespace files {
class Output_files;
}

namespace program {

// The exit statuses of the program.
enum Exit_status
{
  VERIFIED = 0,
  UNUSABLE_INPUT = 1,
  NOT_VERIFIED = 2,
  NUMERICAL_FAILURE = 3,
  WRONG_USAGE = 64,
  OUTPUT_LOST = 74,
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

Command add_completion(CLI::App& app);
Command add_info(CLI::App& app);
Command add_cut(CLI::App& app);
Command add_unwrap(CLI::App& app);
Command add_pack(CLI::App& app);
Command add_compare(CLI::App& app);
Command add_generators(CLI::App& app);
Command add_verify(CLI::App& app);

// Moves files to their places. An interrupting signal ends the program where it is; from this call on it does no more,
// so that all of them get there. Throws File_error.
void commit(files::Output_files& out);

} // namespace program
} // namespace meridian

#endif // MERIDIAN_COMMANDS_H
