// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FIELD_ORDERED_SURFACE_H
#define MERIDIAN_FIELD_ORDERED_SURFACE_H

#include <meridian/base/vectors.h>
#include <meridian/field/Node_order.h>
#include <meridian/field/Scalar_field.h>
#include <meridian/field/critical_points.h>
#include <meridian/surface/Closed_model.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/Triangle_surface.h>

#include <functional>
#include <string>
#include <vector>

namespace meridian {

/// \ingroup PkgMeridianOrder
/// a surface with a field and an order whose saddles are all simple: what contours are traced on.
///
/// It may be finer than its root: interior edges that join a boundary loop to itself are divided, and so is the star of
/// a multiple saddle. Curves are carried back by `project_contours()`, so that nothing of this reaches the result.
struct Ordered_surface
{
  Refined_surface surface;              ///< the surface, refined
  Closed_model graph;                   ///< of `surface`
  Scalar_field field;                   ///< on the nodes of `graph`
  std::string field_name;               ///< for reports
  Node_order order;                     ///< of the nodes of `graph`
  std::vector<Index> rank;              ///< of the node of each vertex
  std::vector<Critical_point> critical; ///< of the order, before unfolding
  /// where a level line crosses an edge, as a fraction of the way from its lower end to its higher one, given the
  /// values of the field at these and at the level; empty: linear
  std::function<double(double low, double high, double level)> placement;
};

/// \ingroup PkgMeridianOrder
/// \param root a surface
/// \returns it with every interior edge divided that joins a boundary loop to itself
Refined_surface divide_chords(const Triangle_surface& root);

/*!
 * \ingroup PkgMeridianOrder
 *
 * divides each saddle of multiplicity `m` into `m` simple saddles.
 *
 * The star of a multiple saddle `v` is divided by a ring of new vertices. Those of two valleys stay below `v`, which
 * makes `v` simple; those of every further valley come above it, one valley after the other, and its first vertex is
 * the saddle that joins it. All other new vertices are regular.
 *
 * \param root the surface that `m.surface` refines
 * \param m surface, graph, field, order, rank and critical points; all but the last are brought up to date
 * \post all saddles are simple, and their number is the sum of the multiplicities
 * \par Complexity
 * Linear in the size of the stars of the multiple saddles, and one pass over the surface if there is any.
 */
void unfold_saddles(const Triangle_surface& root, Ordered_surface& m);

} // namespace meridian

#endif // MERIDIAN_FIELD_ORDERED_SURFACE_H
