// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/curves/project_contours.h>

#include <meridian/base/exceptions.h>
#include <meridian/base/vectors.h>
#include <meridian/curves/passings.h>
#include <meridian/surface/root_edges.h>

#include <algorithm>
#include <utility>

namespace meridian {

namespace internal {

std::vector<std::vector<Piece_crossing>> project_crossings(const Triangle_surface& root, const Ordered_surface& m,
                                                           const std::vector<const Contour*>& contours)
{
  std::vector<std::vector<Piece_crossing>> curves;
  for (const Contour* contour : contours)
  {
    std::vector<Piece_crossing> curve;
    for (Index h : contour->halfedges)
    {
      Root_stretch on;
      if (!find_stretch(root, m.surface, h, on)) { continue; }
      // Fractions and places are counted from the lower of the two ends, the same for both halfedges.
      const double t = on.at[0] + crossing_fraction(m, h, contour->level) * (on.at[1] - on.at[0]);
      const bool rises = on.at[0] < on.at[1]; // the level grows from source to target
      const Index edge = root.edge(on.halfedge);
      const bool from_source = root.source(edge) == on.lower;
      curve.push_back({{on.halfedge, rises ? contour->level : -contour->level, from_source ? t : 1 - t},
                       edge,
                       std::min(on.at[0], on.at[1]),
                       from_source});
    }
    cancel(root, curve);
    if (curve.empty()) { throw Internal_error("project_contours: a contour can be pulled to a point"); }
    curves.push_back(std::move(curve));
  }
  return curves;
}

} // namespace internal

std::vector<Surface_curve> project_contours(const Triangle_surface& root, const Ordered_surface& m,
                                            const std::vector<const Contour*>& contours)
{
  return internal::place_crossings(root, internal::project_crossings(root, m, contours), true,
                                   [&](Index v) { return !root.is_boundary_vertex(v); });
}

} // namespace meridian
