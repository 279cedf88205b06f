// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.h"
#include "files/Output_files.h"
#include "files/read_mesh.h"
#include "memory.h"

#include <meridian/base/exceptions.h>

#include <CLI/CLI.hpp>

#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <iostream>
#include <new>
#include <vector>

// OpenBLAS, where it is the BLAS of this system, must not split sums between threads: equal bytes out for equal bytes
// in. CHOLMOD's own threads only wait for each other on the small blocks of a surface mesh.
extern "C" void openblas_set_num_threads(int) __attribute__((weak));
extern "C" void omp_set_max_active_levels(int) __attribute__((weak));

namespace {

// Nothing has to be put in order: files have no name until the end, where signals are held.
extern "C" void interrupt(int)
{
  constexpr char message[] = "meridian: interrupted; nothing was written\n";
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, message, sizeof message - 1);
  _exit(meridian::program::INTERRUPTED);
}

void listen_to_signals()
{
  std::signal(SIGINT, interrupt);
  std::signal(SIGTERM, interrupt);
  std::signal(SIGPIPE, SIG_IGN); // writing fails, then, and is told of
#ifdef SIGXFSZ
  std::signal(SIGXFSZ, SIG_IGN);
#endif
}

} // namespace

namespace meridian {
namespace program {

void commit(files::Output_files& out)
{
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  sigprocmask(SIG_BLOCK, &signals, nullptr);
  out.commit();
}

} // namespace program
} // namespace meridian

namespace {

using namespace meridian::program;

int complain(const char* text, int status)
{
  std::cerr << "meridian: " << text << '\n';
  return status;
}

// Runs a command, and says in a line what went wrong.
int run(const Command& command)
{
  try
  {
    return command.run();
  }
  catch (const Usage_error& e)
  {
    return complain(e.what(), WRONG_USAGE);
  }
  catch (const meridian::Invalid_input_error& e)
  {
    return complain(e.what(), UNUSABLE_INPUT);
  }
  catch (const meridian::files::File_error& e)
  {
    return complain(e.what(), UNUSABLE_INPUT);
  }
  catch (const meridian::Solver_error& e)
  {
    return complain(e.what(), NUMERICAL_FAILURE);
  }
  catch (const std::bad_alloc&)
  {
    return complain(not_enough_memory, UNUSABLE_INPUT);
  }
  catch (const std::exception& e)
  {
    std::cerr << "meridian: internal error: " << e.what()
              << "; nothing was written. Please report this with the mesh\n";
    return NOT_VERIFIED;
  }
}

int parse_and_run(int argc, char** argv)
{
  CLI::App app{"Cuts any triangle mesh into a disc along smooth curves, and proves with integers that it did.\n"
               "Meshes are OFF, OBJ, STL, PLY or VTP files, or gzip of these."};
  app.name("meridian");
  app.set_version_flag("--version", "meridian " MERIDIAN_VERSION);
  app.require_subcommand(1);
  app.footer("Exit status: 0 verified, 1 unusable input, 2 computed but not verified, 3 numerical failure, 64 wrong "
             "usage, 74 standard output lost, 130 interrupted.\n"
             "Example: meridian cut elephant.off -o disc.obj --view disc.html");
  std::vector<Command> commands;
  for (const auto add :
       {add_info, add_cut, add_unwrap, add_pack, add_compare, add_generators, add_verify, add_completion})
  {
    commands.push_back(add(app));
  }
  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::ParseError& e)
  {
    const int status = app.exit(e);
    return status == 0 ? 0 : WRONG_USAGE;
  }
  for (const Command& c : commands)
  {
    if (*c.parser) { return run(c); }
  }
  return WRONG_USAGE;
}

} // namespace

int main(int argc, char** argv)
{
  if (openblas_set_num_threads) { openblas_set_num_threads(1); }
  // CHOLMOD asks for four threads, whatever their number is set to
  if (omp_set_max_active_levels) { omp_set_max_active_levels(0); }

  keep_memory();
  listen_to_signals();
  const int status = parse_and_run(argc, argv);
  std::cout.flush();
  const bool is_whole = std::cout.good();
  if (std::fclose(stdout) == 0 && is_whole) { return status; }
  return complain("standard output could not be written", OUTPUT_LOST);
}
