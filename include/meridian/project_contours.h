// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_PROJECT_CONTOURS_H
#define MERIDIAN_PROJECT_CONTOURS_H

#include <meridian/contours.h>
#include <meridian/internal/place_crossings.h>

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
      const Refined_surface& s = m.surface;
      std::array<Index, 2> ends;
      std::array<double, 2> at;
      if (!on_common_root_edge(s.origin(s.source(h)), s.origin(s.target(h)), ends, at)) { continue; }
      const auto& corner = root.triangles[s.face_of[s.face(h)]];
      Index crossed = -1;
      for (Index k = 0; k < 3; ++k)
      {
        const std::array<Index, 2> side{corner[k], corner[(k + 1) % 3]};
        if (std::min(side[0], side[1]) == ends[0] && std::max(side[0], side[1]) == ends[1]) { crossed = 3 * s.face_of[s.face(h)] + k; }
      }
      if (crossed < 0) { throw Internal_error("project_contours: an edge does not lie on the face it came from"); }
      // Fractions and places are counted from the lower of the two ends, the same for both halfedges.
      const double t = at[0] + crossing_fraction(m, h, contour->level) * (at[1] - at[0]);
      const bool rises = at[0] < at[1]; // the level grows from source to target
      const Crossing c{crossed, root.edge(crossed), std::min(at[0], at[1]), rises ? contour->level : -contour->level,
                                 root.source(root.edge(crossed)) == ends[0] ? t : 1 - t,
                                 root.source(root.edge(crossed)) == ends[0]};
      if (!curve.empty() && root.opposite[curve.back().halfedge] == c.halfedge) { curve.pop_back(); }
      else { curve.push_back(c); }
    }
    std::size_t first = 0, last = curve.size();
    while (last - first >= 2 && root.opposite[curve[last - 1].halfedge] == curve[first].halfedge) { ++first; --last; }
    curve = {curve.begin() + first, curve.begin() + last};
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

#endif // MERIDIAN_PROJECT_CONTOURS_H
