// SPDX-License-Identifier: GPL-3.0-or-later
#include "write_texture.h"

#include "Attribute_writer.h"
#include "Mesh_attributes.h"
#include "Mesh_format.h"
#include "Scanner.h"
#include "Text.h"
#include "read_mesh.h"

#include <meridian/base/Polygon_soup.h>
#include <meridian/base/Result_mesh.h>
#include <meridian/base/vectors.h>

#include <cmath>

namespace meridian {
namespace files {

namespace {

// Whether the faces [first, last) of a result are the fan of polygon `p` of the input, each corner with one vertex of
// the opened mesh in all of them. If so, `corners` receives these, in the order of the file.
bool is_whole(const Polygon_soup& input, std::size_t p, const Result_mesh& mesh,
              const std::vector<Plane_point>& texture, std::size_t first, std::size_t last,
              std::vector<std::int32_t>& corners)
{
  const std::size_t n = input.size(p);
  if (n <= 3 || last - first != n - 2) { return false; }
  std::size_t lowest = 0;
  for (std::size_t k = 1; k < n; ++k)
  {
    if (input.corner(p, k) < input.corner(p, lowest)) { lowest = k; }
  }
  corners.resize(n);
  for (std::size_t k = 0; k < n; ++k)
  {
    corners[(lowest + k) % n] = k < 2 ? mesh.faces[first][k] : mesh.faces[first + k - 2][2];
  }
  for (std::size_t k = 0; k < n; ++k)
  {
    const std::int32_t v = corners[k], of = mesh.copy_of[v];
    if ((of < 0 ? v : of) != input.corner(p, k)) { return false; }
  }
  for (std::size_t k = 1; k + 1 < n; ++k)
    if (mesh.faces[first + k - 1]
        != std::array<std::int32_t, 3>{corners[lowest], corners[(lowest + k) % n], corners[(lowest + k + 1) % n]})
    {
      return false;
    }
  // convex beyond rounding: whatever fan a reader cuts it by, no triangle is turned over
  for (std::size_t k = 0; k < n; ++k)
  {
    const auto &a = texture[corners[k]], &b = texture[corners[(k + 1) % n]], &c = texture[corners[(k + 2) % n]];
    const double left = (b[0] - a[0]) * (c[1] - a[1]), right = (b[1] - a[1]) * (c[0] - a[0]);
    if (!(left - right > 1e-15 * (std::abs(left) + std::abs(right)))) { return false; }
  }
  return true;
}

// The vertex and the texture vertex of a corner of a face: indices into what stands above it.
std::array<std::int32_t, 2> read_corner(const Scanner& in, std::string_view word, std::size_t vertices,
                                        std::size_t textures)
{
  const std::size_t slash = word.find('/');
  const std::string_view rest = slash == std::string_view::npos ? std::string_view() : word.substr(slash + 1);
  const std::string_view texture = rest.substr(0, rest.find('/'));
  if (texture.empty()) { in.fail("the corner '" + std::string(word.substr(0, 40)) + "' has no texture vertex"); }
  return {place_in(in, word.substr(0, slash), vertices, "vertex"), place_in(in, texture, textures, "texture vertex")};
}

bool is_finite(const Point& p) { return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]); }

template <std::size_t N> std::array<double, N> read_coordinates(Scanner& in, const char* what, bool are_finite)
{
  std::array<double, N> p;
  for (double& x : p)
  {
    if (in.at_line_end()) { in.fail(std::string(what) + " has fewer than " + std::to_string(N) + " coordinates"); }
    x = in.real("a coordinate");
    if (are_finite && !std::isfinite(x))
    {
      in.fail(std::string(what) + " has a coordinate that is not a finite number");
    }
  }
  return p;
}

} // namespace

