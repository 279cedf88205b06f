// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FILES_READ_MESH_H
#define MERIDIAN_FILES_READ_MESH_H

#include <meridian/base/Polygon_soup.h>

#include <stdexcept>
#include <string>

namespace meridian {
namespace files {

struct Mesh_attributes;

// A file that cannot be read as a mesh. The message names the file and the place.
struct File_error : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

// Reads OFF, OBJ, STL, PLY or VTP, or gzip of these, told apart by the name's ending.
//
// Points of STL files are welded: the vertices are the distinct coordinates in order of first appearance, with -0 = 0.
// No other format is ever welded. `attributes`, if given, receives what else an OBJ or PLY file holds.
Polygon_soup read_mesh(const std::string& path, Mesh_attributes* attributes = nullptr);

// The whole file, unpacked if it is gzip.
std::string read_bytes(const std::string& path);

// Whether the name ends with ".gz".
bool is_packed(const std::string& path);

} // namespace files
} // namespace meridian

#endif // MERIDIAN_FILES_READ_MESH_H
