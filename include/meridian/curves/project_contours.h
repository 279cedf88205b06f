// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CURVES_PROJECT_CONTOURS_H
#define MERIDIAN_CURVES_PROJECT_CONTOURS_H

#include <meridian/curves/contours.h>
#include <meridian/curves/passings.h>
#include <meridian/curves/place_crossings.h>
#include <meridian/surface/root_edges.h>

namespace meridian {

namespace internal {

// The crossings of contours with the edges of the root, in an order on every edge.
inline std::vector<std::vector<Crossing>> project_crossings(const Triangle_surface& root, const Ordered_surface& m,
                                                            const std::vector<const Contour*>& contours)
{
  std::vector<std::vector<Crossing>> curves;
  for (const Contour* contour : contours)
  {
    std::vector<Crossing> curve;
    for (Index h : contour->halfedges)
    {
      Root_stretch on;
      if (!find_stretch(root, m.surface, h, on)) { continue; }
      // Fractions and places are counted from the lower of the two ends, the same for both halfedges.
      const double t = on.at[0] + crossing_fraction(m, h, contour->level) * (on.at[1] - on.at[0]);
      const bool rises = on.at[0] < on.at[1]; // the level grows from source to target
      const Index edge = root.edge(on.halfedge);
      const bool from_source = root.source(edge) == on.lower;
      curve.push_back({on.halfedge, edge, std::min(on.at[0], on.at[1]), rises ? contour->level : -contour->level,
                       from_source ? t : 1 - t, from_source});
    }
    cancel(root, curve);
    if (curve.empty()) { throw Internal_error("project_contours: a contour can be pulled to a point"); }
    curves.push_back(std::move(curve));
  }
  return curves;
}

} // namespace internal

/*!
 * \ingroup PkgMeridianContours
 *
 * \returns disjoint contours as curves on the surface that was ordered to begin with
 *
 * Only crossings with edges of the root are kept. Where a contour then turns back across the edge it came by, it is
 * pulled over; what it passed there was a vertex of the finer model only. On each edge the crossings keep the order
 * that the levels give them, and a small distance from each other and from the ends. A contour that passes close by
 * a vertex goes through it, unless the vertex lies on the boundary or another curve is in the way.
 *
 * \param root the surface that `m.surface` refines
 * \param m the ordered surface
 * \param contours contours of `m`, all different
 *
 * \post the curves are closed, simple and disjoint, and homotopic to the contours on the root
 * \throws Internal_error if a contour can be pulled to a point
 * \par Complexity
 * \f$ O(k \log k) \f$ for `k` crossings
 */
inline std::vector<Surface_curve> project_contours(const Triangle_surface& root, const Ordered_surface& m,
                                                   const std::vector<const Contour*>& contours)
{
  return internal::place_crossings(root, internal::project_crossings(root, m, contours), true,
                                   [&](Index v) { return !root.is_boundary_vertex(v); });
}

} // namespace meridian

#endif // MERIDIAN_CURVES_PROJECT_CONTOURS_H
