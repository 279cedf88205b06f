// SPDX-License-Identifier: GPL-3.0-or-later
#include "pins.h"

#include "field_arguments.h"

#include <meridian/map/pack_charts.h>
#include <meridian/surface/examine_surface.h>

#include <algorithm>
#include <set>
#include <sstream>

namespace meridian {
namespace program {

namespace {

// Calls `visit(component, vertex of it, pin)` for each pin whose vertex lies on one.
template <class Visit> void for_each_pin(const Unwrap_run& run, const Visit& visit)
{
  const auto& components = run.loaded.examination.components;
  for (const files::Pin& pin : run.pins)
    for (std::size_t i = 0; i < components.size(); ++i)
    {
      const Index v = find_local(pin.vertex, components[i]);
      if (v >= 0) { visit(i, v, pin); }
    }
}

// Whether a vertex of a surface has more than one place in the texture.
bool is_doubled(const Cut& cut, Index v)
{
  const std::vector<Index>& copies = cut.opened.copy_of;
  return std::find(copies.begin(), copies.end(), v) != copies.end();
}

} // namespace

void keep_out_of_pins(Unwrap_run& run)
{
  for_each_pin(run, [&](std::size_t i, Index v, const files::Pin&) {
    const Triangle_surface& s = run.loaded.examination.components[i].surface;
    s.for_each_outgoing(v, [&](Index h) { run.options[i].keep_out.push_back(s.face(h)); });
  });
  for (Unwrap_options& o : run.options)
  {
    std::sort(o.keep_out.begin(), o.keep_out.end());
    o.keep_out.erase(std::unique(o.keep_out.begin(), o.keep_out.end()), o.keep_out.end());
  }
}

std::vector<Texture_pin> texture_pins(const std::vector<Unwrap_run>& runs)
{
  std::vector<Texture_pin> pins;
  std::size_t first = 0;
  for (const Unwrap_run& run : runs)
  {
    for_each_pin(run, [&](std::size_t i, Index v, const files::Pin& pin) {
      if (!is_doubled(run.result.cuts[i], v)) { pins.push_back({first + i, v, pin.at}); }
    });
    first += run.loaded.examination.components.size();
  }
  return pins;
}

std::vector<std::string> missed_pins(const Unwrap_run& run)
{
  std::vector<std::string> missed;
  std::size_t away = 0;
  std::set<Index> pinned;
  double farthest = 0;
  for_each_pin(run, [&](std::size_t i, Index v, const files::Pin& pin) {
    pinned.insert(pin.vertex);
    if (is_doubled(run.result.cuts[i], v))
    {
      missed.push_back("vertex " + std::to_string(pin.vertex) + " lies on a seam, and has no one place");
      return;
    }
    const Plane_point from = run.unwrapped[i].map.at[v] - pin.at;
    const auto [width, height] = run.arguments.packing.resolution;
    const double texels = norm(Plane_point{from[0] * width, from[1] * height});
    away += texels > 0;
    farthest = std::max(farthest, texels);
  });
  if (away > 0)
  {
    std::ostringstream line;
    line << away << " of " << run.pins.size() << " pinned vertices are not where they should be, the farthest by "
         << farthest << " texels; fewer pins, or places like those on the surface, would help";
    missed.push_back(line.str());
  }
  if (pinned.size() < run.pins.size())
  {
    missed.push_back(std::to_string(run.pins.size() - pinned.size()) + " pinned vertices have no faces");
  }
  return missed;
}

} // namespace program
} // namespace meridian
