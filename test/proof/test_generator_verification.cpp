#include "support/pipeline.h"
#include "support/sample_surfaces.h"

#include <meridian/base/Polygon_soup.h>
#include <meridian/base/Result_mesh.h>
#include <meridian/base/vectors.h>
#include <meridian/handles/Generators.h>
#include <meridian/proof/verify_generators.h>
#include <meridian/result/Assembled_result.h>
#include <meridian/result/assemble_result.h>
#include <meridian/result/name_curves.h>
#include <meridian/result/recount.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/examine_surface.h>

#include <cstdint>
#include <map>

using namespace meridian;

namespace {

// Curves on a grid that is its own result: a torus, and beside it a second one if asked for.
struct Grid
{
  static constexpr int n = 12, m = 8;
  Polygon_soup input;
  Result_mesh result;
  std::vector<Result_curve> curves;

  explicit Grid(int tori = 1)
  {
    for (int i = 0; i < tori; ++i)
    {
      const Triangle_surface s = sample::torus(n, m);
      const Index first = static_cast<Index>(input.points.size());
      for (const Point& p : s.points) { input.points.push_back({p[0] + 10 * i, p[1], p[2]}); }
      for (const auto& t : s.triangles)
      {
        const std::array<Index, 3> corners{t[0] + first, t[1] + first, t[2] + first};
        input.add_polygon(corners.data(), 3);
        result.faces.push_back(corners);
        result.face_of.push_back(static_cast<Index>(result.face_of.size()));
        result.component_of.push_back(i);
      }
      curves.push_back({"meridian_" + std::to_string(i), around(i, 0), {}});
      curves.push_back({"longitude_" + std::to_string(i), along(i, 0), {}});
    }
    result.points = input.points;
    result.copy_of.assign(input.points.size(), -1);
    for (Index v = 0; v < static_cast<Index>(input.points.size()); ++v)
    {
      result.origin.emplace_back();
      result.origin.back().index = {v, -1};
    }
  }
  static Index at(int torus, int i, int j) { return torus * n * m + (i + n) % n * m + (j + m) % m; }
  static std::vector<Index> around(int torus, int i) // the tube, through column i
  {
    std::vector<Index> path;
    for (int j = 0; j <= m; ++j) { path.push_back(at(torus, i, -j)); }
    return path;
  }
  static std::vector<Index> along(int torus, int j)
  {
    std::vector<Index> path;
    for (int i = 0; i <= n; ++i) { path.push_back(at(torus, i, j)); }
    return path;
  }
  std::vector<std::string> failures() const
  {
    const auto v = verify_generators(input, result, curves);
    for (const auto& failure : v.failures) { BOOST_TEST_MESSAGE(failure); }
    return v.failures;
  }
  bool is_caught(const std::string& name) const
  {
    const auto found = failures();
    return std::any_of(found.begin(), found.end(), [&](const auto& f) { return f.find(name) != std::string::npos; });
  }
};

} // namespace

BOOST_AUTO_TEST_CASE(good_curves_are_verified)
{
  BOOST_TEST(Grid().failures().empty());
  BOOST_TEST(Grid(2).failures().empty());
}

BOOST_AUTO_TEST_CASE(a_reversed_loop_is_caught)
{
  Grid g;
  std::reverse(g.curves[1].points.begin(), g.curves[1].points.end());
  BOOST_TEST(g.is_caught("cross with the intersection number -1"));
}

BOOST_AUTO_TEST_CASE(a_copy_of_another_loop_is_caught)
{
  Grid g;
  g.curves[1].points = Grid::around(0, 4); // homologous to the meridian
  BOOST_TEST(g.is_caught("meridian_0 and longitude_0 do not meet"));
  g.curves[1].points = Grid::around(0, 0); // the meridian itself
  BOOST_TEST(g.is_caught("run along one edge"));
}

BOOST_AUTO_TEST_CASE(a_loop_that_touches_itself_is_caught)
{
  Grid g;
  auto& path = g.curves[1].points; // out to a neighbour and back
  path.insert(path.begin() + 4, {Grid::at(0, 3, 1), Grid::at(0, 3, 0)});
  BOOST_TEST(g.is_caught("longitude_0 touches itself at vertex"));
}

