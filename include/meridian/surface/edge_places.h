// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_SURFACE_EDGE_PLACES_H
#define MERIDIAN_SURFACE_EDGE_PLACES_H

#include <meridian/surface/Triangle_surface.h>

namespace meridian {

/// \ingroup PkgMeridianSurface
/// a place inside an edge, told by a fraction: where a curve is drawn.
struct Edge_place
{
  Index halfedge = -1; ///< a halfedge of the edge; of a curve, that by which it leaves a face
  double t = 0;        ///< the fraction along `halfedge`, from its source (0) to its target (1)
};

/// \ingroup PkgMeridianSurface
/// a place inside an edge, told by an order: where a curve passes among others. No topology is read from `t`.
struct Crossing
{
  Index halfedge = -1; ///< by which the curve leaves a face
  Index place = 0;     ///< how many crossings of the edge come before it, from the source of `edge(halfedge)` on
  double t = 0;        ///< the fraction along `edge(halfedge)`, for lengths alone
};

/// \ingroup PkgMeridianSurface
/// a stretch of an edge between two crossings, or a crossing and an end: where one more curve could pass.
struct Gap
{
  Index edge = -1; ///< the edge
  Index place = 0; ///< how many crossings come before it, from the source of `edge` on
  /// \param g another \returns whether it comes after this one
  bool operator<(const Gap& g) const { return edge != g.edge ? edge < g.edge : place < g.place; }
  /// \param g another \returns whether it is the same
  bool operator==(const Gap& g) const { return edge == g.edge && place == g.place; }
};

/// \ingroup PkgMeridianSurface
/// \returns a fraction along a halfedge as one along its edge, or a fraction along the edge as one along the halfedge
/// \param s the surface
/// \param h the halfedge
/// \param t the fraction
inline double turn_fraction(const Triangle_surface& s, Index h, double t) { return s.edge(h) == h ? t : 1 - t; }

} // namespace meridian

#endif // MERIDIAN_SURFACE_EDGE_PLACES_H
