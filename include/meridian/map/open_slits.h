// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MAP_OPEN_SLITS_H
#define MERIDIAN_MAP_OPEN_SLITS_H

#include <meridian/base/vectors.h>
#include <meridian/surface/Triangle_surface.h>

#include <cstddef>
#include <vector>

namespace meridian {

/// \ingroup PkgMeridianParameterization
/// how many sides of a border were nearer to others than they should be, and still are.
struct Opened_slits
{
  std::size_t before = 0; ///< sides that were nearer
  std::size_t after = 0;  ///< sides that are nearer
};

/*!
 * \ingroup PkgMeridianParameterization
 *
 * moves the two sides of slits of a map apart, and what is near them, so that texels of one do not bleed into the
 * other.
 *
 * Sides of the border that face each other across what is outside, nearer than the gap, are pushed apart, in rounds;
 * what is up to four gaps from them goes along, the less the farther. Where they are near along the border too, within
 * eight gaps, they stay: a slit has an end. Faces are not turned over, and the border stays simple, decided exactly;
 * and no face is stretched to a symmetric Dirichlet energy of 12 beside what it was, which is 4 by itself.
 *
 * \param disc the surface
 * \param at the image of each vertex: one-to-one, and so it stays
 * \param gap how far apart sides shall be, in the unit of the image
 * \returns how many sides of the border were nearer than the gap, and are
 * \par Complexity
 * \f$ O(n \log n + k) \f$ for each of up to 40 rounds, with `k` pairs of sides above each other, and in each as often
 * as vertices have to be held back
 */
Opened_slits open_slits(const Triangle_surface& disc, std::vector<Plane_point>& at, double gap);

} // namespace meridian

#endif // MERIDIAN_MAP_OPEN_SLITS_H
