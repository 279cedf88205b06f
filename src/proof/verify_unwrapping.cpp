// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/proof/verify_unwrapping.h>

#include <meridian/base/list_elements.h>
#include <meridian/proof/verify_cut.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cstdint>
#include <string>

namespace meridian {

Verification verify_unwrapping(const Polygon_soup& input, const Result_mesh& result,
                               const std::vector<Plane_point>& texture)
{
  Verification found = verify_cut(input, result);
  if (texture.size() != result.points.size())
  {
    found.failures.push_back("the mesh has " + std::to_string(result.points.size()) + " vertices and "
                             + std::to_string(texture.size()) + " texture coordinates");
    return found;
  }
  if (!found) { return found; }
  const auto list = [&](const char* what, const std::vector<std::int32_t>& elements) {
    if (!elements.empty()) { found.failures.push_back(internal::list_elements(what, elements)); }
  };
  std::vector<std::int32_t> flipped, outside, overlapping;
  using Point_2 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
  std::vector<std::array<double, 4>> boxes(found.components.size(), {2, 2, -1, -1});
  for (std::size_t f = 0; f < result.faces.size(); ++f)
  {
    std::array<Point_2, 3> corners;
    auto& box = boxes[static_cast<std::size_t>(result.component_of[f])];
    bool is_inside = true;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const auto& p = texture[static_cast<std::size_t>(result.faces[f][k])];
      corners[k] = Point_2(p[0], p[1]);
      for (std::size_t d = 0; d < 2; ++d)
      {
        is_inside = is_inside && p[d] >= 0 && p[d] <= 1; // false for what is not a number
        box[d] = std::min(box[d], p[d]);
        box[d + 2] = std::max(box[d + 2], p[d]);
      }
    }
    if (!is_inside) { outside.push_back(static_cast<std::int32_t>(f)); }
    else if (CGAL::orientation(corners[0], corners[1], corners[2]) != CGAL::LEFT_TURN)
    {
      flipped.push_back(static_cast<std::int32_t>(f));
    }
  }
  for (std::size_t a = 0; a < boxes.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      if (boxes[a][0] < boxes[b][2] && boxes[b][0] < boxes[a][2] && boxes[a][1] < boxes[b][3]
          && boxes[b][1] < boxes[a][3])
      {
        overlapping.push_back(static_cast<std::int32_t>(a));
        break;
      }
  list("faces have texture coordinates outside of the unit square", outside);
  list("faces are turned over or have no area in the plane", flipped);
  list("components overlap others in the plane", overlapping);
  return found;
}

} // namespace meridian
