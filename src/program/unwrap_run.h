// SPDX-License-Identifier: GPL-3.0-or-later
// A run of `unwrap`: what its parts share.
#ifndef MERIDIAN_UNWRAP_RUN_H
#define MERIDIAN_UNWRAP_RUN_H

#include "arguments.h"
#include "cut.h"
#include "end_run.h"
#include "field_arguments.h"
#include "files/Output_files.h"
#include "files/read_pins.h"
#include "report.h"

#include <meridian/base/vectors.h>
#include <meridian/unwrap/Unwrapping.h>

#include <string>
#include <vector>

namespace meridian {
namespace program {

// A mesh on its way, with the arguments that are its own.
struct Unwrap_run
{
  Unwrap_arguments arguments;
  Loaded_mesh loaded;
  std::vector<Unwrap_options> options; // of each component
  std::vector<Unwrapping> unwrapped;
  Cut_result result;
  std::vector<Plane_point> texture;
  std::vector<files::Pin> pins; // of the file
  std::vector<std::string> warnings, missed;
  Json report;
};

// Says what was found: fills `report`, `warnings` and `missed` of a run that was recounted.
void report_run(Unwrap_run& run);

// What is said of a run in words.
Last_words words_of(const Unwrap_run& run);

// What was unwrapped, in one line.
std::string caption_of(const Unwrap_run& run);

// Names material libraries from where the result is, which may be another folder than that of the mesh.
void move_libraries(const Unwrap_arguments& arguments, std::vector<std::string>& libraries);

// The paths that are written for a mesh, the report apart.
std::vector<std::string> written_for(const Unwrap_arguments& arguments);

// The files of a verified run, the report apart; of a geometry image the report is completed.
void add_files(files::Output_files& out, Unwrap_run& run);

} // namespace program
} // namespace meridian

#endif // MERIDIAN_UNWRAP_RUN_H
