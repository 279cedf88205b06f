// SPDX-License-Identifier: GPL-3.0-or-later
#include "format_page.h"

#include "embed.h"

#include <meridian/base/vectors.h>
#include <meridian/result/Assembled_result.h>
#include <meridian/surface/Refined_surface.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

MERIDIAN_EMBED(meridian_page, MERIDIAN_PAGE)
MERIDIAN_EMBED(meridian_script, MERIDIAN_PAGE_SCRIPT)

namespace meridian {
namespace page {

std::string format_page(const std::string& title, const std::string& caption, const std::string& others,
                        const std::vector<Part>& parts, const std::vector<Curve>& curves,
                        const Assembled_result& assembled)
{
  const auto& points = assembled.mesh.points;
  Point low = points.front(), high = low;
  for (const auto& place : assembled.place)
    for (Index v : place)
      for (int i = 0; i < 3; ++i)
      {
        low[i] = std::min(low[i], points[v][i]);
        high[i] = std::max(high[i], points[v][i]);
      }
  const Point middle = 0.5 * low + 0.5 * high;
  double size = 1e-300;
  for (int i = 0; i < 3; ++i) { size = std::max(size, (high[i] / 2 - low[i] / 2) * 1.5); }
  const auto append_point = [&](std::vector<float>& array, const Point& p) {
    for (int i = 0; i < 3; ++i) { array.push_back(static_cast<float>((p[i] - middle[i]) / size)); }
  };
  const auto append = [&](std::vector<float>& array, Index v) { append_point(array, points[v]); };

  std::vector<float> positions, field;
  std::array<std::vector<float>, 3> lines;
  std::vector<std::uint32_t> corners;
  for (std::size_t c = 0; c < parts.size(); ++c)
  {
    const Part& part = parts[c];
    const auto base = static_cast<std::uint32_t>(positions.size() / 3);
    for (Index v = 0; v < part.surface.number_of_vertices(); ++v)
    {
      append(positions, assembled.place[c][v]);
      double value = -1; // no field
      if (!part.field.empty())
      {
        const Origin o = part.surface.origin(v);
        value = 0;
        if (o.kind == Origin::VERTEX) { value = part.field[o.index[0]]; }
        if (o.kind == Origin::EDGE)
        {
          value = (1 - o.weight[0]) * part.field[o.index[0]] + o.weight[0] * part.field[o.index[1]];
        }
        if (o.kind == Origin::FACE)
        {
          for (int k = 0; k < 3; ++k) { value += o.weight[k] * part.field[part.root.triangles[o.index[0]][k]]; }
        }
      }
      field.push_back(static_cast<float>(value));
    }
    for (const auto& t : part.surface.triangles)
      for (Index v : t) { corners.push_back(base + static_cast<std::uint32_t>(v)); }
  }
  std::string labels;
  for (const Curve& curve : curves)
  {
    const auto& place = assembled.place[curve.part];
    const auto& path = curve.path;
    for (std::size_t i = 0; i + (curve.is_closed ? 0 : 1) < path.size(); ++i)
    {
      append(lines[curve.kind], place[path[i]]);
      append(lines[curve.kind], place[path[(i + 1) % path.size()]]);
    }
    for (std::size_t i = 0; i + 1 < curve.points.size(); ++i)
    {
      append_point(lines[curve.kind], curve.points[i]);
      append_point(lines[curve.kind], curve.points[i + 1]);
    }
    if (curve.label.empty()) { continue; }
    std::vector<float> at;
    append(at, place[path[path.size() / 2]]);
    char text[120];
    std::snprintf(text, sizeof text, "{at: [%.5g, %.5g, %.5g], kind: %d, text: '", at[0], at[1], at[2],
                  static_cast<int>(curve.kind));
    labels += text + escaped(curve.label) + "'},";
  }

  std::string scripts = library_scripts();
  scripts += "<script>\nconst data = {positions: '" + base64(positions) + "', corners: '" + base64(corners)
             + "', field: '" + base64(field) + "', meridians: '" + base64(lines[Curve::MERIDIAN]) + "', others: '"
             + base64(lines[Curve::OTHER]) + "', flow: '" + base64(lines[Curve::FLOW]) + "', labels: [" + labels
             + "]};\n</script>\n";
  scripts += script(meridian_script_begin, meridian_script_end);

  std::string text(meridian_page_begin, meridian_page_end);
  replace(text, "@TITLE@", escaped(title));
  replace(text, "@HEADING@", escaped(title.substr(title.find_last_of('/') + 1)));
  replace(text, "@CAPTION@", escaped(caption));
  replace(text, "@OTHERS@", others);
  replace(text, "@SCRIPTS@", scripts);
  return text;
}

} // namespace page
} // namespace meridian
