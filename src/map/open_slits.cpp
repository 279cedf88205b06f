// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/map/open_slits.h>

#include <meridian/map/internal/distortion_energy.h>
#include <meridian/map/planar_map.h>
#include <meridian/surface/shortest_ways.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace meridian {

namespace internal {

namespace {

// The nearest points of two segments.
struct Nearest_points
{
  double on_first = 0, on_second = 0; // from 0 to 1
  double distance = 0;
  Plane_point away{0, 0}; // from the first to the second
};

class Slit_opener
{
public:
  Slit_opener(const Triangle_surface& disc, std::vector<Plane_point>& at, double gap)
    : m_disc(disc), m_at(at), m_gap(gap)
  {
    const auto loops = boundary_loops(disc);
    for (Index h : loops.front()) { m_loop.push_back(disc.source(h)); }
    m_loop.push_back(m_loop.front());
    for (const auto& t : disc.triangles)
    {
      const Plane_point e = at[t[1]] - at[t[0]], d = at[t[2]] - at[t[0]];
      const double b = norm(e);
      m_faces.push_back(make_rest_triangle(t, b, dot(e, d) / b, cross(e, d) / b));
    }
  }

  Opened_slits run()
  {
    constexpr int rounds = 40, patience = 4;
    constexpr double gain = 0.03; // of the sides that are left
    Opened_slits sides;
    std::vector<Plane_point> best = m_at;
    std::size_t least = 0, goal = 0;
    for (int i = 0, in_vain = 0; i < rounds && in_vain < patience; ++i, ++in_vain)
    {
      const std::size_t near = find_pushes();
      if (i == 0) { sides.before = least = goal = near; }
      if (near < least)
      {
        least = near;
        best = m_at;
      }
      if (near <= goal)
      {
        goal = static_cast<std::size_t>((1 - gain) * static_cast<double>(near));
        in_vain = 0;
      }
      if (near == 0 || i + 1 == rounds || !push()) { break; }
    }
    m_at = std::move(best);
    sides.after = least;
    return sides;
  }

private:
  struct Box
  {
    Plane_point low, high;
    std::size_t side; // the place of its first vertex in the loop
  };

  const Plane_point& at(std::size_t place) const { return m_at[m_loop[place]]; }
  std::size_t number_of_sides() const { return m_loop.size() - 1; }

  // Calls `visit` for each two sides whose boxes, with a margin around them, meet: a sweep to the right in each of some
  // strips, which is faster here than a tree of boxes, since sides are short.
  template <class Visit>
  void for_each_close_pair(const std::vector<Plane_point>& points, double margin, const Visit& visit) const
  {
    const std::size_t n = number_of_sides();
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < n; ++i)
    {
      const Plane_point &a = points[m_loop[i]], &b = points[m_loop[i + 1]];
      boxes.push_back({{std::min(a[0], b[0]) - margin, std::min(a[1], b[1]) - margin},
                       {std::max(a[0], b[0]) + margin, std::max(a[1], b[1]) + margin},
                       i});
    }
    std::sort(boxes.begin(), boxes.end(),
              [](const Box& a, const Box& b) { return std::tie(a.low, a.side) < std::tie(b.low, b.side); });
    double low = boxes.front().low[1], high = boxes.front().high[1];
    for (const Box& b : boxes)
    {
      low = std::min(low, b.low[1]);
      high = std::max(high, b.high[1]);
    }
    const double count = std::ceil(std::sqrt(static_cast<double>(n)));
    const auto strip_of = [&](double y) {
      return static_cast<std::size_t>(high > low ? std::min((y - low) / (high - low) * count, count - 1) : 0);
    };
    std::vector<std::vector<std::size_t>> strips(static_cast<std::size_t>(count)); // of boxes, from left to right
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t k = strip_of(boxes[i].low[1]); k <= strip_of(boxes[i].high[1]); ++k) { strips[k].push_back(i); }
    for (std::size_t k = 0; k < strips.size(); ++k)
      for (std::size_t i = 0; i < strips[k].size(); ++i)
        for (std::size_t j = i + 1; j < strips[k].size(); ++j)
        {
          const Box &a = boxes[strips[k][i]], &b = boxes[strips[k][j]];
          if (b.low[0] > a.high[0]) { break; }
          const double bottom = std::max(a.low[1], b.low[1]);
          if (bottom <= std::min(a.high[1], b.high[1]) && strip_of(bottom) == k) { visit(a.side, b.side); }
        }
  }

