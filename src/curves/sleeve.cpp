// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/curves/sleeve.h>

#include <cmath>

namespace meridian {

namespace internal {

void trim(const Triangle_surface& s, Sleeve& sleeve)
{
  auto& h = sleeve.halfedges;
  std::size_t first = 0, last = h.size();
  while (first < last && touches(s, h[first], sleeve.start)) { ++first; }
  while (first < last && touches(s, h[last - 1], sleeve.end)) { --last; }
  h = {h.begin() + first, h.begin() + last};
}

Pulled_path pull(const Triangle_surface& s, const Sleeve& sleeve)
{
  Pulled_path path;
  const std::size_t n = sleeve.halfedges.size();
  // The third corner of a triangle whose side runs from a to b (both known), to the left or to the right of it.
  const auto third = [&](Index va, Index vb, Index vc, const Point_2& a, const Point_2& b, double side) -> Point_2 {
    const Point ab = s.points[vb] - s.points[va], ac = s.points[vc] - s.points[va];
    const double l = norm(ab);
    if (!(l > 0)) { return {a[0], a[1] + side * norm(ac)}; }
    const double x = dot(ab, ac) / l, y = side * norm(cross(ab, ac)) / l;
    const Point_2 u{(b[0] - a[0]) / l, (b[1] - a[1]) / l};
    return {a[0] + x * u[0] - y * u[1], a[1] + x * u[1] + y * u[0]};
  };
  const Index h0 = sleeve.halfedges.front();
  // a closed sleeve comes to a vertex again; that is another end
  std::vector<std::size_t> first_left{0}, first_right{0};
  path.right.push_back({0, 0});
  path.left.push_back({s.length(h0), 0});
  const Point_2 start = third(s.source(h0), s.target(h0), sleeve.start, path.right[0], path.left[0], 1);
  Point_2 end{0, 0};
  for (std::size_t i = 0; i < n; ++i)
  {
    const Index h = sleeve.halfedges[i], o = s.opposite[h];
    const Point_2 c = third(s.source(h), s.target(h), s.apex(o), path.right[i], path.left[i], -1);
    if (i + 1 == n)
    {
      end = c;
      break;
    }
    const bool moves_left = sleeve.halfedges[i + 1] == s.next(o); // the new portal keeps the right end
    path.right.push_back(moves_left ? path.right[i] : c);
    path.left.push_back(moves_left ? c : path.left[i]);
    first_right.push_back(moves_left ? first_right[i] : i + 1);
    first_left.push_back(moves_left ? i + 1 : first_left[i]);
  }

  using Corner = Pulled_path::Corner;
  const auto left_of = [&](std::size_t i) {
    return Corner{s.target(sleeve.halfedges[i]), true, i, first_left[i], path.left[i]};
  };
  const auto right_of = [&](std::size_t i) {
    return Corner{s.source(sleeve.halfedges[i]), false, i, first_right[i], path.right[i]};
  };
  Corner apex{sleeve.start, true, 0, 0, start}, left = apex, right = apex;
  bool left_is_apex = true, right_is_apex = true;
  path.corners.push_back(apex);
  for (std::size_t i = 0; i <= n; ++i)
  {
    const auto restart = [&](const Corner& bend) {
      path.corners.push_back(bend);
      apex = left = right = bend;
      left_is_apex = right_is_apex = true;
      i = bend.portal; // the loop goes on with the portal after it
    };
    if (i == n)
    {
      if (!right_is_apex && turn(apex.at, right.at, end) < 0) { restart(right); }
      else if (!left_is_apex && turn(apex.at, left.at, end) > 0) { restart(left); }
      continue;
    }
    const Corner r = right_of(i), l = left_of(i);
    const bool is_bend = path.corners.size() > 1;
    if (right_is_apex || turn(apex.at, right.at, r.at) >= 0)
    {
      if (!right_is_apex && !left_is_apex && turn(apex.at, left.at, r.at) >= 0)
      {
        restart(left);
        continue;
      }
      right = r;
      right_is_apex = is_bend && !apex.is_left && r.first == apex.first;
    }
    if (left_is_apex || turn(apex.at, left.at, l.at) <= 0)
    {
      if (!left_is_apex && !right_is_apex && turn(apex.at, right.at, l.at) <= 0)
      {
        restart(right);
        continue;
      }
      left = l;
      left_is_apex = is_bend && apex.is_left && l.first == apex.first;
    }
  }
  path.corners.push_back({sleeve.end, true, n, n, end});

  path.fraction.resize(n);
  std::size_t k = 1;
  for (std::size_t i = 0; i < n; ++i)
  {
    while (k + 1 < path.corners.size() && path.corners[k].portal < i) { ++k; }
    const Corner &a = path.corners[k - 1], &b = path.corners[k];
    const auto ends_at = [&](const Corner& corner, bool is_bend) {
      return is_bend && corner.first == (corner.is_left ? first_left : first_right)[i];
    };
    const bool at_a = ends_at(a, k > 1), at_b = ends_at(b, k + 1 < path.corners.size());
    double& t = path.fraction[i];
    if ((at_a && !a.is_left) || (at_b && !b.is_left)) { t = 0; }
    else if (at_a || at_b) { t = 1; }
    else
    {
      const double p = turn(a.at, b.at, path.right[i]), q = turn(a.at, b.at, path.left[i]);
      t = q - p > 0 ? std::min(std::max(-p / (q - p), 0.), 1.) : 0.5;
    }
  }
  return path;
}

double angle(const Point_2& at, const Point_2& p, const Point_2& q)
{
  const double x1 = p[0] - at[0], y1 = p[1] - at[1], x2 = q[0] - at[0], y2 = q[1] - at[1];
  return std::abs(std::atan2(x1 * y2 - y1 * x2, x1 * x2 + y1 * y2));
}

} // namespace internal

} // namespace meridian