std::string format_unwrapped(const Polygon_soup& input, const Result_mesh& mesh,
                             const std::vector<Plane_point>& texture, const Mesh_attributes& attributes,
                             const std::string& material_library)
{
  Text out;
  Attribute_writer more(input, attributes, mesh);
  if (!material_library.empty()) { out << "mtllib " << material_library << '\n'; }
  else
  {
    for (const std::string& library : attributes.libraries) { out << "mtllib " << library << '\n'; }
  }
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
  {
    const auto& p = mesh.points[v];
    if (mesh.copy_of[v] >= 0) { continue; }
    out << "v " << p[0] << ' ' << p[1] << ' ' << p[2];
    more.write_colour(out, v);
    out << '\n';
  }
  for (const auto& t : texture) { out << "vt " << t[0] << ' ' << t[1] << '\n'; }
  more.write_normals(out);
  if (!material_library.empty()) { out << "usemtl checkerboard\n"; }
  const auto write_face = [&](std::int32_t polygon, const auto& corners) {
    const std::vector<std::size_t> normals = more.normals(polygon, corners);
    auto normal = normals.begin();
    out << 'f';
    for (std::int32_t v : corners)
    {
      out << ' ' << (mesh.copy_of[v] < 0 ? v : mesh.copy_of[v]) + 1 << '/' << v + 1;
      if (normal != normals.end()) { out << '/' << *normal++; }
    }
    out << '\n';
  };
  std::vector<std::int32_t> corners;
  for (std::size_t first = 0, last = 0; first < mesh.faces.size(); first = last)
  {
    const std::int32_t polygon = mesh.face_of[first];
    while (last < mesh.faces.size() && mesh.face_of[last] == polygon) { ++last; }
    more.write_parts(out, polygon, material_library.empty());
    if (is_whole(input, static_cast<std::size_t>(polygon), mesh, texture, first, last, corners))
    {
      write_face(polygon, corners);
    }
    else
    {
      for (std::size_t f = first; f < last; ++f) { write_face(polygon, mesh.faces[f]); }
    }
  }
  return out.take();
}

void read_unwrapped(const std::string& path, Result_mesh& mesh, std::vector<Plane_point>& texture,
                    std::vector<std::int32_t>& vertex_of, std::int32_t& vertices)
{
  if (format_of(path) != Mesh_format::OBJ)
  {
    throw File_error(path + ": meshes with texture coordinates are OBJ files");
  }
  const std::string bytes = read_bytes(path);
  Scanner in(bytes, path.c_str(), '#');
  std::vector<Point> points;
  std::vector<std::array<std::int32_t, 2>> corners;
  mesh.faces.clear();
  texture.clear();
  vertex_of.clear();
  while (!in.at_end())
  {
    const std::string_view key = in.word();
    if (key == "v") { points.push_back({read_coordinates<3>(in, "a vertex", false)}); } // it may be of no face
    else if (key == "vt")
    {
      texture.push_back({read_coordinates<2>(in, "a texture vertex", true)});
      vertex_of.push_back(-1);
    }
    else if (key == "f")
    {
      corners.clear();
      for (std::string_view word = in.word_on_line(); !word.empty(); word = in.word_on_line())
      {
        const auto [v, t] = corners.emplace_back(read_corner(in, word, points.size(), texture.size()));
        if (!is_finite(points[v])) { in.fail("a corner names a vertex with a coordinate that is not a finite number"); }
        if (vertex_of[t] >= 0 && vertex_of[t] != v)
          in.fail("texture vertex " + std::to_string(t + 1) + " is used with vertex " + std::to_string(vertex_of[t] + 1)
                  + " and with vertex " + std::to_string(v + 1));
        vertex_of[t] = v;
      }
      const std::size_t n = corners.size();
      if (n < 3) { in.fail("a face has " + std::to_string(n) + " corners"); }
      std::size_t lowest = 0;
      for (std::size_t k = 1; k < n && n > 3; ++k)
      {
        if (corners[k][0] < corners[lowest][0]) { lowest = k; }
      }
      for (std::size_t k = 1; k + 1 < n; ++k)
      {
        mesh.faces.push_back({corners[lowest][1], corners[(lowest + k) % n][1], corners[(lowest + k + 1) % n][1]});
      }
    }
    if (!in.at_line_end()) { in.skip_line(); }
  }
  if (mesh.faces.empty()) { throw File_error(path + ": the file has no faces"); }
  vertices = static_cast<std::int32_t>(points.size());
  mesh.points.clear();
  for (std::size_t t = 0; t < texture.size(); ++t)
  {
    if (vertex_of[t] < 0 && t >= points.size())
      throw File_error(path + ": no corner names texture vertex " + std::to_string(t + 1)
                       + ", and there is no vertex of that number");
    if (vertex_of[t] < 0) { vertex_of[t] = static_cast<std::int32_t>(t); }
    mesh.points.push_back(points[vertex_of[t]]);
  }
}

std::string format_material(const std::string& texture_image)
{
  return "newmtl checkerboard\nKd 1 1 1\nmap_Kd " + texture_image + "\n";
}

} // namespace files
} // namespace meridian