  // Notes how vertices of the border should move. Returns how many sides are too near to others.
  std::size_t find_pushes()
  {
    const std::size_t n = number_of_sides();
    m_along.assign(1, 0);
    for (std::size_t i = 0; i < n; ++i) { m_along.push_back(m_along.back() + norm(at(i + 1) - at(i))); }
    m_push.assign(m_at.size(), {0, 0});
    std::vector<char> is_near(n, 0);
    for_each_close_pair(m_at, m_gap / 2, [&](std::size_t a, std::size_t b) {
      if (are_neighbors(a, b) || !face_each_other(a, b)) { return; }
      const Nearest_points near = nearest_points(a, b);
      if (!(near.distance < m_gap)) { return; }
      is_near[a] = is_near[b] = 1;
      note(a, near.on_first, near, -1);
      note(b, near.on_second, near, 1);
    });
    return static_cast<std::size_t>(std::count(is_near.begin(), is_near.end(), 1));
  }

  // Whether the way between two sides along the border is short.
  bool are_neighbors(std::size_t a, std::size_t b) const
  {
    constexpr double gaps = 8;
    const auto [first, last] = std::minmax(a, b);
    const double between = m_along[last] - m_along[first + 1],
                 around = m_along.back() - m_along[last + 1] + m_along[first];
    return std::min(between, around) < gaps * m_gap;
  }

  // Whether each has an end on the outer side of the other, its right.
  bool face_each_other(std::size_t a, std::size_t b) const
  {
    const auto is_outside = [&](std::size_t side, std::size_t other) {
      const auto is_right = [&](std::size_t i) { return orientation_of(at(side), at(side + 1), at(i)) < 0; };
      return is_right(other) || is_right(other + 1);
    };
    return is_outside(a, b) && is_outside(b, a);
  }

  // For segments that do not meet: an end of one is nearest.
  Nearest_points nearest_points(std::size_t a, std::size_t b) const
  {
    Nearest_points best;
    best.distance = std::numeric_limits<double>::infinity();
    const auto try_end = [&](std::size_t end, std::size_t side, bool is_of_first) {
      const Plane_point along = at(side + 1) - at(side), p = at(end) - at(side);
      const double square = dot(along, along), t = square > 0 ? std::clamp(dot(p, along) / square, 0., 1.) : 0;
      const Plane_point to = at(side) + t * along - at(end);
      if (!(norm(to) < best.distance)) { return; }
      const double end_at = end == (is_of_first ? a : b) ? 0 : 1;
      best = is_of_first ? Nearest_points{end_at, t, norm(to), to} : Nearest_points{t, end_at, norm(to), -1. * to};
    };
    for (std::size_t k = 0; k < 2; ++k)
    {
      try_end(a + k, b, true);
      try_end(b + k, a, false);
    }
    return best;
  }

  // Lets a side move by half of what is missing, in the direction to the other side or against it.
  void note(std::size_t side, double on_side, const Nearest_points& near, double sign)
  {
    constexpr double more = 1.05; // than is needed, so that it is enough
    const Plane_point along = at(side + 1) - at(side);
    const double length = norm(along);
    Plane_point direction = sign * near.away;
    // next to nothing has no direction: to the left, which is inside
    if (near.distance < 0.1 * m_gap && length > 0) { direction = {-along[1] / length, along[0] / length}; }
    else if (near.distance > 0) { direction = (1 / near.distance) * direction; }
    const double half = (more * m_gap - near.distance) / 2;
    for (std::size_t k = 0; k < 2; ++k)
    {
      const double part = half * std::min(1., 2 * (k == 0 ? 1 - on_side : on_side));
      Plane_point& push = m_push[m_loop[side + k]];
      if (part > norm(push)) { push = part * direction; }
    }
  }

