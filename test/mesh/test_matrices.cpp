#include "support/pipeline.h"
#include "support/sample_surfaces.h"

#include <meridian/matrices.h>

#include <meridian/base/exceptions.h>
#include <meridian/proof/verify_cut.h>
#include <meridian/result/recount.h>

#include <boost/test/unit_test.hpp>

#include <limits>
#include <map>
#include <vector>

using namespace meridian;

namespace {

// The faces of a mesh cut where a mask says so, written from the definition: corners at both ends of an edge that is
// not cut are one vertex. Returns how many vertices there are.
int vertices_of_cut_mesh(const Eigen::MatrixX3i& F, const Eigen::MatrixX3i& mask)
{
  std::vector<int> parent(static_cast<std::size_t>(3 * F.rows()));
  for (std::size_t i = 0; i < parent.size(); ++i) { parent[i] = static_cast<int>(i); }
  const auto find = [&](int a) {
    while (parent[a] != a) { a = parent[a]; }
    return a;
  };
  std::map<std::pair<int, int>, std::pair<int, int>> sides; // ends: corners there
  for (int f = 0; f < F.rows(); ++f)
    for (int k = 0; k < 3; ++k)
    {
      const int v = F(f, k), w = F(f, (k + 1) % 3), a = 3 * f + k, b = 3 * f + (k + 1) % 3;
      const auto other = sides.find({w, v});
      sides[{v, w}] = {a, b};
      if (other == sides.end() || mask(f, k)) { continue; }
      parent[find(a)] = find(other->second.second);
      parent[find(b)] = find(other->second.first);
    }
  int number = 0;
  for (std::size_t i = 0; i < parent.size(); ++i) { number += parent[i] == static_cast<int>(i); }
  return number;
}

} // namespace

// Theorem: the mask is that of a disc whose vertices are the surface's and their copies; both sides of an edge agree.
BOOST_AUTO_TEST_CASE(a_cut_of_matrices_is_a_mask_of_sides)
{
  for (const auto& sample : {sample::torus(12, 8), sample::punctured(sample::plate(2, 3), {20}), sample::sphere(2)})
  {
    const Eigen::MatrixX3d V = vertex_matrix(sample);
    const Eigen::MatrixX3i F = face_matrix(sample);
    const Triangle_surface s = make_triangle_surface(V, F);
    BOOST_TEST((s.points == sample.points));
    BOOST_TEST((s.triangles == sample.triangles));
    Cut_options options;
    options.on_edges = true;
    const Cut cut = pipeline::cut(s, options);
    BOOST_TEST(verify_cut(s, cut).failures.empty());
    const Eigen::MatrixX3i mask = cut_mask(cut.surface);
    BOOST_TEST(mask.sum() == 2 * static_cast<int>(cut.opened.seams.size()));
    BOOST_TEST(mask.minCoeff() >= 0);
    BOOST_TEST(mask.maxCoeff() == 1);
    BOOST_TEST(vertices_of_cut_mesh(F, mask) == s.number_of_vertices() + static_cast<int>(cut.opened.copy_of.size()));
    const Eigen::MatrixX2d UV = uv_matrix(pipeline::map(surface_of(cut.surface, cut.opened)));
    BOOST_TEST(UV.rows() == s.number_of_vertices() + static_cast<int>(cut.opened.copy_of.size()));
    BOOST_TEST((UV.minCoeff() >= 0 && UV.maxCoeff() <= 1));
  }
}

BOOST_AUTO_TEST_CASE(matrices_that_are_no_mesh_are_refused)
{
  const auto s = sample::torus(6, 5);
  const Eigen::MatrixXd V = vertex_matrix(s);
  const Eigen::MatrixXi F = face_matrix(s);
  BOOST_TEST(make_triangle_surface(V.cast<float>().eval(), F.cast<long>().eval()).number_of_faces() == 60);
  BOOST_CHECK_THROW(make_triangle_surface(V.leftCols(2), F), Invalid_input_error);
  BOOST_CHECK_THROW(make_triangle_surface(V, F.leftCols(2)), Invalid_input_error);
  for (const int wrong : {-1, 30, std::numeric_limits<int>::max()})
  {
    Eigen::MatrixXi G = F;
    G(7, 1) = wrong;
    BOOST_CHECK_THROW(make_triangle_surface(V, G), Invalid_input_error);
  }
  Eigen::MatrixXd W = V;
  W(3, 2) = std::numeric_limits<double>::quiet_NaN();
  BOOST_CHECK_THROW(make_triangle_surface(W, F), Invalid_input_error);
  W.resize(31, 3);
  W << V, 1, 2, 3;
  BOOST_CHECK_THROW(make_triangle_surface(W, F), Invalid_input_error); // a vertex without a face
}
