// SPDX-License-Identifier: GPL-3.0-or-later
// The formats of mesh files, and what each can hold.
#ifndef MERIDIAN_MESH_FORMAT_H
#define MERIDIAN_MESH_FORMAT_H

#include <meridian/base/names.h>

#include <array>
#include <optional>
#include <string>

namespace meridian {
namespace files {

enum class Mesh_format
{
  OFF,
  OBJ,
  STL,
  PLY,
  VTP
};

} // namespace files

template <> struct Names<files::Mesh_format>
{
  static constexpr std::array<Named_value<files::Mesh_format>, 5> table{{
    {files::Mesh_format::OFF, "off", "Object File Format"},
    {files::Mesh_format::OBJ, "obj", "Wavefront, with texture coordinates and lines"},
    {files::Mesh_format::STL, "stl", "stereolithography, without vertices"},
    {files::Mesh_format::PLY, "ply", "Stanford's, with values of faces"},
    {files::Mesh_format::VTP, "vtp", "VTK's polygons, with values of faces"},
  }};
};

namespace files {

// Whether a format has vertices that stay apart where their points are equal, as both sides of a cut do.
constexpr bool holds_vertices(Mesh_format f) { return f != Mesh_format::STL; }
constexpr bool holds_face_values(Mesh_format f) { return f == Mesh_format::PLY || f == Mesh_format::VTP; }

// The ending of a path in lower case, without ".gz".
std::string ending_of(const std::string& path);

// The format that a path's ending asks for, if it is one.
std::optional<Mesh_format> format_of(const std::string& path);

// The formats that a file may have, for messages: "OFF, OBJ or PLY".
std::string list_formats(bool (*is_meant)(Mesh_format));

} // namespace files
} // namespace meridian

#endif // MERIDIAN_MESH_FORMAT_H
