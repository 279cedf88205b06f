// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FIELD_FIELD_H
#define MERIDIAN_FIELD_FIELD_H

#include <meridian/base/vectors.h>
#include <meridian/field/Sparse_solver.h>
#include <meridian/field/critical_points.h>
#include <meridian/field/edge_weights.h>
#include <meridian/surface/Triangle_surface.h>

#include <string>
#include <vector>

namespace meridian {

/// \ingroup PkgMeridianOrder
/// what one may choose about a field. Vertices are those of the surface.
struct Field_options
{
  Weights weights = Weights::POSITIVE;
  std::vector<Index> minima, maxima; ///< vertices where the field is 0 and 1; both empty: two vertices far apart
  /// one a vertex: a field to take instead of a harmonic one, such as an eigenfunction or a distance. A boundary loop
  /// takes the mean of its vertices. Its own extrema are kept, or `minima` and `maxima` if they are given.
  std::vector<double> values;
  bool one_maximum = false; ///< whether only the highest maximum is kept: descending lines leave one piece for each
  std::string values_name = "given"; ///< what `values` are, for reports
  Solvers solvers;                   ///< the general one serves mean-value weights
};

/// \ingroup PkgMeridianOrder
/// checks what was chosen about a field of a surface.
/// \throws Invalid_input_error if there is no such vertex, if minima or maxima alone are given, or if values are not
///   one finite number a vertex
void check(const Triangle_surface& s, const Field_options& options);

/// \ingroup PkgMeridianOrder
/// what a field was, for whoever made something of it.
struct Field_summary
{
  std::string field_kind = "none";
  std::vector<double> field;            ///< at the vertices of the surface; empty where no field was needed
  std::vector<Critical_point> critical; ///< of the closed model, as vertices of the surface or -1
  Critical_counts counts;
  int order_rounds = 0, flat_regions = 0;
  bool order_numbered = false;
};

} // namespace meridian

#endif // MERIDIAN_FIELD_FIELD_H
