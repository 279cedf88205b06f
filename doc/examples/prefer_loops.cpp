// Cuts along the loops that one prefers: here those on one side of the mesh.
#include "make_torus.h"

#include <meridian/cut_to_disc.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <iostream>
#include <vector>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main()
{
  for (const double side : {1., -1.})
  {
    Mesh mesh = make_torus<Mesh>();
    std::vector<double> x; // one number a vertex, whose mean along a loop a preference may ask for
    for (auto v : mesh.vertices()) { x.push_back(mesh.point(v).x()); }
    meridian::By_contours contours;
    contours.minima = {160}; // the field rises along y, so that its level lines come in pairs, one on each side
    contours.maxima = {480};
    contours.preference = [=](const meridian::Loop_candidate& loop) { return side * loop.average(x); };
    meridian::Cut_options options;
    options.method = contours;
    const meridian::Cut cut = meridian::cut_to_disc(mesh, meridian::parameters::cut_options(options));
    const auto loop = curves_of(cut, meridian::Curve_kind::MERIDIAN).front();
    std::cout << "the meridian lies where x is " << (cut.surface.points[loop.vertices.front()][0] > 0 ? "" : "not ")
              << "positive\n";
  }
}
