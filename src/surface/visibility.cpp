// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/surface/visibility.h>

#include <meridian/base/exceptions.h>
#include <meridian/surface/Triangle_tree.h>

#include <cmath>

namespace meridian {

std::vector<double> visibility(const Triangle_surface& s, const Point& direction)
{
  if (!(norm(direction) > 0) || !std::isfinite(norm(direction)))
  {
    throw Invalid_input_error("a direction to look from must be finite and not 0");
  }
  const Triangle_tree tree(s);
  std::vector<double> seen(s.number_of_vertices(), 0);
  for (Index v = 0; v < s.number_of_vertices(); ++v)
  {
    bool faces_it = false;
    s.for_each_outgoing(v, [&](Index h) {
      const auto& t = s.triangles[s.face(h)];
      faces_it =
        faces_it || dot(cross(s.points[t[1]] - s.points[t[0]], s.points[t[2]] - s.points[t[0]]), direction) > 0;
    });
    if (faces_it) { seen[v] = tree.is_hidden(v, direction) ? 0 : 1; }
  }
  return seen;
}

} // namespace meridian
