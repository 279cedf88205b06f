// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_UNWRAP_CARRY_MAP_H
#define MERIDIAN_UNWRAP_CARRY_MAP_H

#include <meridian/base/vectors.h>
#include <meridian/cut/Cut.h>
#include <meridian/surface/Triangle_surface.h>

#include <vector>

namespace meridian {

namespace internal {

// The image of each vertex of what a cut surface is opened to after further curves were inserted: where they are drawn
// into the map of the discs before. The two sides of a curve lie on each other. For the parameters see `carry_map()`.
std::vector<Plane_point> draw_curves(const Cut& before, const std::vector<Plane_point>& at, const Cut& after,
                                     const std::vector<Index>& parents);

} // namespace internal

/*!
 * \ingroup PkgMeridianParameterization
 *
 * carries the map of a disc over to what the disc becomes when its cut is extended: the new path is drawn into the map,
 * and its two sides are moved apart, each along the bisector of its angle and only as far as all faces stay upright. So
 * a map of low distortion can go on from where it was.
 *
 * \param before the cut that was mapped
 * \param at the image of each vertex of its disc, one-to-one
 * \param after the same cut, extended, whose new curves are the last in `curves`
 * \param disc what it was opened to
 * \param parents what the calls of `extend_cut()` returned, one after the other
 *
 * \returns the image of each vertex of the new disc, one-to-one by exact signs; nothing if double precision has no room
 *          for it
 * \par Complexity
 * Linear, and \f$ O(b \log b) \f$ for a border of `b` vertices
 */
std::vector<Plane_point> carry_map(const Cut& before, const std::vector<Plane_point>& at, const Cut& after,
                                   const Triangle_surface& disc, const std::vector<Index>& parents);

} // namespace meridian

#endif // MERIDIAN_UNWRAP_CARRY_MAP_H
