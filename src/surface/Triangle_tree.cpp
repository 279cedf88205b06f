// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/surface/Triangle_tree.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/version.h>
#if CGAL_VERSION_MAJOR >= 6 // which puts the dimension into these names
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_triangle_primitive_3.h>
#else
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_triangle_primitive.h>
#endif

#include <vector>

namespace meridian {

struct Triangle_tree::Boxes
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel; // with less, rays meet what CGAL says cannot be
  using Triangles = std::vector<Kernel::Triangle_3>;
#if CGAL_VERSION_MAJOR >= 6
  using Primitive = CGAL::AABB_triangle_primitive_3<Kernel, Triangles::const_iterator>;
  using Traits = CGAL::AABB_traits_3<Kernel, Primitive>;
#else
  using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
  using Traits = CGAL::AABB_traits<Kernel, Primitive>;
#endif

  static Kernel::Point_3 point(const Point& p) { return {p[0], p[1], p[2]}; }

  const Triangle_surface& surface;
  Triangles triangles;
  std::vector<Index> face; // of each triangle
  CGAL::AABB_tree<Traits> tree;
};

Triangle_tree::Triangle_tree(const Triangle_surface& s) : m_boxes(new Boxes{s, {}, {}, {}})
{
  for (Index f = 0; f < s.number_of_faces(); ++f)
  {
    const auto& t = s.triangles[f];
    const Boxes::Kernel::Triangle_3 triangle(Boxes::point(s.points[t[0]]), Boxes::point(s.points[t[1]]),
                                             Boxes::point(s.points[t[2]]));
    if (triangle.is_degenerate()) { continue; }
    m_boxes->triangles.push_back(triangle);
    m_boxes->face.push_back(f);
  }
  m_boxes->tree.insert(m_boxes->triangles.begin(), m_boxes->triangles.end());
  m_boxes->tree.build();
}

Triangle_tree::~Triangle_tree() = default;

bool Triangle_tree::empty() const { return m_boxes->triangles.empty(); }

bool Triangle_tree::is_hidden(Index v, const Point& direction) const
{
  const Boxes& b = *m_boxes;
  const Boxes::Kernel::Ray_3 ray(Boxes::point(b.surface.points[v]),
                                 Boxes::Kernel::Vector_3(direction[0], direction[1], direction[2]));
  const auto is_around = [&](const Boxes::Triangles::const_iterator& i) {
    const auto& t = b.surface.triangles[b.face[i - b.triangles.begin()]];
    return t[0] == v || t[1] == v || t[2] == v;
  };
  return static_cast<bool>(b.tree.first_intersected_primitive(ray, is_around));
}

void Triangle_tree::accelerate_distances() { m_boxes->tree.accelerate_distance_queries(); }

double Triangle_tree::squared_distance(const Point& p) const { return m_boxes->tree.squared_distance(Boxes::point(p)); }

} // namespace meridian
