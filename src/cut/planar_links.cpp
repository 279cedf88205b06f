// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/cut/planar_links.h>

#include <meridian/cut/internal/planar_segments.h>
#include <meridian/map/embed_in_plane.h>
#include <meridian/surface/Surface_curve.h>
#include <meridian/surface/insert_curves.h>
#include <meridian/surface/open_along.h>

namespace meridian {

std::string link_boundaries_in_plane(const Triangle_surface& root, Refined_surface& s, Index source,
                                     std::vector<std::vector<Index>>& links, Make_solver make_solver)
{
  const Opened_surface opened = open_along(s);
  const Triangle_surface o = surface_of(s, opened);
  const auto loops = boundary_loops(o);
  if (loops.empty()) { return "a closed surface has no planar domain"; }

  std::vector<Index> loop_of(o.number_of_vertices(), -1);
  Index number_of_loops = 0;
  for (const auto& loop : loops)
  {
    for (Index h : loop) { loop_of[o.source(h)] = number_of_loops; }
    ++number_of_loops;
  }
  if (source >= 0 && loop_of[source] < 0) { loop_of[source] = number_of_loops++; }
  if (number_of_loops < 2) { return ""; }
  const Planar_embedding plane = embed_in_plane(o, make_solver);
  if (!plane.is_valid) { return "the planar embedding has faces turned over or without area in double precision"; }

  const auto segments = internal::spanning_segments(o, plane, loops, loop_of, number_of_loops);
  if (static_cast<Index>(segments.size()) + 1 != number_of_loops) { return "boundary vertices coincide in the plane"; }
  std::vector<internal::Planar_walk> walks;
  for (const auto& segment : segments)
  {
    walks.push_back(internal::walk(o, plane, segment));
    if (walks.back().points.empty()) { return "a segment leaves the planar domain"; }
  }
  const std::vector<Surface_curve> curves =
    internal::place_walks(s, o, plane, segments, walks, opened.copy_of, loop_of);
  links = insert_curves(root, s, curves).vertices;
  return "";
}

} // namespace meridian
