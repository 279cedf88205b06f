// SPDX-License-Identifier: GPL-3.0-or-later
// The map of a result, which leads each vertex and face back to the input.
#ifndef MERIDIAN_MAP_FILE_H
#define MERIDIAN_MAP_FILE_H

#include <meridian/base/Result_mesh.h>
#include <meridian/base/names.h>

#include <array>
#include <string>
#include <vector>

namespace meridian {
namespace files {

enum class Result_kind
{
  CUT,
  GENERATORS,
  UNWRAPPING
};

enum class Map_format
{
  JSON,
  CBOR
};

} // namespace files

template <> struct Names<files::Map_format>
{
  static constexpr std::array<Named_value<files::Map_format>, 2> table{{
    {files::Map_format::JSON, "json", "text, OUT.map.json"},
    {files::Map_format::CBOR, "cbor", "the same in binary (RFC 8949), OUT.map.cbor"},
  }};
};

namespace files {

// The bytes of a map, with the fields that curves name; only generators have some.
std::string format_map(const Result_mesh& mesh, Result_kind kind, Map_format format = Map_format::JSON,
                       const std::vector<Result_curve>& curves = {});

// Reads the map at `path`, of either format. `fields` receives those of curves, by name. Throws File_error.
Result_kind read_map(const std::string& path, Result_mesh& mesh, std::vector<Result_curve>& fields);

// A path without its ending, and that of a packed file.
std::string stem_of(const std::string& path);

// Where the map of a result is written.
std::string map_path(const std::string& path, Map_format format = Map_format::JSON);

// Where the map of a result stands. Throws File_error if there are two, since one of them is of another result.
std::string find_map(const std::string& path);

} // namespace files
} // namespace meridian

#endif // MERIDIAN_MAP_FILE_H
