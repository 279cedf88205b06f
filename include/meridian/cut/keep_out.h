// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_KEEP_OUT_H
#define MERIDIAN_CUT_KEEP_OUT_H

#include <meridian/base/vectors.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/pieces.h>

#include <vector>

namespace meridian {

/*!
 * \ingroup PkgMeridianCut
 *
 * opens what seams shall keep out of where they cannot: each connected part of it that is no disc, such as a band
 * around a handle, is opened along short edges, by taking the faces at them out of it.
 *
 * \param s the surface; seams that there are must be boundaries of it
 * \param kept_out of each face, whether seams shall keep out of it
 * \returns the same, of which each connected part is a disc
 * \post what is left is a part of what was
 * \par Complexity
 * \f$ O(n \log n) \f$ for each time that it is opened
 */
std::vector<char> open_kept_out(const Triangle_surface& s, std::vector<char> kept_out);

/// \ingroup PkgMeridianCut
/// \returns a surface with a seam around what is kept out
/// \param s the surface, with its seams
/// \param kept_out of each face of the root, whether seams shall keep out of it
Refined_surface wall_off(Refined_surface s, const std::vector<char>& kept_out);

/// \ingroup PkgMeridianCut
/// \returns for each face, whether it is one of some
/// \param s the surface
/// \param faces faces of it
/// \throws Invalid_input_error if one is none
std::vector<char> mark_faces(const Triangle_surface& s, const std::vector<Index>& faces);

/// \ingroup PkgMeridianCut
/// \returns for each face of a surface whether seams shall keep out of it, as `open_kept_out()` leaves it between the
///          seams that there are; empty if there are no faces to keep out of
/// \param s the surface with its seams, not refined yet
/// \param faces faces of it
/// \throws Invalid_input_error if one is none
std::vector<char> find_kept_out(const Refined_surface& s, const std::vector<Index>& faces);

/// \ingroup PkgMeridianCut
/// \returns for each face of a refined surface, whether it is a part of what is kept out of; empty if `kept_out` is
/// \param s the refined surface
/// \param kept_out of each face of the root
std::vector<char> carry_kept_out(const Refined_surface& s, const std::vector<char>& kept_out);

/// \ingroup PkgMeridianCut
/// \returns the same for each face of a piece of such a surface
/// \param piece the piece
/// \param s the refined surface, which was taken apart
/// \param kept_out of each face of the root; empty if none is
std::vector<char> carry_kept_out(const Surface_piece& piece, const Refined_surface& s,
                                 const std::vector<char>& kept_out);

/// \ingroup PkgMeridianCut
/// \returns for each vertex, whether all its faces are kept out of
/// \param s the surface
/// \param kept_out of each face; empty if none is
std::vector<char> vertices_inside(const Triangle_surface& s, const std::vector<char>& kept_out);

/// \ingroup PkgMeridianCut
/// \returns the length of the seams that have parts of such faces on both sides
/// \param s the surface with its seams
/// \param kept_out of each face of the root; empty if there are none
double seam_length_inside(const Refined_surface& s, const std::vector<char>& kept_out);

} // namespace meridian

#endif // MERIDIAN_CUT_KEEP_OUT_H
