// SPDX-License-Identifier: GPL-3.0-or-later
#include "format_unwrap_page.h"

#include "embed.h"
#include "files/chart_borders.h"

#include <meridian/base/Bounding_box.h>
#include <meridian/base/Result_mesh.h>
#include <meridian/base/vectors.h>
#include <meridian/unwrap/square_border.h>

#include <algorithm>

MERIDIAN_EMBED(meridian_unwrap_page, MERIDIAN_UNWRAP_PAGE)
MERIDIAN_EMBED(meridian_unwrap_script, MERIDIAN_UNWRAP_SCRIPT)

namespace meridian {
namespace page {

std::string format_unwrap_page(const std::string& title, const std::string& caption, const Result_mesh& mesh,
                               const std::vector<Plane_point>& texture, const std::vector<double>& distortion)
{
  Bounding_box<Point> box(mesh.points[mesh.faces.front()[0]]);
  for (const auto& f : mesh.faces)
  {
    for (std::int32_t v : f) { box.add(mesh.points[v]); }
  }
  const auto& [low, high] = box;
  double size = 1e-300;
  for (std::size_t i = 0; i < 3; ++i) { size = std::max(size, (high[i] / 2 - low[i] / 2) * 1.5); }
  std::vector<float> positions, places, stretch(distortion.begin(), distortion.end());
  std::vector<std::uint32_t> corners, original, seams, borders; // of lines on the surface, and in the layout
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
  {
    const bool is_copy = mesh.copy_of[v] >= 0;
    for (std::size_t i = 0; i < 3 && !is_copy; ++i)
    {
      positions.push_back(static_cast<float>((mesh.points[v][i] - 0.5 * low[i] - 0.5 * high[i]) / size));
    }
    for (double x : texture[v]) { places.push_back(static_cast<float>(x)); }
    original.push_back(static_cast<std::uint32_t>(is_copy ? static_cast<std::size_t>(mesh.copy_of[v]) : v));
  }
  for (const auto& f : mesh.faces) { corners.insert(corners.end(), f.begin(), f.end()); }
  const auto append = [&](std::vector<std::uint32_t>& lines, const std::vector<std::int32_t>& sides) {
    for (std::int32_t h : sides)
      for (std::int32_t k : {h % 3, (h + 1) % 3}) { lines.push_back(static_cast<std::uint32_t>(mesh.faces[h / 3][k])); }
  };
  for (const files::Border_path& path : files::find_chart_borders(mesh))
  {
    append(seams, path.sides);
    append(borders, path.sides);
    append(borders, path.mates);
  }

  std::string text = begin_page(std::string(meridian_unwrap_page_begin, meridian_unwrap_page_end), title, caption);
  replace(text, "@SCRIPTS@",
          library_scripts() + "<script>\nconst data = {positions: '" + base64(positions) + "', places: '"
            + base64(places) + "', original: '" + base64(original) + "', corners: '" + base64(corners) + "', stretch: '"
            + base64(stretch) + "', seams: '" + base64(seams) + "', borders: '" + base64(borders) + "'};\n</script>\n"
            + script(meridian_unwrap_script_begin, meridian_unwrap_script_end));
  return text;
}

} // namespace page
} // namespace meridian
