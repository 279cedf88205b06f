// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FILES_READ_MESH_H
#define MERIDIAN_FILES_READ_MESH_H

#include <meridian/base/Polygon_soup.h>

#include <cstddef>
#include <limits>
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

// How many bytes a file of so many may unpack to. A mesh shrinks to a tenth or so; what shrinks a hundred times is no
// mesh, and would fill the memory.
constexpr std::size_t most_unpacked(std::size_t size)
{
  constexpr std::size_t ratio = 100, always = 16 << 20;
  return size < (std::numeric_limits<std::size_t>::max() - always) / ratio ? ratio * size + always
                                                                           : std::numeric_limits<std::size_t>::max();
}

// The whole file, unpacked if it is gzip; `size_on_disk`, if given, receives its size before. Throws File_error, also
// where it unpacks to more than `most_unpacked`.
std::string read_bytes(const std::string& path, std::size_t* size_on_disk = nullptr);

// Whether the name ends with ".gz".
bool is_packed(const std::string& path);

} // namespace files
} // namespace meridian

#endif // MERIDIAN_FILES_READ_MESH_H
