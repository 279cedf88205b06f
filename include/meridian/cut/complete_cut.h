// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_COMPLETE_CUT_H
#define MERIDIAN_CUT_COMPLETE_CUT_H

#include <meridian/base/Progress_observer.h>
#include <meridian/base/vectors.h>
#include <meridian/curves/tighten_curves.h>
#include <meridian/cut/Cut.h>
#include <meridian/field/Sparse_solver.h>
#include <meridian/surface/Triangle_surface.h>

#include <vector>

namespace meridian {

/// \ingroup PkgMeridianCut
/// what one may choose about the curves that complete a cut.
struct Completion_options
{
  /// whether only edges of the surface are cut, so that there are no new vertices
  bool on_edges = false;
  bool bifurcations = false;             ///< whether a link may end on an earlier link
  Tighten_options tighten_options;       ///< when meridians are tight
  Solvers solvers;                       ///< of the fields
  Progress_observer* observer = nullptr; ///< told of the stages, or null
  /// faces of the surface that meridians and links go around, where they can
  std::vector<Index> keep_out = {};
};

/// \ingroup PkgMeridianCut
/// checks seams that are given. `complete_cut()` does so first.
/// \param root the surface
/// \param seams halfedges of it
/// \throws Invalid_input_error if the surface is none, or a seam is no halfedge inside it
void check_seams(const Triangle_surface& root, const std::vector<Index>& seams);

/*!
 * \ingroup PkgMeridianCut
 *
 * completes seams that are given to a cut into discs.
 *
 * The seams stay where they are. They part the surface into pieces, each of which may have handles and several
 * boundaries. Of the handles of each piece a meridian is cut, a tight contour of a harmonic field; with
 * `Completion_options::on_edges` a short cut graph of edges. What boundaries there are then, the two sides of an open
 * seam among them, are joined by `link_boundaries()`. Pieces that are discs stay as they are.
 *
 * What is kept out of is taken for a hole when meridians are looked for, so that they go around it; and what is left of
 * it by `open_kept_out()` is farther away than anything else when links are.
 *
 * \param root the surface
 * \param seams halfedges of it, any number, in any order; one of two opposite ones is enough
 * \param options see there
 * \returns the cut, whose curves of `Curve_kind::SEAM` are the seams that were given, from node to node. Meridians and
 *   paths cut the handles that they left
 * \pre `root` is connected
 * \post taking the surface apart along its seams leaves discs
 * \throws Invalid_input_error if a seam is no halfedge inside the surface, or a face none of it; Solver_error,
 *   Cancelled, Internal_error as `cut_to_disc()`
 * \par Complexity
 * That of `cut_to_disc()` for each piece with handles, and of `link_boundaries()`.
 */
Cut complete_cut(const Triangle_surface& root, const std::vector<Index>& seams,
                 const Completion_options& options = Completion_options());

} // namespace meridian

#endif // MERIDIAN_CUT_COMPLETE_CUT_H
