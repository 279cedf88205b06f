// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FILES_WRITE_MESH_H
#define MERIDIAN_FILES_WRITE_MESH_H

#include <meridian/base/Result_mesh.h>
#include <meridian/base/vectors.h>

#include <string>
#include <vector>

namespace meridian {
namespace files {

// Throws File_error if a mesh cannot be written in the format that the path asks for.
void check_writable_format(const std::string& path);

// A number for each face of a mesh.
struct Face_values
{
  std::string name;
  std::vector<double> values;
};

// Texture coordinates of each vertex of a mesh, and the number that it has where vertices are not doubled.
struct Vertex_texture
{
  std::vector<Plane_point> at;
  std::vector<std::int32_t> vertex;
};

// The bytes of a mesh file in the format of `path`: OFF, OBJ, PLY (binary) or VTP. Text has the shortest digits that
// read back to the same number. Values and texture coordinates are for PLY and VTP.
std::string format_mesh(const std::string& path, const Result_mesh& mesh, const std::vector<Face_values>& values = {},
                        const Vertex_texture& texture = {});

// The points of curves and one line element a curve, as OBJ.
std::string format_curves(const std::vector<Point>& points, const std::vector<Result_curve>& curves);

// A mesh with curves on it, as OBJ: a group and a line element each.
std::string format_mesh_with_curves(const Result_mesh& mesh, const std::vector<Result_curve>& curves);

// The line elements of an OBJ file, named by their groups. Throws File_error.
std::vector<Result_curve> read_curves(const std::string& path);

} // namespace files
} // namespace meridian

#endif // MERIDIAN_FILES_WRITE_MESH_H
