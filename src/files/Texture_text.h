// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FILES_TEXTURE_TEXT_H
#define MERIDIAN_FILES_TEXTURE_TEXT_H

#include <meridian/base/vectors.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace meridian {
namespace files {

class Scanner;

// The text of an OBJ file whose texture coordinates can be changed. All else stays as it is, byte for byte.
class Texture_text
{
public:
  // Of an OBJ file, by its name in messages and its bytes. Throws File_error, also if no face has texture coordinates.
  Texture_text(const std::string& name, std::string bytes);

  const std::vector<Point>& points() const { return m_points; }
  const std::vector<Plane_point>& texture() const { return m_texture; }
  // The triangles of faces that have texture coordinates at all corners, cut by a fan from the first: places in
  // `points()`, and in `texture()`.
  const std::vector<std::array<std::int32_t, 3>>& triangles() const { return m_triangles; }
  const std::vector<std::array<std::int32_t, 3>>& texture_triangles() const { return m_texture_triangles; }
  // How many faces have none.
  std::size_t faces_without() const { return m_faces_without; }

  // The text with other coordinates for those that faces use; the others stay as they are.
  std::string format(const std::vector<Plane_point>& texture) const;

private:
  void read_face(Scanner& in);

  std::string m_bytes;
  std::vector<std::array<std::size_t, 2>>
    m_places; // of the two numbers of each `vt`, from the first to behind the second
  std::vector<Point> m_points;
  std::vector<Plane_point> m_texture;
  std::vector<std::array<std::int32_t, 3>> m_triangles, m_texture_triangles;
  std::size_t m_faces_without = 0;
};

} // namespace files
} // namespace meridian

#endif // MERIDIAN_FILES_TEXTURE_TEXT_H
