// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CURVES_PROJECT_CONTOURS_H
#define MERIDIAN_CURVES_PROJECT_CONTOURS_H

#include <meridian/curves/contours.h>
#include <meridian/curves/place_crossings.h>

namespace meridian {

namespace internal {

// Where a halfedge of a refined surface lies on an edge of its root: the halfedge of the root, in the face that holds
// the one given, and the fractions of the two ends, counted from the lower of the edge's vertices.
struct Root_stretch
{
  Index halfedge;
  Index lower;
  std::array<double, 2> at;
};

// False if it lies inside a face of the root.
inline bool find_stretch(const Triangle_surface& root, const Refined_surface& s, Index h, Root_stretch& found)
{
  std::array<Index, 2> ends;
  if (!on_common_root_edge(s.origin(s.source(h)), s.origin(s.target(h)), ends, found.at)) { return false; }
  const Index f = s.face_of[s.face(h)];
  for (Index k = 3 * f; k < 3 * f + 3; ++k)
    if (std::min(root.source(k), root.target(k)) == ends[0] && std::max(root.source(k), root.target(k)) == ends[1])
    {
      found.halfedge = k;
      found.lower = ends[0];
      return true;
    }
  throw Internal_error("find_stretch: an edge does not lie on the face it came from");
}

// Takes crossings out of a closed sequence that are taken back at once.
template <class Sequence> void cancel(const Triangle_surface& s, Sequence& crossings)
{
  Sequence kept;
  for (const auto& c : crossings)
  {
    if (!kept.empty() && s.opposite[kept.back().halfedge] == c.halfedge) { kept.pop_back(); }
    else { kept.push_back(c); }
  }
  std::size_t first = 0, last = kept.size();
  while (last - first >= 2 && s.opposite[kept[last - 1].halfedge] == kept[first].halfedge)
  {
    ++first;
    --last;
  }
  crossings = {kept.begin() + first, kept.begin() + last};
}

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
