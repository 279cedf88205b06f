// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/unwrap/carry_map.h>

#include <meridian/map/is_one_to_one.h>
#include <meridian/map/planar_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace meridian {

namespace internal {

namespace {

// The vertex of the cut surface that a vertex of its disc is a copy of.
Index original(const Cut& cut, Index v)
{
  const Index n = cut.surface.number_of_vertices();
  return v < n ? v : cut.opened.copy_of[v - n];
}

// A point of a face's plane near one of its sides, as a place along that side.
Plane_point place_on_side(const Cut& before, const std::vector<Plane_point>& at, Index face, const Point& p)
{
  const auto& corners = before.opened.triangles[face];
  double nearest = std::numeric_limits<double>::infinity();
  Plane_point place{0, 0};
  for (int k = 0; k < 3; ++k)
  {
    std::array<Index, 2> ends{corners[k], corners[(k + 1) % 3]}; // in the same order in both faces of a side
    if (original(before, ends[1]) < original(before, ends[0])) { std::swap(ends[0], ends[1]); }
    const Point from = before.surface.points[original(before, ends[0])],
                along = before.surface.points[original(before, ends[1])] - from;
    const double square = dot(along, along), t = square > 0 ? std::clamp(dot(p - from, along) / square, 0., 1.) : 0.5;
    const double away = distance(p, from + t * along);
    if (!(away < nearest)) { continue; }
    nearest = away;
    place = (1 - t) * at[ends[0]] + t * at[ends[1]];
  }
  return place;
}

// Moves a vertex of the border along the bisector of its angle, `part` of the shortest edge there at most, as far as
// all faces around it stay upright. `drawn`: where all were before any moved.
void move_inside(const Triangle_surface& disc, Index in, Index out, const std::vector<Plane_point>& drawn, double part,
                 std::vector<Plane_point>& at)
{
  const Index v = disc.source(out);
  const Plane_point on = drawn[disc.target(out)] - drawn[v], back = drawn[disc.source(in)] - drawn[v];
  double angle = std::atan2(cross(on, back), dot(on, back));
  if (!(angle > 0)) { angle += 2 * std::acos(-1.); }
  double shortest = std::min(norm(on), norm(back));
  disc.for_each_outgoing(v, [&](Index h) { shortest = std::min(shortest, norm(drawn[disc.target(h)] - drawn[v])); });
  const double x = std::cos(angle / 2), y = std::sin(angle / 2), size = norm(on);
  if (!(size > 0)) { return; }
  const Plane_point along{(x * on[0] - y * on[1]) / size, (y * on[0] + x * on[1]) / size};
  for (int tries = 0; tries < 40; ++tries, part /= 2)
  {
    at[v] = drawn[v] + (part * shortest) * along;
    bool is_upright = true;
    disc.for_each_outgoing(v, [&](Index h) {
      const auto& t = disc.triangles[disc.face(h)];
      is_upright = is_upright && orientation_of(at[t[0]], at[t[1]], at[t[2]]) > 0;
    });
    if (is_upright) { return; }
  }
  at[v] = drawn[v];
}

} // namespace

std::vector<Plane_point> draw_curves(const Cut& before, const std::vector<Plane_point>& at, const Cut& after,
                                     const std::vector<Index>& parents)
{
  const Index old_faces = before.surface.number_of_faces(), old_vertices = before.surface.number_of_vertices();
  std::vector<Plane_point> drawn(after.surface.number_of_vertices() + after.opened.copy_of.size(), {0, 0});
  for (Index f = 0; f < after.surface.number_of_faces(); ++f)
  {
    Index parent = f;
    while (parent >= old_faces) { parent = parents[parent - old_faces]; }
    for (Index v : after.opened.triangles[f])
    {
      const Index w = original(after, v);
      const auto& corners = before.opened.triangles[parent];
      const auto corner =
        std::find_if(corners.begin(), corners.end(), [&](Index u) { return original(before, u) == w; });
      drawn[v] = w < old_vertices && corner != corners.end()
                   ? at[*corner]
                   : place_on_side(before, at, parent, after.surface.points[w]);
    }
  }
  return drawn;
}

} // namespace internal

std::vector<Plane_point> carry_map(const Cut& before, const std::vector<Plane_point>& at, const Cut& after,
                                   const Triangle_surface& disc, const std::vector<Index>& parents)
{
  const std::vector<Plane_point> drawn = internal::draw_curves(before, at, after, parents);
  const std::vector<Index> loop = boundary_loops(disc).front();
  std::vector<Index> copies(after.surface.number_of_vertices(), 0); // of each vertex of a new path
  std::vector<char> is_new(after.surface.number_of_vertices(), 0);
  for (std::size_t c = before.curves.size(); c < after.curves.size(); ++c)
  {
    for (Index v : after.curves[c].vertices) { is_new[v] = 1; }
  }
  for (Index h : loop) { ++copies[internal::original(after, disc.source(h))]; }
  for (double part = 0.25; part > 1e-6; part /= 16)
  {
    std::vector<Plane_point> moved = drawn;
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      const Index v = internal::original(after, disc.source(loop[i]));
      if (!is_new[v] || copies[v] < 2) { continue; }
      internal::move_inside(disc, loop[(i + loop.size() - 1) % loop.size()], loop[i], drawn, part, moved);
    }
    if (is_one_to_one(disc, moved)) { return moved; }
  }
  return {};
}

} // namespace meridian
