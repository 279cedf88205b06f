// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/surface/visibility.h>

#include <meridian/base/exceptions.h>

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>

namespace meridian {

std::vector<double> visibility(const Triangle_surface& s, const Point& direction)
{
  using Kernel = CGAL::Simple_cartesian<double>;
  using Triangles = std::vector<Kernel::Triangle_3>;
  using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
  if (!(norm(direction) > 0) || !std::isfinite(norm(direction)))
  {
    throw Invalid_input_error("a direction to look from must be finite and not 0");
  }
  const auto point = [&](Index v) { return Kernel::Point_3(s.points[v][0], s.points[v][1], s.points[v][2]); };
  Triangles triangles;
  std::vector<Index> face; // of each triangle; what has no area hides nothing
  for (Index f = 0; f < s.number_of_faces(); ++f)
  {
    const auto& t = s.triangles[f];
    const Kernel::Triangle_3 triangle(point(t[0]), point(t[1]), point(t[2]));
    if (triangle.is_degenerate()) { continue; }
    triangles.push_back(triangle);
    face.push_back(f);
  }
  CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> tree(triangles.begin(), triangles.end());
  tree.build();
  std::vector<double> seen(s.number_of_vertices(), 0);
  for (Index v = 0; v < s.number_of_vertices(); ++v)
  {
    bool faces_it = false;
    s.for_each_outgoing(v, [&](Index h) {
      const auto& t = s.triangles[s.face(h)];
      faces_it =
        faces_it || dot(cross(s.points[t[1]] - s.points[t[0]], s.points[t[2]] - s.points[t[0]]), direction) > 0;
    });
    if (!faces_it) { continue; }
    const Kernel::Ray_3 ray(point(v), Kernel::Vector_3(direction[0], direction[1], direction[2]));
    const auto is_own = [&](const Triangles::const_iterator& i) {
      const auto& t = s.triangles[face[i - triangles.begin()]];
      return t[0] == v || t[1] == v || t[2] == v;
    };
    seen[v] = tree.first_intersected_primitive(ray, is_own) ? 0 : 1;
  }
  return seen;
}

} // namespace meridian