BOOST_AUTO_TEST_CASE(a_contractible_loop_is_caught)
{
  Grid g;
  g.curves[0].points = {Grid::at(0, 5, 3), Grid::at(0, 6, 3), Grid::at(0, 6, 4), Grid::at(0, 5, 3)};
  BOOST_TEST(g.is_caught("do not meet"));
  // touches the longitude from its left
  g.curves[0].points = {Grid::at(0, 5, 0), Grid::at(0, 6, 1), Grid::at(0, 5, 1), Grid::at(0, 5, 0)};
  BOOST_TEST(g.is_caught("touch at vertex"));
}

BOOST_AUTO_TEST_CASE(curves_of_two_handles_that_change_places_are_caught)
{
  Grid g(2);
  std::swap(g.curves[1].points, g.curves[3].points);
  BOOST_TEST(g.is_caught("do not meet"));
  Generators pairs = pipeline::generators(sample::plate(2, 3));
  BOOST_TEST(verify_generators(sample::plate(2, 3), pairs).failures.empty());
  std::swap(pairs.pairs[0].longitude.vertices, pairs.pairs[1].longitude.vertices);
  const auto found = verify_generators(sample::plate(2, 3), pairs).failures;
  BOOST_TEST(std::any_of(found.begin(), found.end(), [](const auto& f) {
    return f.find("meridian_0 and longitude_0 do not meet") != std::string::npos;
  }));
  BOOST_TEST(std::any_of(found.begin(), found.end(),
                         [](const auto& f) { return f.find("cross, at 1 vertices") != std::string::npos; }));
}

BOOST_AUTO_TEST_CASE(curves_that_cross_more_than_once_are_caught)
{
  Grid g;
  g.curves[1].points.clear();
  // not a walk
  for (int k = 0; k <= 24; ++k) { g.curves[1].points.push_back(Grid::at(0, k, k / 12 * 4 + (k % 12 > 5 ? 0 : 0))); }
  BOOST_TEST(g.is_caught("where the mesh has no edge"));
  // Along the tube, once around it on the way: still one crossing, and a basis.
  g.curves[1].points.clear();
  for (int k = 0; k <= 8; ++k) { g.curves[1].points.push_back(Grid::at(0, k, k)); }
  for (int k = 9; k <= 12; ++k) { g.curves[1].points.push_back(Grid::at(0, k, 8)); }
  BOOST_TEST(g.failures().empty());
}

BOOST_AUTO_TEST_CASE(missing_open_and_misnamed_curves_are_caught)
{
  Grid g;
  g.curves[1].points.pop_back();
  BOOST_TEST(g.is_caught("longitude_0 is not closed"));
  g = Grid();
  g.curves.pop_back();
  BOOST_TEST(g.is_caught("there are 1 meridians and 0 longitudes"));
  g = Grid();
  g.curves.clear();
  BOOST_TEST(g.is_caught("genus 1 and 0 curves"));
  g = Grid();
  g.curves[1].name = "meridian_0";
  BOOST_TEST(g.is_caught("there are two curves 'meridian_0'"));
  g = Grid();
  g.curves[0].name = "meridian_3";
  BOOST_TEST(g.is_caught("not numbered through from 0"));
  g = Grid();
  g.curves[0].name = "equator";
  BOOST_TEST(g.is_caught("curve 'equator'"));
  g = Grid();
  g.curves[0].points[2] = 12345;
  BOOST_TEST(g.is_caught("names a vertex that is not there"));
  g = Grid(2);
  std::swap(g.curves[0].points, g.curves[2].points);
  std::swap(g.curves[1].points, g.curves[3].points);
  BOOST_TEST(g.is_caught("out of order"));
}

BOOST_AUTO_TEST_CASE(loops_that_may_cross_are_judged_by_their_determinant)
{
  Grid g;
  g.curves[0].name = "loop_0";
  g.curves[1].name = "loop_1";
  BOOST_TEST(g.failures().empty());
  g.curves[1].points = Grid::around(0, 5); // dependent
  BOOST_TEST(g.is_caught("determinant is neither 1 nor -1"));
  // Twice along the tube while once around it, and once around it: determinant 2.
  Grid h;
  h.curves[0].name = "loop_0";
  h.curves[1].name = "loop_1";
  auto& path = h.curves[1].points;
  path.clear();
  for (int k = 0; k <= 24; ++k) { path.push_back(Grid::at(0, k, std::min(k / 3, 8))); }
  path.erase(path.begin() + 24 + 1, path.end());
  BOOST_TEST(h.is_caught("determinant is neither 1 nor -1"));
}

