// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_INTERNAL_PLANAR_SEGMENTS_H
#define MERIDIAN_CUT_INTERNAL_PLANAR_SEGMENTS_H

#include <meridian/base/vectors.h>
#include <meridian/map/embed_in_plane.h>
#include <meridian/surface/Surface_curve.h>
#include <meridian/surface/Triangle_surface.h>

#include <vector>

namespace meridian {
namespace internal {

struct Planar_segment
{
  Index from, to;
}; // vertices of the opened surface

// The minimum spanning tree of the loops among the edges of a constrained Delaunay triangulation of their vertices; a
// vertex that is a loop of its own is a point of it.
std::vector<Planar_segment> spanning_segments(const Triangle_surface& o, const Planar_embedding& plane,
                                              const std::vector<std::vector<Index>>& loops,
                                              const std::vector<Index>& loop_of, Index number_of_loops);

// What a segment meets on its way: vertices and halfedges of the opened surface. Empty if it leaves the domain.
struct Planar_walk
{
  std::vector<Curve_point> points;
};

Planar_walk walk(const Triangle_surface& o, const Planar_embedding& plane, const Planar_segment& segment);

// The walks as curves on the slit surface `s`, with fractions that keep their order on every edge.
std::vector<Surface_curve> place_walks(const Triangle_surface& s, const Triangle_surface& o,
                                       const Planar_embedding& plane, const std::vector<Planar_segment>& segments,
                                       const std::vector<Planar_walk>& walks, const std::vector<Index>& copy_of,
                                       const std::vector<Index>& loop_of);

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_CUT_INTERNAL_PLANAR_SEGMENTS_H
