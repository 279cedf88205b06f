// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/map/pack_charts.h>

#include <meridian/map/planar_map.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace meridian {

namespace {

// The direction in which a chart's bounding rectangle has the least area, as a unit vector. One side lies on the convex
// hull.
Plane_point upright_direction(const std::vector<Plane_point>& at)
{
  const std::vector<Plane_point> hull = convex_hull(at);
  Plane_point best{1, 0};
  double least = std::numeric_limits<double>::infinity();
  const std::size_t n = hull.size(), stride = n / 256 + 1; // a round chart has many sides that are all alike
  for (std::size_t i = 0; i < n; i += stride)
  {
    const Plane_point side = hull[(i + 1) % n] - hull[i];
    const double length = norm(side);
    if (!(length > 0)) { continue; }
    const Plane_point d = (1 / length) * side;
    std::array<double, 2> low{0, 0}, high{0, 0};
    for (const Plane_point& q : hull)
    {
      const Plane_point p = q - hull[i];
      const std::array<double, 2> turned{dot(p, d), cross(d, p)};
      for (int k = 0; k < 2; ++k)
      {
        low[k] = std::min(low[k], turned[k]);
        high[k] = std::max(high[k], turned[k]);
      }
    }
    const double area = (high[0] - low[0]) * (high[1] - low[1]);
    if (!(area < least)) { continue; }
    least = area;
    best = high[0] - low[0] < high[1] - low[1] ? Plane_point{d[1], -d[0]} : d; // lying rather than standing
  }
  return best;
}

// The images of charts, side by side in the unit square. Some charts are turned upright.
std::vector<std::vector<Plane_point>> lay_out_charts(const std::vector<Chart>& charts,
                                                     const std::vector<char>& is_turned)
{
  struct Box
  {
    double width, height, x, y;
  };
  std::vector<Box> boxes;
  std::vector<std::vector<Plane_point>> placed;
  double total = 0;
  for (std::size_t c = 0; c < charts.size(); ++c)
  {
    const Chart& chart = charts[c];
    const double image = area_of(*chart.triangles, chart.at);
    const double scale = image > 0 && chart.area > 0 ? std::sqrt(chart.area / image) : 1;
    const Plane_point d = is_turned[c] ? upright_direction(chart.at) : Plane_point{1, 0};
    std::vector<Plane_point> turned;
    for (const Plane_point& p : chart.at) { turned.push_back({scale * dot(p, d), scale * cross(d, p)}); }
    Plane_point low = turned.front(), high = low;
    for (const Plane_point& p : turned)
      for (int k = 0; k < 2; ++k)
      {
        low[k] = std::min(low[k], p[k]);
        high[k] = std::max(high[k], p[k]);
      }
    for (Plane_point& p : turned) { p = p - low; }
    placed.push_back(std::move(turned));
    boxes.push_back({high[0] - low[0], high[1] - low[1], 0, 0});
    total += boxes.back().width * boxes.back().height;
  }
  const double gap = 0.02 * std::sqrt(total / static_cast<double>(charts.size()));
  std::vector<std::size_t> order(charts.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return boxes[a].height > boxes[b].height; });

  // The width of the shelves is that of several which gives the smallest square.
  const auto stack = [&](double width) {
    double x = 0, y = 0, shelf = 0, right = 0;
    for (std::size_t i : order)
    {
      if (x > 0 && x + boxes[i].width > width)
      {
        x = 0;
        y += shelf + gap;
        shelf = 0;
      }
      boxes[i].x = x;
      boxes[i].y = y;
      x += boxes[i].width + gap;
      shelf = std::max(shelf, boxes[i].height);
      right = std::max(right, x - gap);
    }
    return std::max(right, y + shelf);
  };
  double widest = 0, best = 0, least = std::numeric_limits<double>::infinity();
  for (const Box& box : boxes) { widest = std::max(widest, box.width); }
  for (double factor = 1; factor < 2; factor += 0.05)
  {
    const double width = std::max(widest, factor * std::sqrt(total)), size = stack(width);
    if (size < least)
    {
      least = size;
      best = width;
    }
  }
  const double size = stack(best);
  for (std::size_t i = 0; i < charts.size(); ++i)
    for (Plane_point& p : placed[i])
    {
      p = {std::min((p[0] + boxes[i].x) / size, 1.), std::min((p[1] + boxes[i].y) / size, 1.)};
    }
  return placed;
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
