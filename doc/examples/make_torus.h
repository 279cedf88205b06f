// A torus of n x m vertices, radii 3 and 1, as any mesh that CGAL can add faces to.
#ifndef MAKE_TORUS_H
#define MAKE_TORUS_H

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/properties.h>

#include <array>
#include <cmath>
#include <vector>

template <class Mesh> Mesh make_torus(int n = 40, int m = 16)
{
  using Point =
    typename boost::property_traits<typename boost::property_map<Mesh, CGAL::vertex_point_t>::type>::value_type;
  using Vertex = typename boost::graph_traits<Mesh>::vertex_descriptor;
  Mesh torus;
  const double step_u = 2 * std::acos(-1.) / n, step_v = 2 * std::acos(-1.) / m;
  std::vector<Vertex> v;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j)
    {
      const double r = 3 + std::cos(j * step_v);
      v.push_back(add_vertex(torus));
      put(CGAL::vertex_point, torus, v.back(),
          Point(r * std::cos(i * step_u), r * std::sin(i * step_u), std::sin(j * step_v)));
    }
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j)
    {
      const int k = (i + 1) % n, l = (j + 1) % m;
      CGAL::Euler::add_face(std::array<Vertex, 3>{v[i * m + j], v[k * m + j], v[k * m + l]}, torus);
      CGAL::Euler::add_face(std::array<Vertex, 3>{v[i * m + j], v[k * m + l], v[i * m + l]}, torus);
    }
  return torus;
}

#endif // MAKE_TORUS_H
