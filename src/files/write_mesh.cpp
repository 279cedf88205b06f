// SPDX-License-Identifier: GPL-3.0-or-later
#include "write_mesh.h"

#include "Mesh_format.h"

#include "Scanner.h"
#include "Text.h"
#include "read_mesh.h"

#include <meridian/base/Result_mesh.h>
#include <meridian/base/vectors.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstring>
#include <map>

namespace meridian {
namespace files {

namespace {

// Of a text: most numbers have no more digits than this allows for.
std::size_t likely_size(const Result_mesh& m) { return 64 * m.points.size() + 28 * m.faces.size(); }

std::string format_off(const Result_mesh& m, const std::vector<Face_values>&, const Vertex_texture&)
{
  Text out;
  out.reserve(likely_size(m));
  out << "OFF\n" << m.points.size() << ' ' << m.faces.size() << " 0\n";
  for (const auto& p : m.points) { out << p[0] << ' ' << p[1] << ' ' << p[2] << '\n'; }
  for (const auto& f : m.faces) { out << "3 " << f[0] << ' ' << f[1] << ' ' << f[2] << '\n'; }
  return out.take();
}

std::string format_obj(const Result_mesh& m, const std::vector<Face_values>&, const Vertex_texture&)
{
  Text out;
  out.reserve(likely_size(m));
  for (const auto& p : m.points) { out << "v " << p[0] << ' ' << p[1] << ' ' << p[2] << '\n'; }
  for (const auto& f : m.faces) { out << "f " << f[0] + 1 << ' ' << f[1] + 1 << ' ' << f[2] + 1 << '\n'; }
  return out.take();
}

std::string format_ply(const Result_mesh& m, const std::vector<Face_values>& values, const Vertex_texture& texture)
{
  const bool is_textured = !texture.at.empty();
  Text head;
  head << "ply\nformat binary_little_endian 1.0\nelement vertex " << m.points.size()
       << "\nproperty double x\nproperty double y\nproperty double z"
       << (is_textured ? "\nproperty double s\nproperty double t\nproperty int vertex" : "") << "\nelement face "
       << m.faces.size() << "\nproperty list uchar int vertex_indices\n";
  for (const Face_values& v : values) { head << "property double " << v.name << '\n'; }
  head << "end_header\n";
  std::string out = head.take();
  const std::size_t begin = out.size();
  out.resize(begin + m.points.size() * (is_textured ? 44 : 24) + m.faces.size() * (13 + 8 * values.size()));
  char* at = &out[begin];
  for (std::size_t v = 0; v < m.points.size(); ++v)
  {
    std::memcpy(at, m.points[v].data(), 24);
    at += 24;
    if (!is_textured) { continue; }
    std::memcpy(at, texture.at[v].data(), 16);
    std::memcpy(at + 16, &texture.vertex[v], 4);
    at += 20;
  }
  for (std::size_t f = 0; f < m.faces.size(); ++f)
  {
    *at++ = 3;
    std::memcpy(at, m.faces[f].data(), 12);
    at += 12;
    for (const Face_values& v : values)
    {
      std::memcpy(at, &v.values[f], 8);
      at += 8;
    }
  }
  return out;
}

std::string format_vtp(const Result_mesh& m, const std::vector<Face_values>& values, const Vertex_texture& texture)
{
  Text out;
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\" "
         "byte_order=\"LittleEndian\">\n<PolyData>\n<Piece NumberOfPoints=\""
      << m.points.size() << "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\""
      << m.faces.size() << "\">\n<Points>\n<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n";
  for (const auto& p : m.points) { out << p[0] << ' ' << p[1] << ' ' << p[2] << '\n'; }
  out << "</DataArray>\n</Points>\n<Polys>\n<DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">\n";
  for (const auto& f : m.faces) { out << f[0] << ' ' << f[1] << ' ' << f[2] << '\n'; }
  out << "</DataArray>\n<DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">\n";
  for (std::size_t i = 1; i <= m.faces.size(); ++i) { out << 3 * i << '\n'; }
  out << "</DataArray>\n</Polys>\n";
  if (!texture.at.empty())
  {
    out << "<PointData TCoords=\"texture\">\n<DataArray type=\"Float64\" Name=\"texture\" NumberOfComponents=\"2\" "
           "format=\"ascii\">\n";
    for (const auto& p : texture.at) { out << p[0] << ' ' << p[1] << '\n'; }
    out << "</DataArray>\n<DataArray type=\"Int32\" Name=\"vertex\" format=\"ascii\">\n";
    for (std::int32_t v : texture.vertex) { out << v << '\n'; }
    out << "</DataArray>\n</PointData>\n";
  }
  if (!values.empty()) { out << "<CellData>\n"; }
  for (const Face_values& v : values)
  {
    out << "<DataArray type=\"Float64\" Name=\"" << v.name << "\" format=\"ascii\">\n";
    for (double x : v.values) { out << x << '\n'; }
    out << "</DataArray>\n";
  }
  if (!values.empty()) { out << "</CellData>\n"; }
  out << "</Piece>\n</PolyData>\n</VTKFile>\n";
  return out.take();
}

using Formatter = std::string (*)(const Result_mesh&, const std::vector<Face_values>&, const Vertex_texture&);

Formatter formatter(const std::string& path)
{
  const auto format = format_of(path);
  if (!format)
  {
    throw File_error(path + ": unknown format '" + ending_of(path) + "'; use " + list_formats(holds_vertices)
                     + ", or gzip of these");
  }
  switch (*format)
  {
  case Mesh_format::OFF: return format_off;
  case Mesh_format::OBJ: return format_obj;
  case Mesh_format::PLY: return format_ply;
  case Mesh_format::VTP: return format_vtp;
  case Mesh_format::STL: break;
  }
  throw File_error(path
                   + ": STL cannot hold a cut, because it stores no vertices and its readers weld equal points; use "
                   + list_formats(holds_vertices));
}

} // namespace

void check_writable_format(const std::string& path) { formatter(path); }

std::string format_mesh(const std::string& path, const Result_mesh& mesh, const std::vector<Face_values>& values,
                        const Vertex_texture& texture)
{
  return formatter(path)(mesh, values, texture);
}

std::string format_curves(const std::vector<Point>& points, const std::vector<Result_curve>& curves)
{
  Text out;
  std::map<std::int32_t, std::size_t> place;
  for (const Result_curve& c : curves)
    for (std::int32_t v : c.points)
      if (place.try_emplace(v, place.size() + 1).second)
      {
        out << "v " << points[v][0] << ' ' << points[v][1] << ' ' << points[v][2] << '\n';
      }
  for (const Result_curve& c : curves)
  {
    out << "g " << c.name << "\nl";
    for (std::int32_t v : c.points) { out << ' ' << place.at(v); }
    out << '\n';
  }
  return out.take();
}

std::string format_mesh_with_curves(const Result_mesh& mesh, const std::vector<Result_curve>& curves)
{
  Text out;
  out << format_obj(mesh, {}, {});
  for (const Result_curve& c : curves)
  {
    out << "g " << c.name << "\nl";
    for (std::int32_t v : c.points) { out << ' ' << v + 1; }
    out << '\n';
  }
  return out.take();
}

std::vector<Result_curve> read_curves(const std::string& path)
{
  if (format_of(path) != Mesh_format::OBJ) { throw File_error(path + ": curves are line elements of OBJ files"); }
  const std::string bytes = read_bytes(path);
  Scanner in(bytes, path.c_str(), '#');
  std::vector<Result_curve> curves;
  std::string group;
  std::size_t points = 0;
  while (!in.at_end())
  {
    const std::string_view key = in.word();
    if (key == "v") { ++points; }
    if (key == "g" || key == "o") { group = in.word_on_line(); }
    if (key == "l")
    {
      curves.push_back({group, {}, {}});
      for (std::string_view word = in.word_on_line(); !word.empty(); word = in.word_on_line())
      {
        const auto i = in.parse<std::int64_t>(word.substr(0, word.find('/')), "a vertex of a line");
        const std::int64_t place = place_of(i, points);
        const bool is_point = place >= 0 && place < static_cast<std::int64_t>(points);
        curves.back().points.push_back(is_point ? static_cast<std::int32_t>(place) : -1);
      }
    }
    if (!in.at_line_end()) { in.skip_line(); }
  }
  return curves;
}

} // namespace files
} // namespace meridian
