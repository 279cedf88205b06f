// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/result/recount.h>

#include <meridian/base/vectors.h>

#include <meridian/surface/pieces.h>

#include <numeric>

namespace meridian {

namespace internal {

Polygon_soup soup_of(const Triangle_surface& root)
{
  Polygon_soup soup;
  soup.points = root.points;
  for (const auto& t : root.triangles) { soup.add_polygon(t.data(), 3); }
  return soup;
}

Examination examination_of(const Triangle_surface& root)
{
  Examination examination;
  examination.components.resize(1);
  Surface_component& c = examination.components.front();
  c.vertex_of.resize(root.number_of_vertices());
  c.triangle_of.resize(root.number_of_faces());
  std::iota(c.vertex_of.begin(), c.vertex_of.end(), Index(0));
  std::iota(c.triangle_of.begin(), c.triangle_of.end(), Index(0));
  c.polygon_of = c.triangle_of;
  c.is_flipped.assign(root.number_of_faces(), 0);
  return examination;
}

Result_mesh result_of(const Refined_surface& s, const std::vector<Origin>& origins, const std::vector<Index>& face_of)
{
  const Opened_surface opened = open_along(s);
  Result_mesh result;
  result.points = s.points;
  result.faces = opened.triangles;
  result.copy_of.assign(s.points.size(), -1);
  for (const Origin& o : origins)
  {
    const Result_origin::Kind kind = o.kind == Origin::VERTEX ? Result_origin::VERTEX
                                     : o.kind == Origin::EDGE ? Result_origin::EDGE
                                                              : Result_origin::FACE;
    result.origin.push_back({kind, o.index, o.weight});
  }
  for (Index v : opened.copy_of)
  {
    result.points.push_back(s.points[v]);
    result.copy_of.push_back(v);
    result.origin.push_back(result.origin[v]);
  }
  result.face_of = face_of;
  result.component_of.assign(opened.triangles.size(), 0);
  result.seams = opened.seams;
  return result;
}

} // namespace internal

Verification verify_cut(const Triangle_surface& root, const Cut& cut)
{
  const Polygon_soup soup = internal::soup_of(root);
  return verify_cut(soup, assemble_result(soup, internal::examination_of(root), std::vector<Cut>{cut}).mesh);
}

Verification verify_charts(const Triangle_surface& root, const Cut& cut)
{
  const Polygon_soup soup = internal::soup_of(root);
  Result_mesh mesh = assemble_result(soup, internal::examination_of(root), std::vector<Cut>{cut}).mesh;
  Triangle_surface opened;
  opened.points = mesh.points;
  opened.triangles = mesh.faces;
  connect(opened);
  mesh.chart_of = number_pieces(opened);
  return verify_cut(soup, mesh);
}

} // namespace meridian
