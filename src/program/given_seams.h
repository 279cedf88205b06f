// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_GIVEN_SEAMS_H
#define MERIDIAN_GIVEN_SEAMS_H

#include "field_arguments.h"

#include <meridian/base/vectors.h>
#include <meridian/cut/Cut.h>
#include <meridian/unwrap/Unwrapping.h>

#include <string>
#include <vector>

namespace meridian {
namespace program {

// The seams that `--seams` and `--chart-per` give: halfedges of each component. Throws Usage_error or File_error if the
// mesh has not what they ask for.
std::vector<std::vector<Index>> find_given_seams(const Unwrap_arguments& arguments, const Loaded_mesh& loaded);

inline bool has_given_seams(const Unwrap_arguments& a) { return !a.seams.empty() || a.chart_per; }

// What seams were given, and what completed them, in a line. `cuts` are in the order of the components.
std::string describe_completion(const std::vector<Unwrap_options>& options, const std::vector<Cut>& cuts);

// Whether a word is what `--seams` takes, a path apart: `uv`, or `sharp:` and an angle in degrees.
bool is_kind_of_seam(const std::string& word);

} // namespace program
} // namespace meridian

#endif // MERIDIAN_GIVEN_SEAMS_H
