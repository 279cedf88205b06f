// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FILES_READ_RESULT_H
#define MERIDIAN_FILES_READ_RESULT_H

#include "map_file.h"

#include <meridian/base/Result_mesh.h>
#include <meridian/base/vectors.h>

namespace meridian {
namespace files {

// A result as it stands in its files.
struct Result_files
{
  Result_kind kind = Result_kind::CUT;
  Result_mesh mesh;
  std::vector<Result_curve> curves;    // of generators, with their fields
  std::vector<Plane_point> texture;    // of an unwrapping, one a vertex of `mesh`
  std::vector<std::int32_t> vertex_of; // the vertex of the file that each texture coordinate belongs to
  std::int32_t vertices = 0;           // how many the file has
};

// Reads a result and its map. Throws File_error.
Result_files read_result(const std::string& path);

} // namespace files
} // namespace meridian

#endif // MERIDIAN_FILES_READ_RESULT_H
