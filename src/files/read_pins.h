// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FILES_READ_PINS_H
#define MERIDIAN_FILES_READ_PINS_H

#include "read_mesh.h"

#include <meridian/base/vectors.h>

#include <cstddef>
#include <string>
#include <vector>

namespace meridian {
namespace files {

// A vertex, and where a texture shall have it.
struct Pin
{
  Index vertex;
  Plane_point at;
};

// Reads a text file with a pin on each line: a vertex, counted from 0, and two coordinates from 0 to 1. Empty lines,
// and what follows a `#`, are skipped. Throws File_error, also for a vertex that is not one of so many or comes twice.
std::vector<Pin> read_pins(const std::string& path, std::size_t vertices);

} // namespace files
} // namespace meridian

#endif // MERIDIAN_FILES_READ_PINS_H
