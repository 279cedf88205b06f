// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_SURFACE_INTERNAL_SPLIT_FACE_H
#define MERIDIAN_SURFACE_INTERNAL_SPLIT_FACE_H

#include <meridian/base/vectors.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/edge_places.h>

#include <array>
#include <utility>
#include <vector>

namespace meridian {
namespace internal {

// A new vertex inside an edge; `halfedge` is the edge.
struct New_vertex : Edge_place
{
  Index vertex;
};
// Two vertices on the rim of a face.
struct Chord
{
  Index face;
  Index from, to;
};

// A corner of the polygon that a face becomes. `sides` has a bit for each side of the face it lies on.
struct Rim_vertex
{
  Index vertex;
  unsigned sides;
};
using Rim = std::vector<Rim_vertex>;
using Triangles = std::vector<std::array<Index, 3>>;

// Sine of the smallest angle of a triangle, in [0, 0.87].
double shape(const Point& a, const Point& b, const Point& c);

// Triangulates a convex polygon so that the smallest angle is largest. Triangles whose corners all lie on
// one side of the face have no area and are never used; that is decided by the side bits alone.
void triangulate_part(const std::vector<Point>& points, const Rim& rim, Triangles& out);

// Divides a polygon by chords that do not cross, one chord at a time.
void split_part(const std::vector<Point>& points, const Rim& whole,
                const std::vector<std::pair<Index, Index>>& all_chords, Triangles& out);

// Splits every face that holds a chord or has a new point on its rim, and repairs the twins around.
void split_faces(Refined_surface& s, std::vector<New_vertex>& new_vertices, std::vector<Chord>& chords,
                 Index& first_new_face, std::vector<Index>& parent);

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_SURFACE_INTERNAL_SPLIT_FACE_H
