// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_UNWRAP_COMPARE_MAPS_H
#define MERIDIAN_UNWRAP_COMPARE_MAPS_H

#include <meridian/base/vectors.h>
#include <meridian/map/distortion.h>
#include <meridian/result/discs_of.h>
#include <meridian/surface/Triangle_surface.h>

#include <array>
#include <vector>

namespace meridian {

/// \ingroup PkgMeridianParameterization
/// two maps of one surface, each of a disc that it was cut into. `J` is `untouched`; the maps are in one gauge, and
/// norms are Frobenius norms of both coordinates, rows `J`. All is 0 if `J` is empty.
struct Map_comparison
{
  std::vector<Index> untouched;               ///< the vertices of the root that count
  std::array<std::vector<Plane_point>, 2> at; ///< the images of each disc's vertices, in the common gauge
  double variation = 0;                       ///< \f$ \| x_J - y_J \| \f$
  double bound = 0;                           ///< the lower bound of the variation; see `compare_maps()`
  double discrepancy = 0;                     ///< \f$ \| b_x - b_y \| \f$
  /// an upper bound of \f$ \| L_{JJ} \|_2 \f$, as a rule less than a thousandth too large
  double norm = 0;
  /// of each map: \f$ \| L_{JJ} x_J - b_x \| / (\| L_{JJ} \|_2 \| x \|) \f$, with x at `J` and all its neighbours
  std::array<double, 2> residual{0, 0};
  double diameter = 0;                  ///< of a circle with the area of the images
  double relative_variation = 0;        ///< root mean square of the distances over `J`, in diameters
  double relative_bound = 0;            ///< the bound in the same measure
  std::array<Distortion, 2> distortion; ///< of each map, over its whole disc
  std::array<Index, 2> flipped{0, 0};   ///< faces that are not counterclockwise, counted exactly
};

/*!
 * \ingroup PkgMeridianParameterization
 *
 * \returns the vertices that two cuts leave alone, ascending: neither cut touches a vertex within two edges, and
 *          neither the vertex nor a neighbour lies on the boundary of the root.
 *
 * So the faces at these vertices and at their neighbours are the same in both discs, their neighbours are inner
 * vertices of both, and the right-hand sides come from the maps and not from the circle.
 *
 * \param root the surface
 * \param first, second two discs of it
 * \throws Invalid_input_error if a disc has flags for another number of vertices
 * \par Complexity
 * Linear.
 */
std::vector<Index> find_untouched_vertices(const Triangle_surface& root, const Cut_disc& first, const Cut_disc& second);

/*!
 * \ingroup PkgMeridianParameterization
 *
 * \returns the norm of \f$ \sum_w \omega_{vw} (x_v - x_w) \f$ over the rows `v` in `untouched`, both coordinates: how
 *          far a map is from obeying its equations. Recounted from stars of the surface, with no matrix.
 * \param root the surface
 * \param weights one for each halfedge
 * \param untouched inner vertices
 * \param at the image of each vertex
 */
double laplacian_residual(const Triangle_surface& root, const std::vector<double>& weights,
                          const std::vector<Index>& untouched, const std::vector<Plane_point>& at);

/*!
 * \ingroup PkgMeridianParameterization
 *
 * compares two maps of one surface, each of a disc that it was cut into, and bounds from below how far they differ
 * (\cite patane2007, section 5).
 *
 * Let `J` be the vertices that neither cut touches, see `find_untouched_vertices()`, and `L` the Laplacian of the
 * surface. Its rows `J` are rows of the Laplacians of both discs, because weights depend on the faces at an edge. A
 * linear method, which asks for
 * \f$ L x = 0 \f$ at inner vertices, gives \f$ L_{JJ} x_J = b_x := -L_{J,N(J) \setminus J} x \f$, for the second map
 * likewise, and so
 * \f[ \| x_J - y_J \|_F \ge \| b_x - b_y \|_F / \| L_{JJ} \|_2 . \f]
 * Both coordinates are the columns of one matrix; the 2-norm is right for them, since \f$ \| A X \|_F \le \| A \|_2 \|
 * X \|_F \f$ column by column. Twice the residuals of both maps, and what rounding may add, are taken off the
 * numerator: so the bound holds in floating point too, and it holds, though it may be 0, for maps that do not obey the
 * equations.
 *
 * The gauge: both maps are scaled to the area of the surface, the centroid of `J` comes to the origin in both, and the
 * second is turned as brings it nearest to the first at `J`. It is the best rigid motion in the least squares sense;
 * nothing is scaled or mirrored to fit. Applied to a whole map, an affine map keeps \f$ L x = 0 \f$, because the rows
 * of `L` add up to zero, so that both equations still hold.
 *
 * \param root the surface
 * \param first, second two discs of it
 * \param weights one for each halfedge of the surface, equal on twins; their matrix is positive semidefinite
 * \param at the image of each vertex of each disc. Least squares conformal maps (\cite levy2002) obey the equations
 *   of cotangent weights at all vertices but the boundary and those that are pinned
 *
 * \returns how far they differ, and the bound
 * \throws Invalid_input_error if a disc is not one of this surface, or the surface or an image has no area
 * \par Complexity
 * One factorization, \f$ O(n^{1.5}) \f$, and some hundred products of a matrix and a vector.
 */
Map_comparison compare_maps(const Triangle_surface& root, const Cut_disc& first, const Cut_disc& second,
                            const std::vector<double>& weights, std::array<std::vector<Plane_point>, 2> at);

} // namespace meridian

#endif // MERIDIAN_UNWRAP_COMPARE_MAPS_H
