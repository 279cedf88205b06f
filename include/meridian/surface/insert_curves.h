// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_SURFACE_INSERT_CURVES_H
#define MERIDIAN_SURFACE_INSERT_CURVES_H

#include <meridian/base/vectors.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/Surface_curve.h>
#include <meridian/surface/Triangle_surface.h>

#include <vector>

namespace meridian {

/// \ingroup PkgMeridianSurface
/// what `insert_curves()` did.
struct Insertion
{
  std::vector<std::vector<Index>> vertices; ///< for each curve, its points as vertices of the refined surface
  Index first_new_face = 0;                 ///< faces from this index on were appended
  std::vector<Index> parent;                ///< the face that each appended face was part of
};

/*!
 * \ingroup PkgMeridianSurface
 *
 * refines a surface so that every curve becomes a set of edges, and flags these as seam.
 *
 * Each face that is crossed is divided by its chords and the parts are triangulated so that their
 * smallest angle is as large as it can be; no point is added that is not on a curve. A curve of one
 * point divides an edge and flags nothing.
 *
 * \param root the surface that `s` refines
 * \param s the surface to refine. A face keeps its index for its first part.
 * \param curves the curves; on one edge, different points have different fractions, and points of one node have the
 *   same
 * \param mark_seam whether the curves' edges are flagged
 *
 * \returns the curves' vertices and the new faces' parents. New vertices are numbered along the curves.
 *
 * \pre the curves are simple and disjoint (they may share vertices of the surface, and nodes)
 * \throws Internal_error if two chords of a face cross
 *
 * \par Complexity
 * \f$ O(k \log k) \f$ for `k` points; faces that are not crossed are not touched.
 */
Insertion insert_curves(const Triangle_surface& root, Refined_surface& s, const std::vector<Surface_curve>& curves,
                        bool mark_seam = true);

} // namespace meridian

#endif // MERIDIAN_SURFACE_INSERT_CURVES_H
