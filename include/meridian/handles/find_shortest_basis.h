// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_HANDLES_FIND_SHORTEST_BASIS_H
#define MERIDIAN_HANDLES_FIND_SHORTEST_BASIS_H

#include <meridian/base/Progress_observer.h>
#include <meridian/curves/tighten_curves.h>
#include <meridian/field/Sparse_solver.h>
#include <meridian/handles/Generators.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/Triangle_surface.h>

#include <vector>

namespace meridian {

/// \ingroup PkgMeridianGenerators
/// what one may choose about a short basis.
struct Basis_options
{
  /// how many faces far apart loops are sought from; 0: from 16 to 96, the fewer the more faces there are
  int bases = 0;
  bool tighten = true;                   ///< whether loops are shortened within their classes
  Tighten_options tightening;            ///< and when that ends
  Solvers solvers;                       ///< of the field whose generators are among the candidates
  Progress_observer* observer = nullptr; ///< told of the stages, or null
};

/// \ingroup PkgMeridianGenerators
/// simple closed curves that are a basis of first homology; they may cross.
struct Homology_basis
{
  Refined_surface surface;            ///< the input, refined; the curves are its seams
  std::vector<Generator_curve> loops; ///< twice the genus, the shortest first
  int genus = 0;                      ///< of the surface
  int boundary_loops = 0;             ///< of the surface
  double smallest_angle_before = 0;   ///< of the surface, in radians
  double smallest_angle_after = 0;    ///< of the refined surface, in radians
  Stage_times seconds;                ///< of each stage
};

/*!
 * \ingroup PkgMeridianGenerators
 *
 * finds short simple closed curves that are a basis of first homology (of the surface with its boundary loops closed).
 *
 * Loops of a tree and cotree of faces (\cite erickson2005) are taken from several faces far apart, and meridians
 * and longitudes beside them; they are tightened and chosen greedily, the shortest first, as long as they are
 * independent modulo 2. So the determinant over the integers is odd; that it is 1 or -1 is for `verify_generators()` to
 * see. The curves may cross.
 *
 * \param root a connected surface
 * \param options see there
 * \returns the curves
 * \throws Cancelled if the observer says so, Internal_error if an invariant broke
 * \par Complexity
 * \f$ O(b n \log n) \f$ for \f$ b \f$ faces, and the tightening of at most \f$ 8 g \f$ loops
 */
Homology_basis find_shortest_basis(const Triangle_surface& root, const Basis_options& options = Basis_options());

} // namespace meridian

#endif // MERIDIAN_HANDLES_FIND_SHORTEST_BASIS_H
