// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/proof/internal/verify_layout.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace meridian {

namespace verification {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact_kernel = CGAL::Exact_predicates_exact_constructions_kernel;

template <class K> typename K::Point_2 point(const Plane_point& p) { return typename K::Point_2(p[0], p[1]); }

} // namespace

// What a side covers, or a ray from a vertex; `id` is the side.
struct Layout_verifier::Box : CGAL::Box_intersection_d::Box_d<double, 2, CGAL::Box_intersection_d::ID_EXPLICIT>
{
  Box(Id of, Plane_point low, Plane_point high)
    : CGAL::Box_intersection_d::Box_d<double, 2, CGAL::Box_intersection_d::ID_EXPLICIT>(low.data(), high.data()),
      side(of)
  {}
  Id side;
};

Layout_verifier::Layout_verifier(const Result_mesh& result, const std::vector<Plane_point>& texture, Joined joined)
  : m_result(result), m_texture(texture)
{
  const Id faces = static_cast<Id>(result.faces.size());
  Union_find pieces(result.faces.size());
  for_each_edge(
    3 * faces, static_cast<Id>(result.points.size()),
    [&](Id s) { return std::make_pair(vertex(s), vertex(next_side(s))); },
    [&](const auto first, const auto last) {
      if (last - first == 1) { m_border.push_back(*first); }
      else { pieces.join(*first / 3, *(first + 1) / 3); }
    });
  std::vector<Id> first(joined == Joined::AT_VERTICES ? result.points.size() : 0, -1);
  for (Id s = 0; s < 3 * faces && joined == Joined::AT_VERTICES; ++s)
  {
    Id& f = first[vertex(s)];
    if (f < 0) { f = s / 3; }
    pieces.join(f, s / 3);
  }
  for (Id f = 0; f < faces; ++f) { m_piece.push_back(pieces.find(f)); }
}

std::vector<Layout_verifier::Box> Layout_verifier::boxes(const Plane_point& margin) const
{
  std::vector<Box> all;
  for (Id s : m_border)
  {
    const Plane_point &a = at(s), &b = at(next_side(s));
    all.emplace_back(s, Plane_point{std::min(a[0], b[0]), std::min(a[1], b[1])} - margin,
                     Plane_point{std::max(a[0], b[0]), std::max(a[1], b[1])} + margin);
  }
  return all;
}

bool Layout_verifier::meet(Id a, Id b) const
{
  const auto a0 = point<Kernel>(at(a)), a1 = point<Kernel>(at(next_side(a))), b0 = point<Kernel>(at(b)),
             b1 = point<Kernel>(at(next_side(b)));
  // If two sides lie on each other from a vertex that both have, the end of the shorter lies on the longer, and so does
  // the side that goes on from there.
  if (vertex(a) == vertex(next_side(b)) || vertex(b) == vertex(next_side(a))) { return false; }
  return CGAL::do_intersect(Kernel::Segment_2(a0, a1), Kernel::Segment_2(b0, b1));
}

std::vector<Id> Layout_verifier::find_meeting() const
{
  std::vector<Box> all = boxes({0, 0});
  std::vector<Id> meeting;
  CGAL::box_self_intersection_d(all.begin(), all.end(), [&](const Box& a, const Box& b) {
    if (meet(a.side, b.side)) { meeting.insert(meeting.end(), {a.side / 3, b.side / 3}); }
  });
  return meeting;
}

std::vector<Id> Layout_verifier::find_inside() const
{
  std::vector<Box> all = boxes({0, 0}), rays; // to the right, one from each piece
  std::vector<char> has_ray(m_piece.size(), 0);
  double far = 0;
  for (const Plane_point& p : m_texture) { far = std::max(far, p[0] + 1); }
  for (Id s : m_border)
  {
    if (std::exchange(has_ray[m_piece[s / 3]], 1)) { continue; }
    rays.emplace_back(s, at(s), Plane_point{far, at(s)[1]});
  }
  std::vector<int> around(m_piece.size(), 0); // how often borders of other pieces go round the one of a first face
  CGAL::box_intersection_d(rays.begin(), rays.end(), all.begin(), all.end(), [&](const Box& ray, const Box& box) {
    const Id piece = m_piece[ray.side / 3];
    if (piece == m_piece[box.side / 3]) { return; }
    const Plane_point &p = at(ray.side), &a = at(box.side), &b = at(next_side(box.side));
    const bool goes_up = a[1] <= p[1] && p[1] < b[1], goes_down = b[1] <= p[1] && p[1] < a[1];
    if (!goes_up && !goes_down) { return; }
    const auto side = CGAL::orientation(point<Kernel>(a), point<Kernel>(b), point<Kernel>(p));
    if (side == (goes_up ? CGAL::LEFT_TURN : CGAL::RIGHT_TURN)) { around[piece] += goes_up ? 1 : -1; }
  });
  std::vector<Id> inside;
  for (std::size_t f = 0; f < around.size(); ++f)
  {
    if (around[f] != 0) { inside.push_back(static_cast<Id>(f)); }
  }
  return inside;
}

