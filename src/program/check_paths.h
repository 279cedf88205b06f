// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CHECK_PATHS_H
#define MERIDIAN_CHECK_PATHS_H

#include <string>
#include <vector>

namespace meridian {
namespace program {

// Throws Usage_error if two of the paths that are written are one file, or one is a file that is read, also by links of
// either kind, and File_error if one cannot be written. Paths that are empty stand for nothing. Every command that
// writes files calls it before it reads any.
void check_paths(const std::vector<std::string>& read, const std::vector<std::string>& written);

// The files that stand for a result: its mesh, and the maps that may be beside it.
std::vector<std::string> files_of_result(const std::string& path);

} // namespace program
} // namespace meridian

#endif // MERIDIAN_CHECK_PATHS_H
