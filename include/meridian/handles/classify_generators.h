// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_HANDLES_CLASSIFY_GENERATORS_H
#define MERIDIAN_HANDLES_CLASSIFY_GENERATORS_H

#include <meridian/base/Progress_observer.h>
#include <meridian/base/vectors.h>
#include <meridian/handles/Generators.h>
#include <meridian/surface/Triangle_surface.h>

#include <future>
#include <vector>

namespace meridian {

/// \ingroup PkgMeridianGenerators
/// \param s a surface
/// \returns whether two of its faces meet elsewhere than in a common vertex or edge, or a face has no area
/// \par Complexity
/// \f$ O(n \log^3 n + k) \f$ for `k` pairs of faces whose boxes meet (CGAL's `does_self_intersect()`)
bool does_self_intersect(const Triangle_surface& s);

/*!
 * \ingroup PkgMeridianGenerators
 *
 * \returns for each loop on which side of the surface it bounds, as `classify_generators()` says it of its curves
 * \param root a connected surface
 * \param walks the halfedges of each loop, in order
 * \post `UNKNOWN` everywhere if the surface has a boundary, meets itself or has a face without area
 * \par Complexity
 * that of `classify_generators()`
 */
std::vector<Loop_class> classify_loops(const Triangle_surface& root, const std::vector<std::vector<Index>>& walks);

/*!
 * \ingroup PkgMeridianGenerators
 *
 * says for each curve on which side of the surface it bounds (handle and tunnel loops: \cite dey2007).
 *
 * A curve bounds in the space on one side, up to homology, if and only if it is not linked with any loop of the other
 * side (Alexander duality). Its linking numbers with a basis of loops through faces, pushed off the surface, are
 * counted from one projection along a direction that is infinitely little turned, with exact signs.
 *
 * \param root a connected surface
 * \param generators its generators; the classes are written to their curves
 * \param observer told of the stage, or null
 *
 * \post `UNKNOWN` everywhere if the surface has a boundary, meets itself or has a face without area
 * \par Complexity
 * one search for self-intersections, and for each edge of a curve the faces above and below it
 */
void classify_generators(const Triangle_surface& root, Generators& generators, Progress_observer* observer = nullptr);

/// \ingroup PkgMeridianGenerators
/// the same, where the search for self-intersections has been begun before: it needs nothing but the surface, and can
/// run beside the search for generators.
/// \param root, generators, observer as above
/// \param meets_itself what `does_self_intersect(root)` returns, waited for if the surface is closed and has genus
void classify_generators(const Triangle_surface& root, Generators& generators, std::future<bool> meets_itself,
                         Progress_observer* observer = nullptr);

} // namespace meridian

#endif // MERIDIAN_HANDLES_CLASSIFY_GENERATORS_H
