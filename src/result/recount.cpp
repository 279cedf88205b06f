// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/result/recount.h>

#include <meridian/base/vectors.h>

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

} // namespace internal

Verification verify_cut(const Triangle_surface& root, const Cut& cut)
{
  const Polygon_soup soup = internal::soup_of(root);
  return verify_cut(soup, assemble_result(soup, internal::examination_of(root), std::vector<Cut>{cut}).mesh);
}

} // namespace meridian
