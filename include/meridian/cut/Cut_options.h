// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_CUT_OPTIONS_H
#define MERIDIAN_CUT_CUT_OPTIONS_H

#include <meridian/base/Progress_observer.h>
#include <meridian/base/names.h>
#include <meridian/base/vectors.h>
#include <meridian/curves/contours.h>
#include <meridian/curves/tighten_curves.h>
#include <meridian/cut/join_generators.h>
#include <meridian/cut/link_boundaries.h>
#include <meridian/field/Field.h>
#include <meridian/field/edge_weights.h>
#include <meridian/handles/preference.h>
#include <meridian/surface/Triangle_surface.h>

#include <array>

namespace meridian {

/// \ingroup PkgMeridianCut
/// where links run.
enum class Link_domain
{
  SURFACE, ///< shortest paths on the surface
  PLANE    ///< counterimages of segments in a planar embedding, where one exists in double precision
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
/// what cuts the handles.
enum class Cut_method
{
  CONTOURS,      ///< a meridian for each handle (Patane 2007, section 3)
  GENERATORS,    ///< a meridian and a longitude for each handle (section 4)
  MORSE,         ///< the descending flow lines of all saddles (Ni, Garland, Hart 2004)
  GEODESIC,      ///< contours of the geodesic distance from a vertex (Steiner, Fischer 2002)
  TREE_COTREE,   ///< edges: the shortest loops at a base point (Erickson, Whittlesey 2005), for the best of several
  GEOMETRY_IMAGE ///< edges: what is left when faces are removed and keep a disc (Gu, Gortler, Hoppe 2002)
};

/// the names of `Cut_method`.
template <> struct Names<Cut_method>
{
  static constexpr std::array<Named_value<Cut_method>, 6> table{{
    {Cut_method::CONTOURS, "contours", "a meridian for each handle, a level line"},
    {Cut_method::GENERATORS, "generators", "a meridian and a longitude for each handle"},
    {Cut_method::MORSE, "morse", "the descending flow lines of all saddles"},
    {Cut_method::GEODESIC, "geodesic", "contours of the geodesic distance from a vertex"},
    {Cut_method::TREE_COTREE, "tree-cotree", "shortest loops of edges at a base point"},
    {Cut_method::GEOMETRY_IMAGE, "geometry-image", "the edges left when faces are removed"},
  }};
};

/// \ingroup PkgMeridianCut
/// what is made shorter before the surface is opened.
enum class Tightening
{
  NONE,   ///< curves stay as they were found
  CURVES, ///< meridians, each within its class; links are shortest paths between them anyway
  GRAPH   ///< the whole cut graph: its vertices move, and ways through the disc take the place of longer curves
};

/// the names of `Tightening`.
template <> struct Names<Tightening>
{
  static constexpr std::array<Named_value<Tightening>, 3> table{{
    {Tightening::NONE, "no", "curves stay as they were found"},
    {Tightening::CURVES, "curves", "meridians, each within its class"},
    {Tightening::GRAPH, "graph", "the whole graph, whose vertices then move and whose paths may change places"},
  }};
};

/// \ingroup PkgMeridianCut
/// what one may choose about a cut. Vertices are those of the surface that is cut.
struct Cut_options : Field_options
{
  Cut_method method = Cut_method::CONTOURS;
  Generator_join join = Generator_join::SURFACE; ///< with `Cut_method::GENERATORS`
  Preference preference = preference::gaussian_curvature;
  Levels levels = Levels::SADDLE;
  Tightening tightening = Tightening::CURVES;
  Tighten_options tighten_options;
  /// whether only edges of the surface are cut, so that there are no new vertices: meridians of contours are moved onto
  /// edges; for other curves, and with `GRAPH`, a cut graph of edges close by is taken
  bool on_edges = false;
  bool refine_where_needed = false; ///< with `on_edges`: divide edges where meridians cannot be moved onto them
  /// with `Cut_method::GEODESIC`: where distances begin, or -1; with `TREE_COTREE`: the base point
  Index source = -1;
  int bases = 16; ///< with `TREE_COTREE` and no source: how many base points are tried
  Link_domain link_domain = Link_domain::SURFACE;
  Link_options links;
  Progress_observer* observer = nullptr;
};

/// \ingroup PkgMeridianCut
/// checks whether choices go together, whatever the surface.
/// \throws Invalid_input_error if one of them would be ignored because of another
void check(const Cut_options& options);

/// \ingroup PkgMeridianCut
/// checks choices together with the surface that shall be cut. `cut_to_disc()` does so first.
/// \throws Invalid_input_error if they do not go together, if a vertex or value is not one of the surface, or if the
///   surface has no faces or several pieces
/// \par Complexity
/// Linear.
void check(const Triangle_surface& s, const Cut_options& options);

/// \ingroup PkgMeridianCut
/// \returns the choices as far as they go with a method; the others are taken back
Cut_options with_method(Cut_options options, Cut_method method);

/// \ingroup PkgMeridianCut
/// \returns whether a method cuts edges alone: it has no field, no meridians and no links
constexpr bool cuts_edges(Cut_method method)
{
  return method == Cut_method::TREE_COTREE || method == Cut_method::GEOMETRY_IMAGE;
}

} // namespace meridian

#endif // MERIDIAN_CUT_CUT_OPTIONS_H
