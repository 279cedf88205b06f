// The stages of a cut, compiled once for all tests.
#ifndef MERIDIAN_TEST_PIPELINE_H
#define MERIDIAN_TEST_PIPELINE_H

#include <meridian/base/Polygon_soup.h>
#include <meridian/base/Verification.h>
#include <meridian/cut/Cut.h>
#include <meridian/cut/Cut_options.h>
#include <meridian/field/Ordered_surface.h>
#include <meridian/field/Scalar_field.h>
#include <meridian/field/edge_weights.h>
#include <meridian/field/solve_harmonic_field.h>
#include <meridian/handles/Generators.h>
#include <meridian/handles/find_shortest_basis.h>
#include <meridian/map/Parameterization.h>
#include <meridian/result/Assembled_result.h>
#include <meridian/surface/Closed_model.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/examine_surface.h>
#include <meridian/unwrap/Unwrapping.h>
#include <meridian/unwrap/internal/Unwrapper.h>

namespace pipeline {

using namespace meridian;

// The choices about contours of options that have no other method.
inline By_contours& contours(Cut_options& o) { return std::get<By_contours>(o.method); }

// Only the curves tightened, so that meridians and links stay what they are.
inline Cut_options tight_curves(Cut_options o = Cut_options())
{
  o.tightening = Tightening::CURVES;
  return o;
}

Cut cut(const Triangle_surface& s, const Cut_options& options = Cut_options());
Scalar_field harmonic(const Triangle_surface& s, const Closed_model& g, const std::vector<Dirichlet_value>& prescribed,
                      Weights weights = Weights::POSITIVE);

// A surface ordered by any field on its vertices (on a boundary loop, that of its first vertex), with one minimum and
// one maximum if `simplify` is set.
Ordered_surface order(const Triangle_surface& s, const std::vector<double>& field, bool simplify);

Generators generators(const Triangle_surface& s, const Generator_options& options = Generator_options());
Homology_basis basis(const Triangle_surface& s, const Basis_options& options = Basis_options());
// The same with the class of every curve.
Generators classified(const Triangle_surface& s, const Generator_options& options = Generator_options());

Parameterization map(const Triangle_surface& disc, const Map_options& options = Map_options());
Unwrapping unwrap(const Triangle_surface& s, const Unwrap_options& options = Unwrap_options());

// What is wrong, or nothing.
inline std::string first_failure(const Verification& v) { return v ? "" : v.failures.front(); }

// A whole run, as the program does it.
struct Run
{
  Examination examination;
  std::vector<Cut> cuts;
  Assembled_result assembled;
  Verification verification;
};
Run run(const Polygon_soup& soup, bool repair = false, const Cut_options& options = Cut_options());

} // namespace pipeline

#endif // MERIDIAN_TEST_PIPELINE_H
