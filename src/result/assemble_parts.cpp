// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/result/internal/assemble_parts.h>

#include <algorithm>
#include <array>
#include <utility>

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

Assembled_result assemble_parts(const Polygon_soup& soup, const Examination& examination,
                                const std::vector<Result_part>& cuts)
{
  Assembled_result result;
  Result_mesh& r = result.mesh;
  const Index n = static_cast<Index>(soup.points.size());
  Index new_vertices = 0, new_faces = 0, triangles = 0;
  for (const Result_part& cut : cuts)
  {
    new_vertices += static_cast<Index>(cut.surface.origins.size());
    new_faces += cut.surface.number_of_faces();
  }
  std::vector<std::array<Index, 3>> corners;
  for_each_triangle(soup, [&](Index, Index, Index a, Index b, Index c) {
    corners.push_back({a, b, c});
    ++triangles;
  });

  // Vertices: the file's, new ones by component, fans of pinched vertices, copies by component.
  const Index added = static_cast<Index>(examination.added_vertex_of.size());
  Index next_new = n, next_copy = n + new_vertices + added;
  r.origin.resize(n + new_vertices + added);
  r.copy_of.assign(n + new_vertices + added, -1);
  for (Index v = 0; v < n; ++v) { r.origin[v].index = {v, -1}; }
  for (Index i = 0; i < added; ++i)
  {
    r.copy_of[n + new_vertices + i] = examination.added_vertex_of[i];
    r.origin[n + new_vertices + i].index = {examination.added_vertex_of[i], -1};
  }
  auto& place = result.place;
  place.resize(cuts.size());
  for (std::size_t i = 0; i < cuts.size(); ++i)
  {
    const Refined_surface& s = cuts[i].surface;
    const Surface_component& c = examination.components[i];
    for (Index v : c.vertex_of) { place[i].push_back(v < n ? v : v + new_vertices); }
    for (const Origin& o : s.origins)
    {
      r.origin[next_new] = internal::file_origin(o, c, n, examination.added_vertex_of);
      place[i].push_back(next_new++);
    }
    for (Index v : cuts[i].opened.copy_of)
    {
      const Index original = place[i][v], first = r.copy_of[original] < 0 ? original : r.copy_of[original];
      r.copy_of.push_back(first);
      r.origin.push_back(r.origin[first]);
      place[i].push_back(next_copy++);
    }
  }
  for (const Result_origin& o : r.origin)
    r.points.push_back(position_of(o, soup.points, [&](Index t) -> const std::array<Index, 3>& { return corners[t]; }));

  // Faces, sorted by the triangle they are part of.
  std::vector<Index> begin(triangles + 1, 0);
  for (std::size_t i = 0; i < cuts.size(); ++i)
    for (Index f : cuts[i].surface.face_of) { ++begin[examination.components[i].triangle_of[f] + 1]; }
  for (Index t = 0; t < triangles; ++t) { begin[t + 1] += begin[t]; }
  r.faces.resize(new_faces);
  r.face_of.resize(new_faces);
  r.component_of.resize(new_faces);
  for (std::size_t i = 0; i < cuts.size(); ++i)
  {
    const Surface_component& c = examination.components[i];
    std::vector<Index> face_place;
    for (std::size_t f = 0; f < cuts[i].opened.triangles.size(); ++f)
    {
      const Index root = cuts[i].surface.face_of[f], to = begin[c.triangle_of[root]]++;
      const auto& t = cuts[i].opened.triangles[f];
      r.faces[to] = {place[i][t[0]], place[i][t[1]], place[i][t[2]]};
      r.face_of[to] = c.polygon_of[root];
      r.component_of[to] = static_cast<Index>(i);
      face_place.push_back(to);
    }
    for (const auto& seam : cuts[i].opened.seams)
    {
      const Index a = 3 * face_place[seam[0] / 3] + seam[0] % 3, b = 3 * face_place[seam[1] / 3] + seam[1] % 3;
      r.seams.push_back({std::min(a, b), std::max(a, b)});
    }
  }
  std::sort(r.seams.begin(), r.seams.end());
  return result;
}

} // namespace internal

} // namespace meridian
