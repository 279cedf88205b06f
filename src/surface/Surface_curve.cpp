// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/surface/Surface_curve.h>

namespace meridian {

double length(const Triangle_surface& s, const Surface_curve& curve)
{
  double sum = 0;
  const std::size_t n = curve.points.size();
  for (std::size_t i = 0; i + (curve.closed ? 0 : 1) < n; ++i)
    sum += distance(position(s, curve.points[i]), position(s, curve.points[(i + 1) % n]));
  return sum;
}

} // namespace meridian
