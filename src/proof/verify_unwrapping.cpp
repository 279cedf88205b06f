// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/proof/verify_unwrapping.h>

#include <meridian/base/list_elements.h>
#include <meridian/proof/internal/verify_layout.h>
#include <meridian/proof/verify_cut.h>
#include <meridian/proof/verify_packing.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace meridian {

namespace verification {

namespace {

using Texture = std::vector<Plane_point>;

// Whether a face lies in one of the first tiles. Not so for what is not a number.
bool is_in_one_tile(const std::array<std::int32_t, 3>& face, const Texture& texture, int tiles)
{
  constexpr int columns = 10;
  const auto at = [&](std::size_t k) -> const Plane_point& { return texture[static_cast<std::size_t>(face[k])]; };
  for (int t = 0; t < tiles; ++t)
  {
    const int row = t / columns, column = t % columns;
    const double x = column, y = row;
    const auto is_inside = [&](const Plane_point& p) {
      return p[0] >= x && p[0] <= x + 1 && p[1] >= y && p[1] <= y + 1;
    };
    if (is_inside(at(0)) && is_inside(at(1)) && is_inside(at(2))) { return true; }
  }
  return false;
}

// The exact sign of the area of a face in the plane.
CGAL::Orientation orientation(const std::array<std::int32_t, 3>& face, const Texture& texture)
{
  using Point_2 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
  std::array<Point_2, 3> corners;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Plane_point& p = texture[static_cast<std::size_t>(face[k])];
    corners[k] = Point_2(p[0], p[1]);
  }
  return CGAL::orientation(corners[0], corners[1], corners[2]);
}

// Whether a face is turned over or has no area in the plane: its corners do not turn left.
bool is_flipped(const std::array<std::int32_t, 3>& face, const Texture& texture)
{
  return orientation(face, texture) != CGAL::LEFT_TURN;
}

// Each of some elements once, ascending.
std::vector<std::int32_t> once(std::vector<std::int32_t> elements)
{
  std::sort(elements.begin(), elements.end());
  elements.erase(std::unique(elements.begin(), elements.end()), elements.end());
  return elements;
}

// A failure that names elements once each, if there are any.
void list_once(Verification& found, const char* what, std::vector<std::int32_t> elements)
{
  elements = once(std::move(elements));
  if (!elements.empty()) { found.failures.push_back(internal::list_elements(what, elements)); }
}

} // namespace

} // namespace verification

Verification verify_unwrapping(const Polygon_soup& input, const Result_mesh& result,
                               const std::vector<Plane_point>& texture, const Padding& padding, int tiles)
{
  Verification found = verify_cut(input, result);
  if (texture.size() != result.points.size())
  {
    found.failures.push_back("the mesh has " + std::to_string(result.points.size()) + " vertices and "
                             + std::to_string(texture.size()) + " texture coordinates");
    return found;
  }
  if (!found) { return found; }
  std::vector<std::int32_t> flipped, outside;
  for (std::size_t f = 0; f < result.faces.size(); ++f)
  {
    if (!verification::is_in_one_tile(result.faces[f], texture, tiles))
    {
      outside.push_back(static_cast<std::int32_t>(f));
    }
    else if (verification::is_flipped(result.faces[f], texture)) { flipped.push_back(static_cast<std::int32_t>(f)); }
  }
  verification::list_once(found,
                          tiles == 1 ? "faces have texture coordinates outside of the unit square"
                                     : "faces are not in one tile of the texture",
                          outside);
  verification::list_once(found, "faces are turned over or have no area in the plane", flipped);
  if (!outside.empty() || !flipped.empty()) { return found; }
  const verification::Layout_verifier layout(result, texture);
  verification::list_once(found, "faces have a border in the plane that meets another", layout.find_meeting());
  if (!found) { return found; }
  verification::list_once(found, "charts lie inside others in the plane; they begin with faces", layout.find_inside());
  if (padding.texels > 0)
  {
    verification::list_once(found, "faces are nearer to another chart than the padding", layout.find_near(padding));
  }
  return found;
}

Verification verify_packing(const std::vector<std::array<std::int32_t, 3>>& faces,
                            const std::vector<Plane_point>& texture, const Padding& padding, int tiles,
                            const std::vector<Plane_point>& before)
{
  Verification found;
  std::vector<std::int32_t> outside, changed;
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    if (!verification::is_in_one_tile(faces[f], texture, tiles)) { outside.push_back(static_cast<std::int32_t>(f)); }
  }
  if (!outside.empty())
  {
    verification::list_once(found, "faces are not in one tile of the texture", outside);
    return found;
  }
  for (std::size_t f = 0; f < faces.size() && !before.empty(); ++f)
  {
    if (verification::orientation(faces[f], texture) != verification::orientation(faces[f], before))
    {
      changed.push_back(static_cast<std::int32_t>(f));
    }
  }
  Result_mesh mesh;
  mesh.faces = faces;
  mesh.points.resize(texture.size());
  const verification::Layout_verifier layout(mesh, texture, verification::Layout_verifier::Joined::AT_VERTICES);
  verification::list_once(found, "faces were turned over or lost their area when they were packed", changed);
  verification::list_once(found, "faces are nearer to another chart than the padding", layout.find_near(padding));
  if (found)
  {
    verification::list_once(found, "charts lie inside others in the plane; they begin with faces",
                            layout.find_inside());
  }
  return found;
}

std::vector<std::int32_t> find_near_themselves(const std::vector<std::array<std::int32_t, 3>>& faces,
                                               const std::vector<Plane_point>& texture, const Padding& padding)
{
  Result_mesh mesh;
  mesh.faces = faces;
  mesh.points.resize(texture.size());
  return verification::once(verification::Layout_verifier(mesh, texture).find_near_itself(padding));
}

} // namespace meridian
