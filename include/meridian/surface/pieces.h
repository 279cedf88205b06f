// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_SURFACE_PIECES_H
#define MERIDIAN_SURFACE_PIECES_H

#include <meridian/base/vectors.h>
#include <meridian/surface/Triangle_surface.h>

#include <vector>

namespace meridian {

/// \ingroup PkgMeridianSurface
/// a connected piece of a surface, as a surface of its own.
struct Surface_piece
{
  Triangle_surface surface;    ///< the piece; face `f` has its corners in the order of the face that it was
  std::vector<Index> faces;    ///< of the whole, for each face of the piece, ascending
  std::vector<Index> vertices; ///< of the whole, for each vertex of the piece
};

/*!
 * \ingroup PkgMeridianSurface
 *
 * \returns the connected pieces of a surface, in the order of their first faces; vertices without faces are in none
 * \param s the surface
 * \par Complexity
 * Linear.
 */
std::vector<Surface_piece> pieces_of(const Triangle_surface& s);

/*!
 * \ingroup PkgMeridianSurface
 *
 * \returns for each face the number of its connected piece, as `pieces_of()` numbers them
 * \param s the surface
 * \par Complexity
 * Linear.
 */
std::vector<Index> number_pieces(const Triangle_surface& s);

} // namespace meridian

#endif // MERIDIAN_SURFACE_PIECES_H