  // Moves vertices, as far as no face is turned over and no sides of the border meet. Returns whether that left room
  // between them, or moves none.
  bool push()
  {
    const std::vector<Plane_point> move = spread();
    std::vector<double> part(m_at.size(), 1);
    std::vector<Plane_point> next(m_at.size());
    std::vector<std::size_t> touched;
    for (std::size_t f = 0; f < m_faces.size(); ++f)
    {
      const auto& t = m_disc.triangles[f];
      if (std::any_of(t.begin(), t.end(), [&](Index v) { return norm(move[v]) > 0; })) { touched.push_back(f); }
    }
    for (bool is_good = false; !is_good;)
    {
      is_good = true;
      for (std::size_t v = 0; v < m_at.size(); ++v) { next[v] = m_at[v] + part[v] * move[v]; }
      const auto slow_down = [&](Index v) {
        if (!(part[v] * norm(move[v]) > 0)) { return; }
        part[v] = part[v] > 0.1 ? part[v] / 2 : 0;
        is_good = false;
      };
      for (std::size_t f : touched)
      {
        if (!is_spoilt(f, next)) { continue; }
        for (Index v : m_disc.triangles[f]) { slow_down(v); }
      }
      for (std::size_t side : find_meeting(next))
      {
        slow_down(m_loop[side]);
        slow_down(m_loop[side + 1]);
      }
    }
    const std::vector<Index> loop(m_loop.begin(), m_loop.end() - 1);
    if (!is_roomy(loop, next)) { return false; }
    m_at.swap(next);
    return true;
  }

  // Sides of the border that meet others than those beside them.
  std::vector<std::size_t> find_meeting(const std::vector<Plane_point>& at) const
  {
    std::vector<std::size_t> meeting;
    const auto turn = [&](std::size_t i, std::size_t j) {
      return orientation_of(at[m_loop[i]], at[m_loop[i + 1]], at[m_loop[j]]);
    };
    for_each_close_pair(at, 0, [&](std::size_t i, std::size_t j) {
      const std::size_t n = number_of_sides();
      if ((i + 1) % n == j || (j + 1) % n == i) { return; }
      if (turn(i, j) * turn(i, j + 1) > 0 || turn(j, i) * turn(j, i + 1) > 0) { return; }
      meeting.insert(meeting.end(), {i, j});
    });
    return meeting;
  }

  // Whether a face is turned over, or stretched too much beside what it was at the beginning.
  bool is_spoilt(std::size_t f, const std::vector<Plane_point>& next) const
  {
    constexpr double most = 12; // of an energy that is 4 for what it was
    const auto& t = m_disc.triangles[f];
    return orientation_of(next[t[0]], next[t[1]], next[t[2]]) <= 0
           || !(symmetric_dirichlet_energy(gradient_of(m_faces[f], next)) < most);
  }

  // How far each vertex moves: those of the border as noted, those near them with the nearest of these.
  std::vector<Plane_point> spread() const
  {
    constexpr double gaps = 4;
    const double reach = gaps * m_gap;
    std::vector<std::pair<double, Index>> starts;
    std::vector<Index> source(m_at.size(), -1);
    for (std::size_t i = 0; i < number_of_sides(); ++i)
    {
      const Index v = m_loop[i];
      if (!(norm(m_push[v]) > 0)) { continue; }
      starts.emplace_back(0., v);
      source[v] = v;
    }
    const std::vector<double> distance =
      find_shortest_ways(m_disc.number_of_vertices(), starts, [&](Index v, const auto& try_to_reach) {
        m_disc.for_each_outgoing(v, [&](Index h) {
          const Index w = m_disc.target(h);
          const double length = norm(m_at[w] - m_at[v]);
          if (length < reach && try_to_reach(w, length)) { source[w] = source[v]; }
        });
      });
    std::vector<Plane_point> move(m_at.size(), {0, 0});
    for (std::size_t v = 0; v < m_at.size(); ++v)
    {
      if (distance[v] < reach) { move[v] = (1 - distance[v] / reach) * m_push[source[v]]; }
    }
    return move;
  }

  const Triangle_surface& m_disc;
  std::vector<Plane_point>& m_at;
  const double m_gap;
  std::vector<Rest_triangle> m_faces; // as they are at the beginning
  std::vector<Index> m_loop;          // the first vertex comes last again
  std::vector<double> m_along;        // the length of the border before each vertex of it
  std::vector<Plane_point> m_push;    // of each vertex of the surface
};

} // namespace

} // namespace internal

Opened_slits open_slits(const Triangle_surface& disc, std::vector<Plane_point>& at, double gap)
{
  return internal::Slit_opener(disc, at, gap).run();
}

} // namespace meridian