bool Layout_verifier::are_nearer(Id a, Id b, const Padding& padding) const
{
  const auto squared = [&](auto kernel) {
    using K = decltype(kernel);
    const auto in_texels = [&](Id side) {
      const Plane_point& p = at(side);
      return typename K::Point_2(typename K::FT(p[0]) * padding.width, typename K::FT(p[1]) * padding.height);
    };
    return CGAL::squared_distance(typename K::Segment_2(in_texels(a), in_texels(next_side(a))),
                                  typename K::Segment_2(in_texels(b), in_texels(next_side(b))));
  };
  constexpr double rounding = 1e-6;
  const double about = squared(Kernel()), bound = padding.texels * padding.texels;
  if (about < (1 - rounding) * bound) { return true; }
  if (about > (1 + rounding) * bound) { return false; }
  const Exact_kernel::FT exact(padding.texels);
  return squared(Exact_kernel()) < exact * exact;
}

std::array<double, 2> Layout_verifier::tile_of(Id s) const
{
  const Plane_point &a = at(s), &b = at(next_side(s));
  return {std::floor(std::min(a[0], b[0])), std::floor(std::min(a[1], b[1]))};
}

std::vector<Layout_verifier::Way> Layout_verifier::ways_along_borders(const Padding& padding) const
{
  std::vector<Id> from(m_texture.size(), -1); // the side on the border that begins at a vertex
  for (Id s : m_border) { from[vertex(s)] = s; }
  std::vector<Way> ways(3 * m_result.faces.size());
  std::vector<char> is_done(ways.size(), 0);
  for (Id first : m_border)
  {
    if (is_done[first]) { continue; }
    std::vector<Id> loop;
    double whole = 0;
    for (Id s = first; s >= 0 && !std::exchange(is_done[s], 1); s = from[vertex(next_side(s))])
    {
      const Plane_point along = at(next_side(s)) - at(s);
      ways[s].before = whole;
      ways[s].length = std::hypot(along[0] * padding.width, along[1] * padding.height);
      whole += ways[s].length;
      loop.push_back(s);
    }
    for (Id s : loop) { ways[s].whole = whole; }
  }
  return ways;
}

bool Layout_verifier::is_outside_of(Id side, Id other) const
{
  const auto is_right = [&](Id end) {
    return CGAL::orientation(point<Kernel>(at(side)), point<Kernel>(at(next_side(side))), point<Kernel>(at(end)))
           == CGAL::RIGHT_TURN;
  };
  return is_right(other) || is_right(next_side(other));
}

std::vector<Id> Layout_verifier::find_near_itself(const Padding& padding) const
{
  constexpr double paddings = 8;
  const std::vector<Way> ways = ways_along_borders(padding);
  const auto is_far_along = [&](Id a, Id b) {
    const Way &first = ways[a].before < ways[b].before ? ways[a] : ways[b],
              &last = ways[a].before < ways[b].before ? ways[b] : ways[a];
    const double between = last.before - first.before - first.length,
                 around = first.whole - last.before - last.length + first.before;
    return std::min(between, around) >= paddings * padding.texels;
  };
  std::vector<Box> all = boxes({padding.texels / padding.width / 2, padding.texels / padding.height / 2});
  std::vector<Id> near;
  CGAL::box_self_intersection_d(all.begin(), all.end(), [&](const Box& a, const Box& b) {
    if (m_piece[a.side / 3] == m_piece[b.side / 3] && is_far_along(a.side, b.side) && is_outside_of(a.side, b.side)
        && is_outside_of(b.side, a.side) && are_nearer(a.side, b.side, padding))
    {
      near.insert(near.end(), {a.side / 3, b.side / 3});
    }
  });
  return near;
}

std::vector<Id> Layout_verifier::find_near(const Padding& padding) const
{
  std::vector<Box> all = boxes({padding.texels / padding.width / 2, padding.texels / padding.height / 2});
  std::vector<Id> near;
  CGAL::box_self_intersection_d(all.begin(), all.end(), [&](const Box& a, const Box& b) {
    const bool are_apart = m_piece[a.side / 3] != m_piece[b.side / 3] && tile_of(a.side) == tile_of(b.side);
    if (are_apart && are_nearer(a.side, b.side, padding)) { near.insert(near.end(), {a.side / 3, b.side / 3}); }
  });
  return near;
}

} // namespace verification

} // namespace meridian
