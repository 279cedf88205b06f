// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/map/pack_charts.h>

#include <meridian/map/planar_map.h>

#include <meridian/base/Bounding_box.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace meridian {

namespace {

// Charts in their rectangles, which are put on shelves.
class Chart_packer
{
public:
  void add(const Chart& chart, bool is_turned)
  {
    m_placed.push_back(scale_to_area(chart, is_turned));
    std::vector<Plane_point>& at = m_placed.back();
    Bounding_box<Plane_point> box(at.front());
    for (const Plane_point& p : at) { box.add(p); }
    for (Plane_point& p : at) { p = p - box.low; }
    m_boxes.push_back({box.high[0] - box.low[0], box.high[1] - box.low[1], 0, 0});
    m_total += m_boxes.back().width * m_boxes.back().height;
  }

  // Moves all charts into the unit square.
  std::vector<std::vector<Plane_point>> pack()
  {
    m_gap = 0.02 * std::sqrt(m_total / static_cast<double>(m_boxes.size()));
    m_order.resize(m_boxes.size());
    std::iota(m_order.begin(), m_order.end(), std::size_t(0));
    std::stable_sort(m_order.begin(), m_order.end(),
                     [&](std::size_t a, std::size_t b) { return m_boxes[a].height > m_boxes[b].height; });
    const double size = stack(best_width());
    for (std::size_t i = 0; i < m_boxes.size(); ++i)
      for (Plane_point& p : m_placed[i])
      {
        p = {std::min((p[0] + m_boxes[i].x) / size, 1.), std::min((p[1] + m_boxes[i].y) / size, 1.)};
      }
    return std::move(m_placed);
  }

private:
  struct Box
  {
    double width, height, x, y;
  };

  // The image of a chart with the area it has on the surface.
  static std::vector<Plane_point> scale_to_area(const Chart& chart, bool is_turned)
  {
    const double image = area_of(*chart.triangles, chart.at);
    const double scale = image > 0 && chart.area > 0 ? std::sqrt(chart.area / image) : 1;
    const Plane_point d = is_turned ? longer_side_of_smallest_rectangle(chart.at) : Plane_point{1, 0};
    std::vector<Plane_point> turned;
    for (const Plane_point& p : chart.at) { turned.push_back({scale * dot(p, d), scale * cross(d, p)}); }
    return turned;
  }

  // The width of the shelves is that of several which gives the smallest square.
  double best_width()
  {
    double widest = 0, best = 0, least = std::numeric_limits<double>::infinity();
    for (const Box& box : m_boxes) { widest = std::max(widest, box.width); }
    for (double factor = 1; factor < 2; factor += 0.05)
    {
      const double width = std::max(widest, factor * std::sqrt(m_total)), size = stack(width);
      if (size < least)
      {
        least = size;
        best = width;
      }
    }
    return best;
  }

  // Puts the boxes on shelves of some width, the highest first. Returns the size of the square around them.
  double stack(double width)
  {
    double x = 0, y = 0, shelf = 0, right = 0;
    for (std::size_t i : m_order)
    {
      Box& box = m_boxes[i];
      if (x > 0 && x + box.width > width)
      {
        x = 0;
        y += shelf + m_gap;
        shelf = 0;
      }
      box.x = x;
      box.y = y;
      x += box.width + m_gap;
      shelf = std::max(shelf, box.height);
      right = std::max(right, x - m_gap);
    }
    return std::max(right, y + shelf);
  }

  std::vector<std::vector<Plane_point>> m_placed;
  std::vector<Box> m_boxes;
  std::vector<std::size_t> m_order; // from the highest box to the lowest
  double m_total = 0, m_gap = 0;
};

// The images of charts, side by side in the unit square. Some charts are turned upright.
std::vector<std::vector<Plane_point>> lay_out_charts(const std::vector<Chart>& charts,
                                                     const std::vector<char>& is_turned)
{
  Chart_packer packer;
  for (std::size_t c = 0; c < charts.size(); ++c) { packer.add(charts[c], is_turned[c] != 0); }
  return packer.pack();
}

} // namespace

void pack_charts(std::vector<Chart>& charts)
{
  std::vector<char> is_turned(charts.size(), 1);
  auto placed = lay_out_charts(charts, is_turned);
  for (std::size_t i = 0; i < charts.size(); ++i)
    is_turned[i] = find_flipped_faces(*charts[i].triangles, placed[i]).size()
                   <= find_flipped_faces(*charts[i].triangles, charts[i].at).size();
  if (std::count(is_turned.begin(), is_turned.end(), 0) > 0) { placed = lay_out_charts(charts, is_turned); }
  for (std::size_t i = 0; i < charts.size(); ++i) { charts[i].at = std::move(placed[i]); }
}

} // namespace meridian
