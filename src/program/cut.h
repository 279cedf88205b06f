// SPDX-License-Identifier: GPL-3.0-or-later
// What `cut` and `cut --family` share.
#ifndef MERIDIAN_CUT_H
#define MERIDIAN_CUT_H

#include "Terminal.h"
#include "field_arguments.h"
#include "files/Output_files.h"
#include "report.h"

#include <meridian/base/Result_mesh.h>
#include <meridian/base/Verification.h>
#include <meridian/cut/Cut.h>
#include <meridian/cut/Cut_options.h>
#include <meridian/result/Assembled_result.h>
#include <meridian/result/name_curves.h>

#include <functional>

namespace meridian {
namespace program {

// Throws Usage_error if options do not go together.
void check_cut_arguments(const Cut_arguments& arguments);

// The options for each component.
std::vector<Cut_options> cut_options(const Cut_arguments& arguments, const Loaded_mesh& loaded, Terminal& terminal);

// A cut of all components: put together, recounted and reported.
struct Cut_result
{
  std::vector<Cut> cuts;
  Assembled_result assembled;
  Verification verification;
  Json components = Json::array();
  double length = 0; // in the unit of the file
  int genus = 0, loops = 0;
  double seconds_assembling = 0, seconds_verifying = 0;
};
// `recount` verifies what was put together. With `conclude_cut()` both steps are one.
using Recount = std::function<Verification(const Assembled_result&)>;
Cut_result assemble_cut(const Loaded_mesh& loaded, std::vector<Cut> cuts, const std::vector<Cut_options>& options);
void verify(Cut_result& result, Terminal& terminal, const Recount& recount);
Cut_result conclude_cut(const Loaded_mesh& loaded, std::vector<Cut> cuts, const std::vector<Cut_options>& options,
                        Terminal& terminal, const Recount& recount);
Cut_result conclude_cut(const Loaded_mesh& loaded, std::vector<Cut> cuts, const std::vector<Cut_options>& options,
                        Terminal& terminal);

// How long reading, examining, putting together and recounting took.
Json report_seconds(const Loaded_mesh& loaded, const Cut_result& result);

// The curves of all components as they are written.
std::vector<Result_curve> name_curves(const std::vector<Cut>& cuts, const Assembled_result& assembled);

// The mesh, its map, the curves and the page, at the paths of the arguments.
void add_cut(files::Output_files& out, const Cut_arguments& arguments, const Loaded_mesh& loaded,
             const Cut_result& result);

} // namespace program
} // namespace meridian

#endif // MERIDIAN_CUT_H
