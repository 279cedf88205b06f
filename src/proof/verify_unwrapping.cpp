// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/proof/verify_unwrapping.h>

#include <meridian/base/list_elements.h>
#include <meridian/proof/verify_cut.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace meridian {

namespace verification {

namespace {

using Texture = std::vector<Plane_point>;

// Not so for what is not a number.
bool is_in_unit_square(const std::array<std::int32_t, 3>& face, const Texture& texture)
{
  return std::all_of(face.begin(), face.end(), [&](std::int32_t v) {
    const Plane_point& p = texture[static_cast<std::size_t>(v)];
    return p[0] >= 0 && p[0] <= 1 && p[1] >= 0 && p[1] <= 1;
  });
}

// Whether a face is turned over or has no area in the plane: its corners do not turn left.
bool is_flipped(const std::array<std::int32_t, 3>& face, const Texture& texture)
{
  using Point_2 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
  std::array<Point_2, 3> corners;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Plane_point& p = texture[static_cast<std::size_t>(face[k])];
    corners[k] = Point_2(p[0], p[1]);
  }
  return CGAL::orientation(corners[0], corners[1], corners[2]) != CGAL::LEFT_TURN;
}

// The components whose bounding rectangles overlap that of one before.
std::vector<std::int32_t> find_overlapping(const Result_mesh& result, const Texture& texture, std::size_t components)
{
  std::vector<std::array<double, 4>> boxes(components, {2, 2, -1, -1});
  for (std::size_t f = 0; f < result.faces.size(); ++f)
  {
    auto& box = boxes[static_cast<std::size_t>(result.component_of[f])];
    for (std::int32_t v : result.faces[f])
      for (std::size_t d = 0; d < 2; ++d)
      {
        const double x = texture[static_cast<std::size_t>(v)][d];
        box[d] = std::min(box[d], x);
        box[d + 2] = std::max(box[d + 2], x);
      }
  }
  std::vector<std::int32_t> overlapping;
  for (std::size_t a = 0; a < components; ++a)
  {
    const bool overlaps =
      std::any_of(boxes.begin(), boxes.begin() + static_cast<std::ptrdiff_t>(a), [&](const auto& b) {
        return boxes[a][0] < b[2] && b[0] < boxes[a][2] && boxes[a][1] < b[3] && b[1] < boxes[a][3];
      });
    if (overlaps) { overlapping.push_back(static_cast<std::int32_t>(a)); }
  }
  return overlapping;
}

} // namespace

} // namespace verification

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
  std::vector<std::int32_t> flipped, outside;
  for (std::size_t f = 0; f < result.faces.size(); ++f)
  {
    if (!verification::is_in_unit_square(result.faces[f], texture)) { outside.push_back(static_cast<std::int32_t>(f)); }
    else if (verification::is_flipped(result.faces[f], texture)) { flipped.push_back(static_cast<std::int32_t>(f)); }
  }
  list("faces have texture coordinates outside of the unit square", outside);
  list("faces are turned over or have no area in the plane", flipped);
  list("components overlap others in the plane",
       verification::find_overlapping(result, texture, found.components.size()));
  return found;
}

} // namespace meridian
