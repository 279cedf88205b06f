// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_UNWRAP_COMPARE_PARAMETERIZATIONS_H
#define MERIDIAN_UNWRAP_COMPARE_PARAMETERIZATIONS_H

#include <meridian/base/names.h>
#include <meridian/result/discs_of.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/unwrap/compare_maps.h>
#include <meridian/unwrap/internal/untouched_stars.h>

#include <array>
#include <vector>

namespace meridian {

/// \ingroup PkgMeridianParameterization
/// the linear maps into a circle that can be compared.
enum class Map_weights
{
  UNIFORM,  ///< all weights are 1 (\cite tutte1963)
  POSITIVE, ///< `Weights::POSITIVE`: mean-value weights made symmetric (\cite floater2003)
  COTANGENT ///< `Weights::COTANGENT`: discrete harmonic maps (\cite eck1995). Faces may be turned over
};

/// the names of `Map_weights`.
template <> struct Names<Map_weights>
{
  static constexpr std::array<Named_value<Map_weights>, 3> table{{
    {Map_weights::UNIFORM, "uniform", "all weights are 1"},
    {Map_weights::POSITIVE, "positive", "mean-value weights made symmetric"},
    {Map_weights::COTANGENT, "cotangent", "discrete harmonic maps, whose faces may be turned over"},
  }};
};

/// \ingroup PkgMeridianParameterization
/// \param s the surface
/// \param kind which weights
/// \returns the weight of each halfedge, equal on twins
std::vector<double> map_weights(const Triangle_surface& s, Map_weights kind);

/*!
 * \ingroup PkgMeridianParameterization
 *
 * maps two discs of one surface into circles, by the same linear method, and compares the maps. See `compare_maps()`.
 *
 * An edge at `J` takes the weight that it has on the surface. Both discs would give it the same one, bit for bit, but
 * at faces that are all but without area, where weights are bounded relative to the mean length of a surface's edges.
 *
 * \param root the surface, connected
 * \param first, second two discs of it
 * \param kind the method
 *
 * \returns the comparison
 * \throws Invalid_input_error if a disc has not one boundary loop, is not one of this surface, or the surface has no
 *   area; Solver_error if a system cannot be factorized
 * \par Complexity
 * Three factorizations.
 */
Map_comparison compare_parameterizations(const Triangle_surface& root, const Cut_disc& first, const Cut_disc& second,
                                         Map_weights kind = Map_weights::POSITIVE);

} // namespace meridian

#endif // MERIDIAN_UNWRAP_COMPARE_PARAMETERIZATIONS_H
