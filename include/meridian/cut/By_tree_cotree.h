// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_BY_TREE_COTREE_H
#define MERIDIAN_CUT_BY_TREE_COTREE_H

#include <meridian/base/choices.h>
#include <meridian/base/vectors.h>
#include <meridian/cut/Edge_metric.h>
#include <meridian/surface/Triangle_surface.h>

namespace meridian {

struct Cut_job;

/// \ingroup PkgMeridianCut
/// cuts edges: the shortest loops at a base point (\cite erickson2005), for the best of several.
struct By_tree_cotree
{
  /// its name in reports and options
  static constexpr Choice_name names{"tree-cotree", "shortest loops of edges at a base point"};
  static constexpr bool cuts_edges = true;        ///< whether it finds a whole cut graph of edges
  static constexpr bool moves_onto_edges = false; ///< whether its curves can be moved onto edges one by one
  Index source = -1;                              ///< the base point; -1: several are tried
  int bases = 16;                                 ///< how many, if none is named
  Edge_metric metric = {};                        ///< how long edges count; empty: their length
  /// cuts the handles.
  /// \param job the surface and the choices, and what is filled
  void cut_handles(Cut_job& job) const;
};

/// \ingroup PkgMeridianCut
/// checks choices of this method alone.
/// \param method the choices
/// \throws Invalid_input_error if they do not go together
void check(const By_tree_cotree& method);

/// \ingroup PkgMeridianCut
/// checks choices of this method for a surface.
/// \param s the surface
/// \param method the choices
/// \throws Invalid_input_error if they do not go together or a vertex is not one of the surface
void check(const Triangle_surface& s, const By_tree_cotree& method);

} // namespace meridian

#endif // MERIDIAN_CUT_BY_TREE_COTREE_H
