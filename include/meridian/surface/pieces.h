// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_SURFACE_PIECES_H
#define MERIDIAN_SURFACE_PIECES_H

#include <meridian/base/vectors.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/Surface_curve.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/open_along.h>

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

/// \ingroup PkgMeridianSurface
/// \returns the vertex that a vertex of a piece is, where the surface is not taken apart
/// \param piece a piece of what `opened` is
/// \param s the surface \param opened the same, taken apart
/// \param v a vertex of the piece
Index vertex_of_whole(const Surface_piece& piece, const Refined_surface& s, const Opened_surface& opened, Index v);

/// \ingroup PkgMeridianSurface
/// \returns the halfedge that a halfedge of a piece is
/// \param piece the piece \param h a halfedge of it
inline Index halfedge_of_whole(const Surface_piece& piece, Index h) { return 3 * piece.faces[h / 3] + h % 3; }

/// \ingroup PkgMeridianSurface
/// \returns a curve on a piece as one on the surface, where that is not taken apart
/// \param piece a piece of what `opened` is
/// \param s the surface \param opened the same, taken apart
/// \param curve the curve
Surface_curve carry_to_whole(const Surface_piece& piece, const Refined_surface& s, const Opened_surface& opened,
                             Surface_curve curve);

} // namespace meridian

#endif // MERIDIAN_SURFACE_PIECES_H
