// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MAP_PARAMETERIZE_DISC_H
#define MERIDIAN_MAP_PARAMETERIZE_DISC_H

#include <meridian/base/Progress_observer.h>
#include <meridian/map/Parameterization.h>
#include <meridian/surface/Triangle_surface.h>

namespace meridian {

/*!
 * \ingroup PkgMeridianParameterization
 *
 * maps a disc into the plane.
 *
 * If the method asked for leaves flipped faces or an overlap, the next safer one is tried: `SYMMETRIC_DIRICHLET`
 * after another with a free border, then averages with positive weights, which flip nothing in exact arithmetic,
 * with uniform ones, and with weights changed until stretch is low; after a square, whose sides may hold all corners
 * of a face, a circle, unless a polygon is given; and at last a regular polygon, with uniform weights, where nothing
 * depends on lengths that double precision cannot tell apart. If a disc of more than 100 000 vertices has no map with a
 * free border, only one safer method is tried: the faces that it flips say where the cut should be extended.
 *
 * \param disc the surface
 * \param options see there
 * \param progress told how much is done of maps of low distortion
 *
 * \returns the first map that is one-to-one, or, if there is none, that of those tried with the fewest flipped faces
 * \pre `disc` is a disc
 * \throws Invalid_input_error as `check()`, Solver_error if no method gives a map
 * \par Complexity
 * One factorization for linear methods, and one of twice the size for each step of methods that improve maps.
 */
Parameterization parameterize_disc(const Triangle_surface& disc, const Map_options& options = Map_options(),
                                   const Progress& progress = {});

/// \ingroup PkgMeridianParameterization
/// goes on from a map of low distortion with a free border, which may have been one of a disc opened less far.
/// \param disc the surface
/// \param at its map, one-to-one
/// \param options their solver is used
/// \param progress told how much is done
/// \returns the map at the end, of method `SYMMETRIC_DIRICHLET`; faces may be flipped where rounding
///          shrinks them to nothing
/// \par Complexity
/// one factorization of twice the size of the disc for each of a few steps
Parameterization improve_map(const Triangle_surface& disc, std::vector<Plane_point> at,
                             const Map_options& options = Map_options(), const Progress& progress = {});

} // namespace meridian

#endif // MERIDIAN_MAP_PARAMETERIZE_DISC_H
