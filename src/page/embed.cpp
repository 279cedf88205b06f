// SPDX-License-Identifier: GPL-3.0-or-later
#include "embed.h"

MERIDIAN_EMBED(meridian_three, MERIDIAN_THREE "/build/three.min.js")
MERIDIAN_EMBED(meridian_controls, MERIDIAN_THREE "/examples/js/controls/TrackballControls.js")
MERIDIAN_EMBED(meridian_line_geometry, MERIDIAN_THREE "/examples/js/lines/LineSegmentsGeometry.js")
MERIDIAN_EMBED(meridian_line_material, MERIDIAN_THREE "/examples/js/lines/LineMaterial.js")
MERIDIAN_EMBED(meridian_head, MERIDIAN_PAGE_HEAD)
MERIDIAN_EMBED(meridian_shared, MERIDIAN_SHARED_SCRIPT)
MERIDIAN_EMBED(meridian_line_segments, MERIDIAN_THREE "/examples/js/lines/LineSegments2.js")

namespace meridian {
namespace page {

std::string script(const char* begin, const char* end)
{
  return "<script>\n" + std::string(begin, end) + "\n</script>\n";
}

std::string library_scripts()
{
  return script(meridian_three_begin, meridian_three_end) + script(meridian_controls_begin, meridian_controls_end)
         + script(meridian_line_geometry_begin, meridian_line_geometry_end)
         + script(meridian_line_material_begin, meridian_line_material_end)
         + script(meridian_line_segments_begin, meridian_line_segments_end)
         + script(meridian_shared_begin, meridian_shared_end);
}

std::string escaped(const std::string& text)
{
  std::string result;
  for (char c : text) { result += c == '<' ? "&lt;" : c == '&' ? "&amp;" : c == '"' ? "&quot;" : std::string(1, c); }
  return result;
}

std::string begin_page(const std::string& body, const std::string& title, const std::string& caption)
{
  std::string text(meridian_head_begin, meridian_head_end);
  text += body;
  replace(text, "@TITLE@", escaped(title));
  replace(text, "@HEADING@", escaped(title.substr(title.find_last_of('/') + 1)));
  replace(text, "@CAPTION@", escaped(caption));
  return text;
}

void replace(std::string& text, const std::string& mark, const std::string& by)
{
  const std::size_t at = text.find(mark);
  text.replace(at, mark.size(), by);
}

} // namespace page
} // namespace meridian
