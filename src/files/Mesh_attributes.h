// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FILES_MESH_ATTRIBUTES_H
#define MERIDIAN_FILES_MESH_ATTRIBUTES_H

#include <meridian/base/Polygon_soup.h>
#include <meridian/base/names.h>
#include <meridian/base/vectors.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace meridian {
namespace files {

// What names parts of a mesh.
enum class Part_kind
{
  OBJECT,
  GROUP,
  MATERIAL,
  SMOOTHING
};

} // namespace files

// The words of OBJ files for them.
template <> struct Names<files::Part_kind>
{
  static constexpr std::array<Named_value<files::Part_kind>, 4> table{{
    {files::Part_kind::OBJECT, "o", "object"},
    {files::Part_kind::GROUP, "g", "group"},
    {files::Part_kind::MATERIAL, "usemtl", "material"},
    {files::Part_kind::SMOOTHING, "s", "smoothing group"},
  }};
};

namespace files {

// The names of the parts of one kind, each once, and the part of each polygon: -1 before any was named.
struct Named_parts
{
  std::vector<std::string> names;
  std::vector<std::int32_t> of;
};

// What a mesh file holds beside points and polygons. What it has not is empty; a corner that has none has -1.
struct Mesh_attributes
{
  std::vector<Plane_point> texture;     // coordinates,
  std::vector<std::int32_t> texture_of; // and which of them each corner has, as `Polygon_soup` counts corners
  std::vector<Point> normals;           // and the same of normals
  std::vector<std::int32_t> normal_of;
  std::vector<Point> colours;         // of each point: red, green and blue, from 0 to 1
  std::vector<std::string> libraries; // of materials
  std::array<Named_parts, number_of<Part_kind>> parts;

  const Named_parts& of(Part_kind kind) const { return parts[static_cast<std::size_t>(kind)]; }
};

// What a corner of a polygon has, by its point: one of `of`, which are `texture_of` or `normal_of`; -1 if it has none.
inline std::int32_t find_at_corner(const Polygon_soup& soup, const std::vector<std::int32_t>& of, std::int32_t polygon,
                                   std::int32_t point)
{
  for (std::size_t k = soup.begin[polygon]; k < soup.begin[polygon + 1]; ++k)
  {
    if (soup.corners[k] == point) { return of[k]; }
  }
  return -1;
}

// What a kind of parts is, in words.
inline const char* meaning_of(Part_kind kind)
{
  return Names<Part_kind>::table[static_cast<std::size_t>(kind)].meaning;
}

} // namespace files
} // namespace meridian

#endif // MERIDIAN_FILES_MESH_ATTRIBUTES_H
