// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/curves/internal/flow_direction.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace meridian {

namespace internal {

Point Flow_direction::slope(Index f) const
{
  const auto& t = m_surface.triangles[f];
  Index region = 0;
  for (Index v : t) { region = std::max(region, m_ordered.field.region_of(node(v))); }
  const auto value = [&](int k) { return m_ordered.field.value_in(region, node(t[k])); };
  const Point &a = m_surface.points[t[0]], &b = m_surface.points[t[1]], &c = m_surface.points[t[2]];
  const Point n = normal(f);
  const double area = dot(n, n);
  if (!(area > 0)) { return {0, 0, 0}; }
  return ((m_descends ? -1 : 1) / area)
         * ((value(1) - value(0)) * cross(n, a - c) + (value(2) - value(0)) * cross(n, b - a));
}

double Flow_direction::steepness(Index h) const
{
  const Index a = node(m_surface.source(h)), b = node(m_surface.target(h));
  const Index region = std::max(m_ordered.field.region_of(a), m_ordered.field.region_of(b));
  const double drop = std::abs(m_ordered.field.value_in(region, a) - m_ordered.field.value_in(region, b));
  const double length = m_surface.length(h);
  return length > 0 ? drop / length : 0;
}

std::pair<double, double> Flow_direction::leave(Index h, const Point& p) const
{
  const Point &a = m_surface.points[m_surface.source(h)], e = m_surface.points[m_surface.target(h)] - a;
  const Point d = slope(m_surface.face(h)), out = outwards(h);
  const double speed = dot(d, out);
  if (!(speed > 0)) { return {0.5, std::numeric_limits<double>::infinity()}; }
  const double time = dot(a - p, out) / speed;
  return {dot(p + time * d - a, e) / dot(e, e), time};
}

Point Flow_direction::normal(Index f) const
{
  const auto& t = m_surface.triangles[f];
  return cross(m_surface.points[t[1]] - m_surface.points[t[0]], m_surface.points[t[2]] - m_surface.points[t[0]]);
}

Point Flow_direction::outwards(Index h) const
{
  return cross(m_surface.points[m_surface.target(h)] - m_surface.points[m_surface.source(h)],
               normal(m_surface.face(h)));
}

} // namespace internal

} // namespace meridian
