// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FIELD_EDGE_WEIGHTS_H
#define MERIDIAN_FIELD_EDGE_WEIGHTS_H

#include <meridian/base/names.h>
#include <meridian/surface/Triangle_surface.h>

#include <array>
#include <vector>

namespace meridian {

/// \ingroup PkgMeridianOrder
/// the discretizations of the Laplacian.
enum class Weights
{
  /// mean-value weights made symmetric edge by edge: positive and symmetric, so that the maximum principle holds
  POSITIVE,
  MEAN_VALUE, ///< \cite floater2003, positive, not symmetric
  COTANGENT,  ///< \cite pinkall1993, symmetric, negative across obtuse angles
  /// cotangents on other edges than the mesh's, none negative: see `make_intrinsic_delaunay_graph()`
  INTRINSIC_DELAUNAY
};

/// the names of `Weights`.
template <> struct Names<Weights>
{
  static constexpr std::array<Named_value<Weights>, 4> table{{
    {Weights::POSITIVE, "positive",
     "mean-value weights made symmetric; positive, so that a field has no other extrema"},
    {Weights::MEAN_VALUE, "mean-value", "positive, not symmetric"},
    {Weights::COTANGENT, "cotangent", "symmetric, negative across obtuse angles"},
    {Weights::INTRINSIC_DELAUNAY, "intrinsic-delaunay",
     "cotangents on edges of a triangulation of its own, none negative"},
  }};
};

/*!
 * \ingroup PkgMeridianOrder
 *
 * \returns for each halfedge the weight of its target in the equation of its source
 *
 * All weights are finite on faces without area and edges without length: lengths, half-angle tangents and areas are
 * bounded relative to the size of the surface. Positive weights stay positive.
 * Both sides of a boundary edge lie in one node of the closed model, so that boundary edges have weight 0.
 *
 * \param s the surface
 * \param kind which weights
 * \pre `kind` is not `Weights::INTRINSIC_DELAUNAY`
 * \par Complexity
 * Linear.
 */
std::vector<double> edge_weights(const Triangle_surface& s, Weights kind);

} // namespace meridian

#endif // MERIDIAN_FIELD_EDGE_WEIGHTS_H
