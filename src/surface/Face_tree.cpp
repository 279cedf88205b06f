// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/surface/Face_tree.h>

#include <meridian/surface/shortest_ways.h>

namespace meridian {

namespace internal {

Point Face_tree::entry(const Triangle_surface& s, Index face) const
{
  if (by[face] >= 0) { return s.point_on(by[face], 0.5); }
  const auto& t = s.triangles[face];
  return (1. / 3) * (s.points[t[0]] + s.points[t[1]] + s.points[t[2]]);
}

Face_tree grow_face_tree(const Triangle_surface& s, Index seed)
{
  Face_tree tree;
  tree.by.assign(s.number_of_faces(), -1);
  tree.distance = find_shortest_ways(s.number_of_faces(), {{0., seed}}, [&](Index f, const auto& reach) {
    const Point from = tree.entry(s, f);
    for (Index h = 3 * f; h < 3 * f + 3; ++h)
    {
      const Index o = s.opposite[h];
      if (o >= 0 && reach(s.face(o), distance(from, s.point_on(h, 0.5)))) { tree.by[s.face(o)] = h; }
    }
  });
  return tree;
}

} // namespace internal

} // namespace meridian
