// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_UNWRAP_PLAN_EXTENSIONS_H
#define MERIDIAN_UNWRAP_PLAN_EXTENSIONS_H

#include <meridian/base/vectors.h>
#include <meridian/field/Sparse_solver.h>
#include <meridian/surface/Triangle_surface.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace meridian {

/// \ingroup PkgMeridianParameterization
/// where a cut may be extended, and what that is expected to gain.
struct Extension_plan
{
  std::vector<Index> vertices; ///< that the cut should reach, in the order in which they were chosen
  double before = 1;           ///< the expected L2 stretch of a map of the disc
  double after = 1;            ///< the same with the cut at these vertices
};

/*!
 * \ingroup PkgMeridianParameterization
 *
 * plans where a cut should be extended so that a map of its disc stretches less, without a map.
 *
 * The conformal map that keeps lengths along the border scales the surface by \f$ e^{-u} \f$, where \f$ \Delta u = K
 * \f$, the Gaussian curvature, and \f$ u = 0 \f$ on the border (\cite sawhney2017). Where \f$ |u| \f$ is largest a cut
 * helps most (\cite benchen2008): the shortest path of edges from there becomes border, and so on, several places at
 * once if they are nearly as high, at the end only as many as are needed.
 *
 * A map of low distortion does not shrink what lies far out as the conformal one does. Its L2 stretch is expected to be
 * the root of the mean of \f$ \sqrt{1 + (u - \bar u)^2} \f$ over the area. That has no proof; on the surfaces measured
 * its excess over 1 is within a factor of two of a map's.
 *
 * \param disc the surface, a disc
 * \param goal told the expected L2 stretch of a map of `disc`, it says at which it is to end
 * \param most how many vertices at most
 * \param solver the solver for Laplacians
 * \param kept_out of each face of `disc`, whether the cut shall not go there; empty: it may go anywhere
 *
 * \returns vertices inside the disc, and the expectation before and after
 * \throws Solver_error if the system cannot be solved
 * \par Complexity
 * That of the intrinsic Delaunay triangulation, and one Laplacian and one search \f$ O(n \log n) \f$ for every few
 * vertices.
 */
Extension_plan plan_extensions(const Triangle_surface& disc, const std::function<double(double)>& goal,
                               std::size_t most, Make_solver solver = make_laplace_solver,
                               const std::vector<char>& kept_out = {});

} // namespace meridian

#endif // MERIDIAN_UNWRAP_PLAN_EXTENSIONS_H
