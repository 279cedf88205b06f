// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/result/internal/assemble_parts.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace meridian {

namespace internal {

Result_origin file_origin(const Origin& o, const Surface_component& c, Index points, const std::vector<Index>& added)
{
  const auto vertex = [&](Index v) {
    return c.vertex_of[v] < points ? c.vertex_of[v] : added[c.vertex_of[v] - points];
  };
  Result_origin r;
  switch (o.kind)
  {
  case Origin::VERTEX: r.index = {vertex(o.index[0]), -1}; break;
  case Origin::EDGE:
  {
    const Index v = vertex(o.index[0]), w = vertex(o.index[1]);
    r.kind = Result_origin::EDGE;
    r.index = {std::min(v, w), std::max(v, w)};
    r.weight = {v < w ? o.weight[0] : 1 - o.weight[0], 0, 0};
    break;
  }
  case Origin::FACE:
    r.kind = Result_origin::FACE;
    r.index = {c.triangle_of[o.index[0]], -1};
    r.weight = o.weight;
    if (c.is_flipped[o.index[0]]) { std::swap(r.weight[1], r.weight[2]); }
    break;
  }
  return r;
}

namespace {

// Puts the vertices of parts together, then their faces.
class Part_assembler
{
public:
  Part_assembler(const Polygon_soup& soup, const Examination& examination, const std::vector<Result_part>& parts)
    : m_soup(soup), m_examination(examination), m_parts(parts)
  {}

  Assembled_result assemble()
  {
    prepare_vertices();
    m_result.place.resize(m_parts.size());
    for (std::size_t i = 0; i < m_parts.size(); ++i) { add_vertices(i); }
    const Index triangles = place_points();
    std::vector<Index> begin = count_faces(triangles);
    for (std::size_t i = 0; i < m_parts.size(); ++i) { add_faces(i, begin); }
    std::sort(m_result.mesh.seams.begin(), m_result.mesh.seams.end());
    return std::move(m_result);
  }

private:
  Index input_vertices() const { return static_cast<Index>(m_soup.points.size()); }

  // Makes room for vertices: the file's, new ones by component, fans of pinched vertices. Copies are appended later.
  void prepare_vertices()
  {
    Result_mesh& r = m_result.mesh;
    for (const Result_part& part : m_parts) { m_new_vertices += static_cast<Index>(part.surface.origins.size()); }
    const Index n = input_vertices(), added = static_cast<Index>(m_examination.added_vertex_of.size());
    m_next_new = n;
    m_next_copy = n + m_new_vertices + added;
    r.origin.resize(n + m_new_vertices + added);
    r.copy_of.assign(n + m_new_vertices + added, -1);
    for (Index v = 0; v < n; ++v) { r.origin[v].index = {v, -1}; }
    for (Index i = 0; i < added; ++i)
    {
      r.copy_of[n + m_new_vertices + i] = m_examination.added_vertex_of[i];
      r.origin[n + m_new_vertices + i].index = {m_examination.added_vertex_of[i], -1};
    }
  }

  // Places the vertices of part `i`.
  void add_vertices(std::size_t i)
  {
    Result_mesh& r = m_result.mesh;
    auto& place = m_result.place[i];
    const Index n = input_vertices();
    const Surface_component& c = m_examination.components[i];
    place.reserve(m_parts[i].surface.points.size() + m_parts[i].opened.copy_of.size());
    for (Index v : c.vertex_of) { place.push_back(v < n ? v : v + m_new_vertices); }
    for (const Origin& o : m_parts[i].surface.origins)
    {
      r.origin[m_next_new] = file_origin(o, c, n, m_examination.added_vertex_of);
      place.push_back(m_next_new++);
    }
    for (Index v : m_parts[i].opened.copy_of)
    {
      const Index original = place[v], first = r.copy_of[original] < 0 ? original : r.copy_of[original];
      r.copy_of.push_back(first);
      r.origin.push_back(r.origin[first]);
      place.push_back(m_next_copy++);
    }
  }

  // Returns the number of triangles of the file.
  Index place_points()
  {
    std::vector<std::array<Index, 3>> corners;
    corners.reserve(m_soup.number_of_polygons());
    m_result.mesh.points.reserve(m_result.mesh.origin.size());
    for_each_triangle(m_soup, [&](Index, Index, Index a, Index b, Index c) { corners.push_back({a, b, c}); });
    for (const Result_origin& o : m_result.mesh.origin)
      m_result.mesh.points.push_back(
        position_of(o, m_soup.points, [&](Index t) -> const std::array<Index, 3>& { return corners[t]; }));
    return static_cast<Index>(corners.size());
  }

  // Makes room for the faces. Returns where those of each triangle begin.
  std::vector<Index> count_faces(Index triangles)
  {
    std::vector<Index> begin(triangles + 1, 0);
    Index faces = 0;
    for (std::size_t i = 0; i < m_parts.size(); ++i)
    {
      faces += m_parts[i].surface.number_of_faces();
      for (Index f : m_parts[i].surface.face_of) { ++begin[m_examination.components[i].triangle_of[f] + 1]; }
    }
    for (Index t = 0; t < triangles; ++t) { begin[t + 1] += begin[t]; }
    m_result.mesh.faces.resize(faces);
    m_result.mesh.face_of.resize(faces);
    m_result.mesh.component_of.resize(faces);
    return begin;
  }

  // Adds the faces and seams of part `i`. `next` is the next place of a face of each triangle.
  void add_faces(std::size_t i, std::vector<Index>& next)
  {
    Result_mesh& r = m_result.mesh;
    const auto& place = m_result.place[i];
    const Surface_component& c = m_examination.components[i];
    std::vector<Index> face_place;
    face_place.reserve(m_parts[i].opened.triangles.size());
    for (std::size_t f = 0; f < m_parts[i].opened.triangles.size(); ++f)
    {
      const Index root = m_parts[i].surface.face_of[f], to = next[c.triangle_of[root]]++;
      const auto& t = m_parts[i].opened.triangles[f];
      r.faces[to] = {place[t[0]], place[t[1]], place[t[2]]};
      r.face_of[to] = c.polygon_of[root];
      r.component_of[to] = static_cast<Index>(i);
      face_place.push_back(to);
    }
    for (const auto& seam : m_parts[i].opened.seams)
    {
      const Index a = 3 * face_place[seam[0] / 3] + seam[0] % 3, b = 3 * face_place[seam[1] / 3] + seam[1] % 3;
      r.seams.push_back({std::min(a, b), std::max(a, b)});
    }
  }

  const Polygon_soup& m_soup;
  const Examination& m_examination;
  const std::vector<Result_part>& m_parts;
  Assembled_result m_result;
  Index m_new_vertices = 0, m_next_new = 0, m_next_copy = 0;
};

} // namespace

Assembled_result assemble_parts(const Polygon_soup& soup, const Examination& examination,
                                const std::vector<Result_part>& cuts)
{
  return Part_assembler(soup, examination, cuts).assemble();
}

} // namespace internal

} // namespace meridian
