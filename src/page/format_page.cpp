// SPDX-License-Identifier: GPL-3.0-or-later
#include "format_page.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

// Files that the assembler puts into the program.
#define MERIDIAN_EMBED(NAME, FILE)                                                     \
  __asm__(".section .rodata\n" #NAME "_begin:\n.incbin \"" FILE "\"\n" #NAME "_end:\n.byte 0\n.previous\n"); \
  extern "C" const char NAME##_begin[], NAME##_end[];

MERIDIAN_EMBED(meridian_page, MERIDIAN_PAGE)
MERIDIAN_EMBED(meridian_script, MERIDIAN_PAGE_SCRIPT)
MERIDIAN_EMBED(meridian_three, MERIDIAN_THREE "/build/three.min.js")
MERIDIAN_EMBED(meridian_controls, MERIDIAN_THREE "/examples/js/controls/TrackballControls.js")
MERIDIAN_EMBED(meridian_line_geometry, MERIDIAN_THREE "/examples/js/lines/LineSegmentsGeometry.js")
MERIDIAN_EMBED(meridian_line_material, MERIDIAN_THREE "/examples/js/lines/LineMaterial.js")
MERIDIAN_EMBED(meridian_line_segments, MERIDIAN_THREE "/examples/js/lines/LineSegments2.js")

namespace meridian {
namespace page {

namespace {

template <class Number> std::string base64(const std::vector<Number>& values)
{
  static const char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const auto* bytes = reinterpret_cast<const unsigned char*>(values.data());
  const std::size_t n = values.size() * sizeof(Number);
  std::string text;
  text.reserve((n + 2) / 3 * 4);
  for (std::size_t i = 0; i < n; i += 3)
  {
    const unsigned long block = static_cast<unsigned long>(bytes[i]) << 16 | (i + 1 < n ? bytes[i + 1] : 0ul) << 8 | (i + 2 < n ? bytes[i + 2] : 0ul);
    text += letters[block >> 18 & 63];
    text += letters[block >> 12 & 63];
    text += i + 1 < n ? letters[block >> 6 & 63] : '=';
    text += i + 2 < n ? letters[block & 63] : '=';
  }
  return text;
}

std::string escaped(const std::string& text)
{
  std::string result;
  for (char c : text) { result += c == '<' ? "&lt;" : c == '&' ? "&amp;" : c == '"' ? "&quot;" : std::string(1, c); }
  return result;
}

void replace(std::string& text, const std::string& mark, const std::string& by)
{
  const std::size_t at = text.find(mark);
  text.replace(at, mark.size(), by);
}

} // namespace

std::string format_page(const std::string& title, const Examination& examination, const std::vector<Disc_cut>& cuts, const Assembled_result& assembled)
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
  const auto append = [&](std::vector<float>& array, Index v) {
    for (int i = 0; i < 3; ++i) { array.push_back(static_cast<float>((points[v][i] - middle[i]) / size)); }
  };

  std::vector<float> positions, field, meridians, links;
  std::vector<std::uint32_t> corners;
  std::int64_t genus = 0, loops = 0;
  double length = 0;
  for (std::size_t c = 0; c < cuts.size(); ++c)
  {
    const Disc_cut& cut = cuts[c];
    const auto& place = assembled.place[c];
    const auto base = static_cast<std::uint32_t>(positions.size() / 3);
    genus += examination.components[c].genus();
    loops += examination.components[c].boundary_loops;
    length += examination.components[c].unit * cut.length;
    const Triangle_surface& root = examination.components[c].surface;
    for (Index v = 0; v < cut.surface.number_of_vertices(); ++v)
    {
      append(positions, place[v]);
      double value = -1; // no field
      if (!cut.field.empty())
      {
        const Origin o = cut.surface.origin(v);
        value = 0;
        if (o.kind == Origin::VERTEX) { value = cut.field[o.index[0]]; }
        if (o.kind == Origin::EDGE) { value = (1 - o.weight[0]) * cut.field[o.index[0]] + o.weight[0] * cut.field[o.index[1]]; }
        if (o.kind == Origin::FACE) { for (int k = 0; k < 3; ++k) { value += o.weight[k] * cut.field[root.triangles[o.index[0]][k]]; } }
      }
      field.push_back(static_cast<float>(value));
    }
    for (const auto& t : cut.surface.triangles)
      for (Index v : t) { corners.push_back(base + static_cast<std::uint32_t>(v)); }
    const auto add_path = [&](std::vector<float>& array, const std::vector<Index>& path, bool closed) {
      for (std::size_t i = 0; i + (closed ? 0 : 1) < path.size(); ++i)
      {
        append(array, place[path[i]]);
        append(array, place[path[(i + 1) % path.size()]]);
      }
    };
    for (const auto& m : cut.meridians) { add_path(meridians, m, true); }
    for (const auto& l : cut.links) { add_path(links, l, false); }
  }

  char caption[160];
  std::snprintf(caption, sizeof caption, "%zu component%s, genus %lld, %lld boundary loops; cut length %.6g", cuts.size(),
                cuts.size() == 1 ? "" : "s", static_cast<long long>(genus), static_cast<long long>(loops), length);
  std::string scripts;
  const auto add_script = [&](const char* begin, const char* end) { scripts += "<script>\n" + std::string(begin, end) + "\n</script>\n"; };
  add_script(meridian_three_begin, meridian_three_end);
  add_script(meridian_controls_begin, meridian_controls_end);
  add_script(meridian_line_geometry_begin, meridian_line_geometry_end);
  add_script(meridian_line_material_begin, meridian_line_material_end);
  add_script(meridian_line_segments_begin, meridian_line_segments_end);
  scripts += "<script>\nconst data = {positions: '" + base64(positions) + "', corners: '" + base64(corners) + "', field: '" + base64(field)
             + "', meridians: '" + base64(meridians) + "', links: '" + base64(links) + "'};\n</script>\n";
  add_script(meridian_script_begin, meridian_script_end);

  std::string text(meridian_page_begin, meridian_page_end);
  replace(text, "@TITLE@", escaped(title));
  replace(text, "@HEADING@", escaped(title.substr(title.find_last_of('/') + 1)));
  replace(text, "@CAPTION@", caption);
  replace(text, "@SCRIPTS@", scripts);
  return text;
}

} // namespace page
} // namespace meridian
