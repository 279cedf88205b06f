// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/surface/Refined_surface.h>

#include <meridian/base/exceptions.h>

#include <algorithm>

namespace meridian {

bool on_common_root_edge(const Origin& x, const Origin& y, std::array<Index, 2>& ends, std::array<double, 2>& t)
{
  if (x.kind == Origin::FACE || y.kind == Origin::FACE) { return false; }
  if (x.kind == Origin::VERTEX && y.kind == Origin::VERTEX)
    ends = {std::min(x.index[0], y.index[0]), std::max(x.index[0], y.index[0])};
  else ends = x.kind == Origin::EDGE ? x.index : y.index;
  const std::array<const Origin*, 2> both{&x, &y};
  for (int i = 0; i < 2; ++i)
  {
    const Origin& o = *both[i];
    if (o.kind == Origin::EDGE)
    {
      if (o.index != ends) { return false; }
      t[i] = o.weight[0];
    }
    else if (o.index[0] == ends[0]) { t[i] = 0; }
    else if (o.index[0] == ends[1]) { t[i] = 1; }
    else { return false; }
  }
  return true;
}

Point barycentric_in(const Triangle_surface& root, Index face, const Origin& o)
{
  if (o.kind == Origin::FACE) { return {o.weight[0], o.weight[1], o.weight[2]}; }
  Point b{0, 0, 0};
  const auto corner = [&](Index v) {
    for (int k = 0; k < 3; ++k)
      if (root.triangles[face][k] == v) { return k; }
    throw Internal_error("barycentric_in: a vertex does not lie on the face that is said to hold it");
  };
  if (o.kind == Origin::VERTEX)
  {
    b[corner(o.index[0])] = 1;
    return b;
  }
  b[corner(o.index[0])] = 1 - o.weight[0];
  b[corner(o.index[1])] = o.weight[0];
  return b;
}

Origin origin_on(const Triangle_surface& root, const Refined_surface& s, Index h, double t)
{
  const Origin x = s.origin(s.source(h)), y = s.origin(s.target(h));
  std::array<Index, 2> ends;
  std::array<double, 2> at;
  if (on_common_root_edge(x, y, ends, at)) { return Origin::on_edge(ends[0], ends[1], at[0] + t * (at[1] - at[0])); }
  const Index f = s.face_of[s.face(h)];
  const Point bx = barycentric_in(root, f, x), by = barycentric_in(root, f, y);
  return Origin::in_face(f, bx + t * (by - bx));
}

Point position(const Triangle_surface& root, const Origin& o)
{
  if (o.kind == Origin::VERTEX) { return root.points[o.index[0]]; }
  if (o.kind == Origin::EDGE)
  {
    const Point &a = root.points[o.index[0]], &b = root.points[o.index[1]];
    return a + o.weight[0] * (b - a);
  }
  const auto& corner = root.triangles[o.index[0]];
  return (o.weight[0] * root.points[corner[0]] + o.weight[1] * root.points[corner[1]])
         + o.weight[2] * root.points[corner[2]];
}

} // namespace meridian
