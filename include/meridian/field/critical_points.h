// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FIELD_CRITICAL_POINTS_H
#define MERIDIAN_FIELD_CRITICAL_POINTS_H

#include <meridian/base/vectors.h>
#include <meridian/surface/Triangle_surface.h>

#include <vector>

namespace meridian {

/// \ingroup PkgMeridianOrder
/// what an order does at a node.
enum class Critical_kind
{
  MINIMUM, ///< all around is higher
  SADDLE,  ///< the walk around passes more than twice between lower and higher
  MAXIMUM  ///< all around is lower
};

/// \ingroup PkgMeridianOrder
/// a critical node of an order.
struct Critical_point
{
  Index vertex;       ///< the vertex; the first one of a boundary loop
  Critical_kind kind; ///< what it is
  int multiplicity;   ///< of a saddle: `m` where `m + 1` valleys meet; 1 for extrema
};

/*!
 * \ingroup PkgMeridianOrder
 *
 * \returns the critical nodes of an order, in the order of their vertices (\cite banchoff1970)
 *
 * The walk around a regular node passes between lower and higher exactly twice. Boundary loops are nodes, and the walk
 * goes round their collar.
 *
 * \param s the surface
 * \param rank of each vertex; equal on a boundary loop, different otherwise
 * \pre no interior edge joins a boundary loop to itself
 * \post minima - saddles + maxima is the Euler characteristic of the closed model, with saddles counted by multiplicity
 * \par Complexity
 * One comparison a halfedge.
 */
std::vector<Critical_point> find_critical_points(const Triangle_surface& s, const std::vector<Index>& rank);

/// \ingroup PkgMeridianOrder
/// how many critical points there are; saddles by multiplicity.
struct Critical_counts
{
  int minima = 0;  ///< of them
  int maxima = 0;  ///< of them
  int saddles = 0; ///< with their multiplicities
};

/// \ingroup PkgMeridianOrder
/// \param points critical points
/// \returns how many of each kind they are
Critical_counts count(const std::vector<Critical_point>& points);

} // namespace meridian

#endif // MERIDIAN_FIELD_CRITICAL_POINTS_H
