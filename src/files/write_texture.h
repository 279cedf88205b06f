// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FILES_WRITE_TEXTURE_H
#define MERIDIAN_FILES_WRITE_TEXTURE_H

#include <meridian/base/Polygon_soup.h>
#include <meridian/base/Result_mesh.h>
#include <meridian/base/vectors.h>

#include <array>
#include <string>
#include <vector>

namespace meridian {
namespace files {

struct Mesh_attributes;

// A mesh with texture coordinates, as OBJ: a `v` for each vertex that is no copy, a `vt` for each vertex of the opened
// mesh, and faces that name both. A polygon of the input stands as it stood there, if its parts are the triangles of
// its fan, no seam runs through it and its image is convex; otherwise its triangles do. Attributes of the input, its
// texture coordinates apart, are kept. With a name of a material library, faces have the material of
// `format_material()` instead of their own.
//
// `mesh` is an opened mesh whose copies follow the other vertices; `texture` has one entry a vertex.
std::string format_unwrapped(const Polygon_soup& input, const Result_mesh& mesh,
                             const std::vector<Plane_point>& texture, const Mesh_attributes& attributes,
                             const std::string& material_library);

// The other way. `mesh` receives the points and faces of the opened mesh, one vertex for each `vt`, polygons cut by a
// fan from their corner whose `v` is lowest; nothing else of it is touched. `vertex_of` receives the `v` of each `vt`,
// `vertices` how many there are. A `vt` that no corner names belongs to the `v` of the same number. Throws File_error.
void read_unwrapped(const std::string& path, Result_mesh& mesh, std::vector<Plane_point>& texture,
                    std::vector<std::int32_t>& vertex_of, std::int32_t& vertices);

// A material library for OBJ, with the one material `checkerboard`: an image, unshaded.
std::string format_material(const std::string& texture_image);

} // namespace files
} // namespace meridian

#endif // MERIDIAN_FILES_WRITE_TEXTURE_H
