// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CURVES_PLACE_CROSSINGS_H
#define MERIDIAN_CURVES_PLACE_CROSSINGS_H

#include <meridian/base/vectors.h>
#include <meridian/surface/Surface_curve.h>
#include <meridian/surface/Triangle_surface.h>

#include <functional>
#include <vector>

namespace meridian {
namespace internal {

// A crossing of a curve with an edge. On one edge crossings are ordered by (piece, place), integers and the start of a
// piece, counted from the edge's lower end if `from_source` is set and from its higher end otherwise.
struct Crossing
{
  Index halfedge;   // by which the curve leaves a face
  Index edge;       // its edge
  double piece;     // where the piece of the edge begins
  Index place;      // the order within the piece
  double t;         // fraction along `edge`
  bool from_source; // whether (piece, place) grows along `edge`
  Index node = -1;  // crossings with the same number from 0 on stand together on one edge and become one point
};

// The order of crossings on an edge, edge by edge.
bool is_before(const Crossing& a, const Crossing& b);

// Gives every crossing its final fraction and lets curves pass through vertices that they come close to.
//
// `is_free(v)` tells whether a curve may pass through `v` at all. Curves need at least one crossing.
std::vector<Surface_curve> place_crossings(const Triangle_surface& s, const std::vector<std::vector<Crossing>>& curves,
                                           bool closed, const std::function<bool(Index)>& is_free);

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_CURVES_PLACE_CROSSINGS_H
