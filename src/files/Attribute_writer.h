// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FILES_ATTRIBUTE_WRITER_H
#define MERIDIAN_FILES_ATTRIBUTE_WRITER_H

#include "Mesh_attributes.h"
#include "Text.h"

#include <meridian/base/Polygon_soup.h>
#include <meridian/base/Result_mesh.h>
#include <meridian/base/vectors.h>

#include <array>
#include <cstdint>
#include <map>
#include <vector>

namespace meridian {
namespace files {

// Writes the attributes of an input file into the OBJ file of a result made from it. At a new vertex they are what they
// are there on the input: linear along edges and in triangles.
class Attribute_writer
{
public:
  Attribute_writer(const Polygon_soup& input, const Mesh_attributes& attributes, const Result_mesh& mesh);

  // The colour of a vertex, behind its coordinates.
  void write_colour(Text& out, std::size_t vertex) const;
  // All `vn`, before the first face.
  void write_normals(Text& out) const;
  // The lines that name the parts that a polygon of the input is in, where they are others than those of the last. Its
  // material is left out if it shall have another.
  void write_parts(Text& out, std::int32_t polygon, bool with_material);
  // The numbers, from 1 on, of the normals of corners of a face; empty if one of them has none. `vertices` are vertices
  // of the result in a polygon of the input.
  template <class Vertices> std::vector<std::size_t> normals(std::int32_t polygon, const Vertices& vertices) const
  {
    std::vector<std::size_t> numbers;
    for (std::int32_t v : vertices)
    {
      const std::int64_t number = normal(polygon, v);
      if (number < 0) { return {}; }
      numbers.push_back(static_cast<std::size_t>(number));
    }
    return numbers;
  }

private:
  // The normals of the input that one of a vertex lies between, and the vertex if it is not the first alone.
  using Between = std::array<std::int32_t, 4>;

  Between between(std::int32_t polygon, std::int32_t vertex) const;
  std::int32_t normal_at(std::int32_t polygon, std::int32_t point) const; // of the input, or -1
  std::int64_t normal(std::int32_t polygon, std::int32_t vertex) const;   // its number, from 1 on, or -1
  Point interpolate(const Between& b) const;

  const Polygon_soup& m_input;
  const Mesh_attributes& m_attributes;
  const Result_mesh& m_mesh;
  std::vector<std::array<std::int32_t, 3>> m_triangles; // of the input
  std::map<Between, std::size_t> m_new;                 // their places among those that are added
  std::vector<Between> m_added;
  std::array<std::int32_t, number_of<Part_kind>> m_current; // part of each kind
};

} // namespace files
} // namespace meridian

#endif // MERIDIAN_FILES_ATTRIBUTE_WRITER_H
