// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/unwrap/measure_round_trip.h>

#include <meridian/base/Bounding_box.h>
#include <meridian/base/exceptions.h>
#include <meridian/base/vectors.h>
#include <meridian/surface/Triangle_tree.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace meridian {

namespace {

// Calls f(p) for `count` points that lie evenly by area. The order of the faces and the fractional parts of multiples
// of the plastic number's powers place them; nothing is drawn at random.
template <class Function> void for_each_sample(const Triangle_surface& s, std::size_t count, const Function& f)
{
  std::vector<double> area;
  double whole = 0;
  for (const auto& t : s.triangles)
    area.push_back(whole += norm(cross(s.points[t[1]] - s.points[t[0]], s.points[t[2]] - s.points[t[0]])) / 2);
  if (!(whole > 0)) { return; }
  std::size_t face = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double up_to = whole * ((static_cast<double>(i) + 0.5) / static_cast<double>(count));
    while (face + 1 < area.size() && area[face] < up_to) { ++face; }
    double u = std::fmod(0.5 + 0.7548776662466927 * static_cast<double>(i), 1.),
           v = std::fmod(0.5 + 0.5698402909980532 * static_cast<double>(i), 1.);
    if (u + v > 1)
    {
      u = 1 - u;
      v = 1 - v;
    }
    const auto& t = s.triangles[face];
    f(s.points[t[0]] + u * (s.points[t[1]] - s.points[t[0]]) + v * (s.points[t[2]] - s.points[t[0]]));
  }
}

Sampled_distance measure_distance(const Triangle_surface& from, const Triangle_surface& to, std::size_t count)
{
  Triangle_tree tree(to);
  if (tree.empty()) { throw Invalid_input_error("distances cannot be measured to a surface without area"); }
  tree.accelerate_distances();
  double largest = 0, sum = 0;
  std::size_t samples = 0;
  const auto squared = [&](const Point& p) {
    const double d = tree.squared_distance(p);
    largest = std::max(largest, d);
    return d;
  };
  for_each_sample(from, count, [&](const Point& p) {
    sum += squared(p);
    ++samples;
  });
  for (Index v = 0; v < from.number_of_vertices(); ++v)
  {
    if (from.outgoing[v] >= 0) { squared(from.points[v]); }
  }
  return {std::sqrt(largest), samples > 0 ? std::sqrt(sum / static_cast<double>(samples)) : 0};
}

} // namespace

Round_trip measure_round_trip(const Triangle_surface& original, const Triangle_surface& remeshed,
                              std::size_t least_samples)
{
  const std::size_t count = std::max(least_samples, std::max(original.triangles.size(), remeshed.triangles.size()));
  Round_trip result;
  result.there = measure_distance(original, remeshed, count);
  result.back = measure_distance(remeshed, original, count);
  result.hausdorff = std::max(result.there.largest, result.back.largest);
  result.rms = std::max(result.there.rms, result.back.rms);
  Bounding_box<Point> box(original.points.front());
  for (const Point& p : original.points) { box.add(p); }
  result.diagonal = distance(box.low, box.high);
  result.psnr =
    result.rms > 0 ? 20 * std::log10(result.diagonal / result.rms) : std::numeric_limits<double>::infinity();
  return result;
}

} // namespace meridian
