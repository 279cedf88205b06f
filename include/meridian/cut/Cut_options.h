// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_CUT_OPTIONS_H
#define MERIDIAN_CUT_CUT_OPTIONS_H

#include <meridian/base/Progress_observer.h>
#include <meridian/base/names.h>
#include <meridian/curves/tighten_curves.h>
#include <meridian/cut/Cut_method.h>
#include <meridian/cut/Tightening.h>
#include <meridian/cut/link_boundaries.h>
#include <meridian/field/Sparse_solver.h>
#include <meridian/surface/Triangle_surface.h>

#include <array>
#include <optional>

namespace meridian {

/// \ingroup PkgMeridianCut
/// where links run.
enum class Link_domain
{
  SURFACE, ///< shortest paths on the surface
  PLANE    ///< preimages of segments in a planar embedding, where one exists in double precision
};

/// the names of `Link_domain`.
template <> struct Names<Link_domain>
{
  static constexpr std::array<Named_value<Link_domain>, 2> table{{
    {Link_domain::SURFACE, "surface", "shortest paths on the surface"},
    {Link_domain::PLANE, "plane", "through an embedding in the plane, where one exists"},
  }};
};

/// \ingroup PkgMeridianCut
/// what one may choose about a cut. Vertices are those of the surface that is cut.
struct Cut_options
{
  Cut_method method;                    ///< what cuts the handles
  std::optional<Tightening> tightening; ///< what is made shorter; empty: see `tightening_of()`
  Tighten_options tighten_options;      ///< and when that ends
  /// whether only edges of the surface are cut, so that there are no new vertices: meridians of contours are moved onto
  /// edges; for other curves, and with `GRAPH`, a cut graph of edges close by is taken
  bool on_edges = false;
  bool refine_where_needed = false; ///< with `on_edges`: divide edges where meridians cannot be moved onto them
  Link_domain link_domain = Link_domain::SURFACE; ///< where links run
  Link_options links;                             ///< how they join boundaries
  Solvers solvers;                                ///< of the field
  Progress_observer* observer = nullptr;          ///< told of the stages, or null
};

/// \ingroup PkgMeridianCut
/// \returns what is made shorter: what was chosen, or else the whole graph of meridians and links. Only the curves are
///          if the method is not `By_contours`, or where the graph would move away from what was chosen about it: by a
///          preference, about levels, about links, or to divide edges where needed
/// \param options the choices
Tightening tightening_of(const Cut_options& options);

/// \ingroup PkgMeridianCut
/// checks whether choices go together, whatever the surface.
/// \param options the choices
/// \throws Invalid_input_error if one of them would be ignored because of another
void check(const Cut_options& options);

/// \ingroup PkgMeridianCut
/// checks choices together with the surface that shall be cut. `cut_to_disc()` does so first.
/// \param s the surface
/// \param options the choices
/// \throws Invalid_input_error if they do not go together, if a vertex or value is not one of the surface, or if the
///   surface has no faces or several pieces
/// \par Complexity
/// Linear.
void check(const Triangle_surface& s, const Cut_options& options);

/// \ingroup PkgMeridianCut
/// \returns the choices with another method, which takes over those of the method before that it has too; choices that
///          do not go with it are taken back
/// \param options the choices
/// \param method the method, as it is made
Cut_options with_method(Cut_options options, Cut_method method);

} // namespace meridian

#endif // MERIDIAN_CUT_CUT_OPTIONS_H
