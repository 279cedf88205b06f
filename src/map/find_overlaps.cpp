// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/map/find_overlaps.h>

#include <meridian/base/Bounding_box.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tuple>

namespace meridian {

namespace {

// A point of the grid that a face covers.
struct Sample
{
  std::int64_t x, y;
  Index face;
  bool is_at(const Sample& s) const { return x == s.x && y == s.y; }
  bool operator<(const Sample& s) const { return std::tie(x, y, face) < std::tie(s.x, s.y, s.face); }
};

// Appends the points of a grid, `step` apart, that a triangle covers, row by row.
void add_samples(const std::array<Plane_point, 3>& t, Index face, double step, std::vector<Sample>& samples)
{
  const auto first_from = [&](double x) { return static_cast<std::int64_t>(std::ceil(x / step)); };
  const double top = std::max({t[0][1], t[1][1], t[2][1]});
  for (std::int64_t y = first_from(std::min({t[0][1], t[1][1], t[2][1]})); static_cast<double>(y) * step < top; ++y)
  {
    const double height = static_cast<double>(y) * step;
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Plane_point &a = t[k], &b = t[(k + 1) % 3];
      if ((a[1] <= height) == (b[1] <= height)) { continue; }
      const double x = a[0] + (height - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
      low = std::min(low, x);
      high = std::max(high, x);
    }
    for (std::int64_t x = first_from(low); static_cast<double>(x) * step < high; ++x)
    {
      samples.push_back({x, y, face});
    }
  }
}

} // namespace

Overlaps find_overlaps(const Triangle_surface& disc, const std::vector<Plane_point>& at, double samples)
{
  std::vector<Index> faces;
  double area = 0;
  for (Index f = 0; f < disc.number_of_faces(); ++f)
  {
    const auto& t = disc.triangles[f];
    const double twice = cross(at[t[1]] - at[t[0]], at[t[2]] - at[t[0]]);
    if (!(twice > 0)) { continue; }
    faces.push_back(f);
    area += twice / 2;
  }
  Overlaps overlaps;
  if (faces.empty()) { return overlaps; }
  Bounding_box<Plane_point> box(at[disc.triangles[faces.front()][0]]);
  for (Index f : faces)
  {
    for (Index v : disc.triangles[f]) { box.add(at[v]); }
  }
  constexpr double most_rows = 8192; // of an image that has next to no area
  const double step = std::max(std::sqrt(area / samples), norm(box.high - box.low) / most_rows);
  std::vector<Sample> covered;
  for (Index f : faces)
  {
    const auto& t = disc.triangles[f];
    add_samples({at[t[0]], at[t[1]], at[t[2]]}, f, step, covered);
  }
  std::sort(covered.begin(), covered.end());
  for (std::size_t i = 1; i < covered.size(); ++i)
  {
    if (covered[i].is_at(covered[i - 1])) { overlaps.faces.push_back({covered[i - 1].face, covered[i].face}); }
  }
  if (!covered.empty())
  {
    overlaps.part = static_cast<double>(overlaps.faces.size()) / static_cast<double>(covered.size());
  }
  return overlaps;
}

} // namespace meridian