// Three times, and once in the sum.
BOOST_AUTO_TEST_CASE(a_pair_that_crosses_again_and_back_is_caught)
{
  Grid grid;
  std::vector<Index> path;
  for (const auto& [i, j] : {std::pair{-1, 0}, {0, 0}, {1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 2}, {0, 2}})
  {
    path.push_back(Grid::at(0, i, j));
  }
  for (int i = 1; i <= Grid::n - 2; ++i) { path.push_back(Grid::at(0, i, 2)); }
  for (const auto& [i, j] : {std::pair{-2, 1}, {-2, 0}, {-1, 0}}) { path.push_back(Grid::at(0, i, j)); }
  grid.curves[1].points = path;
  BOOST_TEST(grid.is_caught("share 3 vertices, not one"));
}

BOOST_AUTO_TEST_CASE(loops_are_a_basis_wherever_they_run)
{
  for (int i = 0; i < Grid::n; ++i)
    for (int j = 0; j < Grid::m; ++j)
    {
      Grid grid;
      grid.curves = {{"loop_0", Grid::along(0, j), {}}, {"loop_1", Grid::around(0, i), {}}};
      BOOST_TEST(grid.failures().empty(), i << ", " << j);
    }
}

BOOST_AUTO_TEST_CASE(fields_that_do_not_rise_and_fall_once_are_caught)
{
  Grid grid;
  std::map<std::int32_t, double>& field = grid.curves[1].field;
  for (int i = 0; i < Grid::n; ++i) { field[Grid::at(0, i, 0)] = 2 * i <= Grid::n ? i : Grid::n - i + 0.5; }
  BOOST_TEST(grid.failures().empty());
  const auto with = [&](int i, double value) {
    Grid other = grid;
    other.curves[1].field[Grid::at(0, i, 0)] = value;
    return other.is_caught("longitude_0 is said to be made of flow lines, and its field turns");
  };
  BOOST_TEST(with(3, 5.25)); // it falls in between
  BOOST_TEST(with(7, 6));    // it is level at the top
  field.erase(Grid::at(0, 5, 0));
  BOOST_TEST(grid.is_caught("its field has no value at vertex"));
}

BOOST_AUTO_TEST_CASE(boundary_loops_are_counted_and_belong_to_the_basis)
{
  const Triangle_surface s = sample::punctured(sample::torus(14, 9), {30, 77});
  const Generators g = pipeline::generators(s);
  const Polygon_soup soup = sample::soup(s);
  const std::vector<Generators> all{g};
  const Assembled_result assembled = assemble_refined(soup, examine_surface(soup), all);
  auto curves = name_curves(all, assembled);
  BOOST_TEST(verify_generators(soup, assembled.mesh, curves).failures.empty());
  BOOST_TEST(curves.back().name == "boundary_1");
  auto fewer = curves;
  fewer.pop_back();
  BOOST_TEST(verify_generators(soup, assembled.mesh, fewer).failures.front().find("2 boundary loops, and 1 are listed")
             != std::string::npos);
  auto inside = curves;
  inside.back().points = curves.front().points;
  BOOST_TEST(verify_generators(soup, assembled.mesh, inside).failures.front().find("boundary_1 leaves the boundary")
             != std::string::npos);
  auto twice = curves;
  twice[3].points = curves[2].points;
  BOOST_TEST(!verify_generators(soup, assembled.mesh, twice).failures.empty());
}

BOOST_AUTO_TEST_CASE(a_mesh_that_was_changed_is_caught)
{
  Grid g;
  g.result.points[5][0] += 1e-9;
  BOOST_TEST(g.is_caught("vertices are not at the position of their origin"));
  g = Grid();
  g.result.faces.pop_back();
  g.result.face_of.pop_back();
  g.result.component_of.pop_back();
  BOOST_TEST(g.is_caught("faces of the input are missing"));
}
