// SPDX-License-Identifier: GPL-3.0-or-later
#include "format_page.h"

#include "embed.h"

#include <meridian/base/Bounding_box.h>
#include <meridian/base/vectors.h>
#include <meridian/result/Assembled_result.h>
#include <meridian/surface/Refined_surface.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

MERIDIAN_EMBED(meridian_page, MERIDIAN_PAGE)
MERIDIAN_EMBED(meridian_script, MERIDIAN_PAGE_SCRIPT)

namespace meridian {
namespace page {

namespace {

// The field at a vertex of a refined surface; -1 without a field.
double field_at(const Part& part, Index v)
{
  if (part.field.empty()) { return -1; }
  const Origin o = part.surface.origin(v);
  double value = 0;
  switch (o.kind)
  {
  case Origin::VERTEX: value = part.field[o.index[0]]; break;
  case Origin::EDGE: value = (1 - o.weight[0]) * part.field[o.index[0]] + o.weight[0] * part.field[o.index[1]]; break;
  case Origin::FACE:
    for (int k = 0; k < 3; ++k) { value += o.weight[k] * part.field[part.root.triangles[o.index[0]][k]]; }
    break;
  }
  return value;
}

// The arrays that the page draws, moved and scaled so that the surfaces lie around the origin.
class Page_data
{
public:
  explicit Page_data(const Assembled_result& assembled) : m_assembled(assembled)
  {
    const auto& points = assembled.mesh.points;
    Bounding_box<Point> box(points.front());
    for (const auto& place : assembled.place)
    {
      for (Index v : place) { box.add(points[v]); }
    }
    m_middle = 0.5 * box.low + 0.5 * box.high;
    for (int i = 0; i < 3; ++i) { m_size = std::max(m_size, (box.high[i] / 2 - box.low[i] / 2) * 1.5); }
  }
  explicit Page_data(Assembled_result&&) = delete;

  void add(const Part& part, std::size_t component)
  {
    const auto base = static_cast<std::uint32_t>(m_positions.size() / 3);
    for (Index v = 0; v < part.surface.number_of_vertices(); ++v)
    {
      append(m_positions, m_assembled.place[component][v]);
      m_field.push_back(static_cast<float>(field_at(part, v)));
    }
    for (const auto& t : part.surface.triangles)
      for (Index v : t) { m_corners.push_back(base + static_cast<std::uint32_t>(v)); }
  }

  void add(const Curve& curve)
  {
    const auto& place = m_assembled.place[curve.part];
    const auto& path = curve.path;
    std::vector<float>& lines = m_lines[curve.kind];
    for (std::size_t i = 0; i + (curve.is_closed ? 0 : 1) < path.size(); ++i)
    {
      append(lines, place[path[i]]);
      append(lines, place[path[(i + 1) % path.size()]]);
    }
    for (std::size_t i = 0; i + 1 < curve.points.size(); ++i)
    {
      append(lines, curve.points[i]);
      append(lines, curve.points[i + 1]);
    }
    if (curve.label.empty()) { return; }
    std::vector<float> at;
    append(at, place[path[path.size() / 2]]);
    char text[120];
    std::snprintf(text, sizeof text, "{at: [%.5g, %.5g, %.5g], kind: %d, text: '", at[0], at[1], at[2],
                  static_cast<int>(curve.kind));
    m_labels += text + escaped(curve.label) + "'},";
  }

  std::string format() const
  {
    return "<script>\nconst data = {positions: '" + base64(m_positions) + "', corners: '" + base64(m_corners)
           + "', field: '" + base64(m_field) + "', meridians: '" + base64(m_lines[Curve::MERIDIAN]) + "', others: '"
           + base64(m_lines[Curve::OTHER]) + "', flow: '" + base64(m_lines[Curve::FLOW]) + "', labels: [" + m_labels
           + "]};\n</script>\n";
  }

private:
  void append(std::vector<float>& array, const Point& p) const
  {
    for (int i = 0; i < 3; ++i) { array.push_back(static_cast<float>((p[i] - m_middle[i]) / m_size)); }
  }
  void append(std::vector<float>& array, Index v) const { append(array, m_assembled.mesh.points[v]); }

  const Assembled_result& m_assembled;
  Point m_middle{0, 0, 0};
  double m_size = 1e-300;
  std::vector<float> m_positions, m_field;
  std::array<std::vector<float>, 3> m_lines;
  std::vector<std::uint32_t> m_corners;
  std::string m_labels;
};

} // namespace

std::string format_page(const std::string& title, const std::string& caption, const std::string& others,
                        const std::vector<Part>& parts, const std::vector<Curve>& curves,
                        const Assembled_result& assembled)
{
  Page_data data(assembled);
  for (std::size_t c = 0; c < parts.size(); ++c) { data.add(parts[c], c); }
  for (const Curve& curve : curves) { data.add(curve); }

  std::string text = begin_page(std::string(meridian_page_begin, meridian_page_end), title, caption);
  replace(text, "@OTHERS@", others);
  replace(text, "@SCRIPTS@", library_scripts() + data.format() + script(meridian_script_begin, meridian_script_end));
  return text;
}

} // namespace page
} // namespace meridian
