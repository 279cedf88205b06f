// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FILES_READ_PATHS_H
#define MERIDIAN_FILES_READ_PATHS_H

#include "read_mesh.h"

#include <meridian/base/vectors.h>

#include <string>
#include <vector>

namespace meridian {
namespace files {

// Reads a text file with a path on each line: vertices, counted from 0, two or more. Empty lines, and what follows a
// `#`, are skipped. Throws File_error, also for a vertex that is not one of so many.
std::vector<std::vector<Index>> read_paths(const std::string& path, std::size_t vertices);

} // namespace files
} // namespace meridian

#endif // MERIDIAN_FILES_READ_PATHS_H
