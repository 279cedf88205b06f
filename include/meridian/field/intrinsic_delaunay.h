// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FIELD_INTRINSIC_DELAUNAY_H
#define MERIDIAN_FIELD_INTRINSIC_DELAUNAY_H

#include <meridian/base/vectors.h>
#include <meridian/surface/Closed_model.h>
#include <meridian/surface/Triangle_surface.h>

#include <array>
#include <vector>

namespace meridian {

/// \ingroup PkgMeridianOrder
/// a triangulation of a surface by straight lines within it, known by their lengths. Halfedges keep the numbers of the
/// surface at first, but not after flips; two may join the same vertices, and a vertex may be joined to itself.
struct Intrinsic_triangulation
{
  std::vector<Index> next;     ///< of each halfedge
  std::vector<Index> opposite; ///< of each halfedge; -1 on the boundary
  std::vector<Index> source;   ///< of each halfedge
  std::vector<double> length;  ///< of each halfedge, the same for twins

  /// \returns how many halfedges there are
  Index number_of_halfedges() const { return static_cast<Index>(next.size()); }
  /// \param h a halfedge \returns the vertex that it leads to
  Index target(Index h) const { return source[next[h]]; }

  /// \param h a halfedge \returns the area of its face, by Heron's formula as \cite kahan2014 arranged it
  double area(Index h) const;
  /// \param h a halfedge \returns where the third corner of its face lies, `h` on the x axis from the origin, the face
  ///   above
  std::array<double, 2> corner(Index h) const;
  /// \param h a halfedge \returns the cotangent of the angle across from it in its face
  double cotangent(Index h) const;
};

/*!
 * \ingroup PkgMeridianOrder
 *
 * makes the intrinsic Delaunay triangulation of a surface (\cite bobenko2007) by flips (\cite fisher2006): the angles
 * across from an edge add up to at most \f$ \pi \f$.
 *
 * Lengths are bounded below by a millionth of their mean; then all grow alike until in every face two sides are
 * together longer than the third by as much (\cite sharp2020), so that every face has an area. Edges of the boundary
 * stay.
 *
 * \param s the surface
 * \returns its triangulation
 * \par Complexity
 * Linear in the flips, which are about as many as edges in practice; beyond 100 an edge, no more are made.
 */
Intrinsic_triangulation make_intrinsic_delaunay(const Triangle_surface& s);

/// \ingroup PkgMeridianOrder
/// a graph on the nodes of a closed model with a weight on each edge.
struct Weighted_graph
{
  /// nodes as in `make_closed_model()`; `halfedge` is the index of a weight, no halfedge of the surface
  Closed_model graph;
  std::vector<double> weights; ///< positive and symmetric
};

/*!
 * \ingroup PkgMeridianOrder
 *
 * \returns the closed model of a surface joined by the edges of an intrinsic Delaunay triangulation, with their
 *          cotangent weights. They are not negative, so that the maximum principle holds; the little that rounding
 *          leaves below zero, and the zeros across faces on one circle, are raised to a ten-billionth of the mean
 *          weight. Edges of a node to itself are left out.
 * \param s the surface
 * \param t an intrinsic triangulation of `s`
 * \par Complexity
 * Linear.
 */
Weighted_graph make_weighted_graph(const Triangle_surface& s, const Intrinsic_triangulation& t);

/// \ingroup PkgMeridianOrder
/// \param s the surface
/// \returns its closed model joined by its intrinsic Delaunay triangulation. See `make_intrinsic_delaunay()` and
///          `make_weighted_graph()`.
inline Weighted_graph make_intrinsic_delaunay_graph(const Triangle_surface& s)
{
  return make_weighted_graph(s, make_intrinsic_delaunay(s));
}

} // namespace meridian

#endif // MERIDIAN_FIELD_INTRINSIC_DELAUNAY_H
