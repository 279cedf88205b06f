// Solves with a solver of one's own: any model of CGAL's SparseLinearAlgebraWithFactorTraits_d, here one of Eigen's.
#include "make_torus.h"

#include <meridian/cut_to_disc.h>

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <iostream>

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

// A model has the types NT, Matrix and Vector, and the two functions.
struct My_solver
{
  using Eigen_solver =
    CGAL::Eigen_solver_traits<Eigen::SimplicialLDLT<CGAL::Eigen_sparse_symmetric_matrix<double>::EigenType>>;
  using NT = double;
  using Matrix = Eigen_solver::Matrix;
  using Vector = Eigen_solver::Vector;
  Eigen_solver solver;
  bool factor(const Matrix& a, NT& denominator)
  {
    std::cout << "factorizing " << a.row_dimension() << " equations\n";
    return solver.factor(a, denominator);
  }
  bool linear_solver(const Vector& b, Vector& x) { return solver.linear_solver(b, x); }
};

int main()
{
  Mesh mesh = make_torus<Mesh>();
  const meridian::Cut cut = meridian::cut_to_disc(mesh, meridian::parameters::sparse_linear_solver(My_solver()));
  std::cout << "cut along " << cut.curves.size() << " curves\n";
}
