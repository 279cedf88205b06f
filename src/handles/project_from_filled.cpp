// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/handles/internal/project_from_filled.h>

#include <meridian/base/exceptions.h>
#include <meridian/base/vectors.h>
#include <meridian/curves/passings.h>
#include <meridian/curves/project_contours.h>

#include <algorithm>
#include <utility>

namespace meridian {

namespace internal {

std::vector<std::vector<Piece_crossing>> project_from_filled(const Triangle_surface& root, const Filled_surface& filled,
                                                             const Ordered_surface& m,
                                                             const std::vector<const Contour*>& contours, int& arcs,
                                                             int& loops)
{
  arcs = loops = 0;
  const Triangle_surface& s = filled.surface;
  std::vector<std::vector<Piece_crossing>> result;
  for (const auto& contour : project_crossings(s, m, contours))
  {
    std::vector<Piece_crossing> curve;
    int passes = 0;
    for (const Piece_crossing& c : contour)
    {
      const Index a = s.source(c.halfedge), b = s.target(c.halfedge);
      if (a < filled.vertices && b < filled.vertices)
      {
        // `edge()` is the same on both surfaces
        if (root.number_of_halfedges() > c.halfedge && root.opposite[c.halfedge] >= 0)
        {
          curve.push_back(c);
          continue;
        }
        ++passes; // over the boundary, out or in
        continue;
      }
      // Past vertex u of a fan, on the side that its middle is not on.
      const Index u = a < filled.vertices ? a : b;
      const bool middle_on_left = b >= filled.vertices; // of the way across, whose left is the target
      std::vector<Index> around; // halfedges of the surface that leave u, in the order of the pushed way
      for (Index h = root.outgoing[u]; h >= 0; h = root.turn_left(h)) { around.push_back(h); }
      // In the fan the way goes by u with the middle on one side; in the surface it goes the same way round u.
      if (!middle_on_left) { std::reverse(around.begin(), around.end()); }
      for (Index h : around)
      {
        if (root.opposite[h] < 0) { continue; } // the boundary itself
        // On an edge places are counted from the end with the lower index, and so they are on the spoke: from u.
        const Index e = root.edge(h);
        const bool is_lower = u < root.target(h), from_source = (root.source(e) == u) == is_lower;
        const double t = root.source(e) == u ? 0.02 : 0.98;
        curve.push_back({{middle_on_left ? root.opposite[h] : h, is_lower ? -c.place : c.place, t},
                         e,
                         is_lower ? -1 - c.piece : 2 + c.piece,
                         from_source});
      }
    }
    cancel(root, curve);
    if (curve.size() < 3) { throw Internal_error("project_from_filled: a contour can be pulled to a point"); }
    if (passes == 0) { ++loops; }
    arcs += passes / 2;
    result.push_back(std::move(curve));
  }
  return result;
}

} // namespace internal

} // namespace meridian
