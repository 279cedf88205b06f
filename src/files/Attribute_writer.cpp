// SPDX-License-Identifier: GPL-3.0-or-later
#include "Attribute_writer.h"

#include <algorithm>

namespace meridian {
namespace files {

Attribute_writer::Attribute_writer(const Polygon_soup& input, const Mesh_attributes& attributes,
                                   const Result_mesh& mesh)
  : m_input(input), m_attributes(attributes), m_mesh(mesh)
{
  m_current.fill(-1);
  if (attributes.colours.empty() && attributes.normals.empty()) { return; }
  for_each_triangle(input, [&](std::int32_t, std::int32_t, std::int32_t a, std::int32_t b, std::int32_t c) {
    m_triangles.push_back({a, b, c});
  });
  if (attributes.normals.empty()) { return; }
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    for (std::int32_t v : mesh.faces[f])
    {
      const Between b = between(mesh.face_of[f], v);
      if (b[0] < 0 || b[3] < 0) { continue; }
      if (m_new.emplace(b, m_added.size()).second) { m_added.push_back(b); }
    }
}

void Attribute_writer::write_colour(Text& out, std::size_t v) const
{
  if (m_attributes.colours.empty()) { return; }
  const Point c = position_of(
    m_mesh.origin[v], m_attributes.colours, [&](std::int32_t t) -> const auto& { return m_triangles[t]; });
  out << ' ' << c[0] << ' ' << c[1] << ' ' << c[2];
}

void Attribute_writer::write_normals(Text& out) const
{
  const auto write = [&](const Point& n) { out << "vn " << n[0] << ' ' << n[1] << ' ' << n[2] << '\n'; };
  for (const Point& n : m_attributes.normals) { write(n); }
  for (const Between& b : m_added) { write(interpolate(b)); }
}

void Attribute_writer::write_parts(Text& out, std::int32_t polygon, bool with_material)
{
  for (const Part_kind kind : all<Part_kind>())
  {
    const Named_parts& parts = m_attributes.of(kind);
    if (parts.of.empty() || (kind == Part_kind::MATERIAL && !with_material)) { continue; }
    std::int32_t& current = m_current[static_cast<std::size_t>(kind)];
    const std::int32_t part = parts.of[polygon];
    if (part == current) { continue; }
    // a file cannot take a name back
    out << name_of(kind) << ' '
        << (part >= 0                      ? parts.names[part]
            : kind == Part_kind::SMOOTHING ? "off"
                                           : "default")
        << '\n';
    current = part;
  }
}

std::int32_t Attribute_writer::normal_at(std::int32_t polygon, std::int32_t point) const
{
  return find_at_corner(m_input, m_attributes.normal_of, polygon, point);
}

Attribute_writer::Between Attribute_writer::between(std::int32_t polygon, std::int32_t v) const
{
  const Result_origin& o = m_mesh.origin[v];
  if (o.kind == Result_origin::VERTEX) { return {normal_at(polygon, o.index[0]), -1, -1, -1}; }
  const std::int32_t base = m_mesh.copy_of[v] < 0 ? v : m_mesh.copy_of[v];
  Between b{-1, -1, -1, base};
  if (o.kind == Result_origin::EDGE)
  {
    for (int i = 0; i < 2; ++i) { b[i] = normal_at(polygon, o.index[i]); }
    if (b[1] < 0) { b[0] = -1; }
    return b;
  }
  for (int i = 0; i < 3; ++i) { b[i] = normal_at(polygon, m_triangles[o.index[0]][i]); }
  if (b[1] < 0 || b[2] < 0) { b[0] = -1; }
  return b;
}

std::int64_t Attribute_writer::normal(std::int32_t polygon, std::int32_t v) const
{
  if (m_attributes.normals.empty()) { return -1; }
  const Between b = between(polygon, v);
  if (b[0] < 0) { return -1; }
  return 1 + (b[3] < 0 ? b[0] : static_cast<std::int64_t>(m_attributes.normals.size() + m_new.at(b)));
}

Point Attribute_writer::interpolate(const Between& b) const
{
  const Result_origin& o = m_mesh.origin[b[3]];
  const auto& normals = m_attributes.normals;
  const Point n = o.kind == Result_origin::EDGE
                    ? (1 - o.weight[0]) * normals[b[0]] + o.weight[0] * normals[b[1]]
                    : o.weight[0] * normals[b[0]] + o.weight[1] * normals[b[1]] + o.weight[2] * normals[b[2]];
  const double length = norm(n);
  return length > 0 ? (1 / length) * n : normals[b[0]];
}

} // namespace files
} // namespace meridian
