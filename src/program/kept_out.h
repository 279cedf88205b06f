// SPDX-License-Identifier: GPL-3.0-or-later
// Faces that no seam shall go over.
#ifndef MERIDIAN_PROGRAM_KEPT_OUT_H
#define MERIDIAN_PROGRAM_KEPT_OUT_H

#include "arguments.h"
#include "cut.h"

#include <meridian/base/vectors.h>
#include <meridian/cut/Cut.h>
#include <meridian/surface/examine_surface.h>
#include <meridian/unwrap/Unwrapping.h>

#include <string>
#include <vector>

namespace meridian {
namespace program {

// Whether `--keep-out` names a file, not the colours of the mesh.
inline bool names_file_of_kept_out(const Unwrap_arguments& a) { return !a.keep_out.empty() && a.keep_out != "red"; }

// For each component, its faces all of whose corners are marked. Throws files::File_error if the file does not have
// what is asked for.
std::vector<std::vector<Index>> find_kept_out(const Unwrap_arguments& arguments, const Loaded_mesh& loaded);

// Where seams go over such faces nevertheless, a line for each component.
std::vector<std::string> missed_kept_out(const std::vector<Unwrap_options>& options, const std::vector<Cut>& cuts,
                                         const std::vector<Surface_component>& components);

} // namespace program
} // namespace meridian

#endif // MERIDIAN_PROGRAM_KEPT_OUT_H
