// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FILES_FORMATS_H
#define MERIDIAN_FILES_FORMATS_H

#include "read_mesh.h"

#include <meridian/base/Polygon_soup.h>

#include <cstdint>
#include <string>
#include <vector>

namespace meridian {
namespace files {

struct Mesh_attributes;

// Each reads the bytes of one file; they throw File_error. Those that can hold attributes read them if asked to.
// `size_on_disk`: of the file, which may have been packed; it limits what arrays unpack to.
Polygon_soup read_off(const std::string& bytes);
Polygon_soup read_obj(const std::string& bytes, Mesh_attributes* attributes = nullptr);
Polygon_soup read_stl(const std::string& bytes);
Polygon_soup read_ply(const std::string& bytes, Mesh_attributes* attributes = nullptr);
Polygon_soup read_vtp(const std::string& bytes, std::size_t size_on_disk);

// Adds the triangles of a strip; every other one is turned.
void add_strip(Polygon_soup& soup, std::vector<std::int32_t>::const_iterator first,
               std::vector<std::int32_t>::const_iterator end);

} // namespace files
} // namespace meridian

#endif // MERIDIAN_FILES_FORMATS_H
