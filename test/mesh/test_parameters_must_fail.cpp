// Must not compile: the function does not read this parameter.
#include <meridian/cut_to_disc.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

int main()
{
  CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> mesh, disc;
  meridian::cut_to_disc(mesh, disc, meridian::parameters::cut_options(meridian::Cut_options()).number_of_iterations(3));
}
