// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FILES_READ_VALUES_H
#define MERIDIAN_FILES_READ_VALUES_H

#include <string>
#include <vector>

namespace meridian {
namespace files {

// Reads `count` finite numbers from a text file, or gzip of it, with space between them; `#` begins a comment. Throws
// File_error if there are more or fewer.
std::vector<double> read_values(const std::string& path, std::size_t count);

} // namespace files
} // namespace meridian

#endif // MERIDIAN_FILES_READ_VALUES_H
