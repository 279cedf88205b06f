// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MAP_PIN_MAP_H
#define MERIDIAN_MAP_PIN_MAP_H

#include <meridian/base/vectors.h>
#include <meridian/field/Sparse_solver.h>
#include <meridian/map/minimize_distortion.h>
#include <meridian/surface/Triangle_surface.h>

#include <vector>

namespace meridian {

/*!
 * \ingroup PkgMeridianParameterization
 *
 * moves a map so that some vertices come where they shall be.
 *
 * It is turned, scaled and moved as a whole, to where the squares of the distances are least; one pin turns and scales
 * nothing. What is left is drawn there by springs that become stiffer, while the rest gives way by
 * `minimize_distortion()`; at the end, where they are next to it, vertices are put there, if the map stays one-to-one.
 *
 * \param disc the surface
 * \param at the image of each vertex: one-to-one, and so it stays
 * \param pins vertices and where they shall be; one at least, each vertex once
 * \param make_solver makes the solver of each step
 * \returns how far the farthest is from where it shall be; 0 if all are there, to the bit
 * \throws Solver_error if a step cannot be solved
 * \par Complexity
 * One factorization for each of up to 144 steps, but a few dozen as a rule; linear if the map need not give way.
 */
double pin_map(const Triangle_surface& disc, std::vector<Plane_point>& at, const std::vector<Map_pin>& pins,
               Make_solver make_solver = make_symmetric_solver);

} // namespace meridian

#endif // MERIDIAN_MAP_PIN_MAP_H
