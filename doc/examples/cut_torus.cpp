#include <meridian/cut_to_disc.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <iostream>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main()
{
  Mesh torus, disc;
  const int n = 40, m = 16;
  const double step_u = 2 * std::acos(-1.) / n, step_v = 2 * std::acos(-1.) / m;
  std::vector<Mesh::Vertex_index> v;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j)
    {
      const double r = 3 + std::cos(j * step_v);
      v.push_back(torus.add_vertex({r * std::cos(i * step_u), r * std::sin(i * step_u), std::sin(j * step_v)}));
    }
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j)
    {
      const int k = (i + 1) % n, l = (j + 1) % m;
      torus.add_face(v[i * m + j], v[k * m + j], v[k * m + l]);
      torus.add_face(v[i * m + j], v[k * m + l], v[i * m + l]);
    }

  const meridian::Cut cut = meridian::cut_to_disc(torus, disc);

  const auto characteristic = static_cast<int>(disc.number_of_vertices()) - static_cast<int>(disc.number_of_edges())
                              + static_cast<int>(disc.number_of_faces());
  std::cout << "genus " << cut.genus << ", " << cut.counts.saddles << " saddles, "
            << curves_of(cut, meridian::Curve_kind::MERIDIAN).size() << " meridian, "
            << curves_of(cut, meridian::Curve_kind::LINK).size() << " link\nthe disc has Euler characteristic "
            << characteristic << '\n';
}
