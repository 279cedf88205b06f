// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CURVES_PLACE_CROSSINGS_H
#define MERIDIAN_CURVES_PLACE_CROSSINGS_H

#include <meridian/base/vectors.h>
#include <meridian/surface/Surface_curve.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/edge_places.h>

#include <functional>
#include <vector>

namespace meridian {
namespace internal {

// A crossing of a curve of pieces. On one edge such crossings are ordered by (piece, place), integers and the start of
// a piece, counted from the edge's lower end if `from_source` is set and from its higher end otherwise.
struct Piece_crossing : Crossing
{
  Index edge;              // that of its halfedge
  double piece = 0;        // where the piece of the edge begins; `place` is the order within the piece
  bool from_source = true; // whether (piece, place) grows along `edge`
  Index node = -1;         // crossings with the same number from 0 on stand together on one edge and become one point
};

// The order of crossings on an edge, edge by edge.
bool is_before(const Piece_crossing& a, const Piece_crossing& b);

// Gives every crossing its final fraction and lets curves pass through vertices that they come close to.
//
// `is_free(v)` tells whether a curve may pass through `v` at all. Curves need at least one crossing.
std::vector<Surface_curve> place_crossings(const Triangle_surface& s,
                                           const std::vector<std::vector<Piece_crossing>>& curves, bool closed,
                                           const std::function<bool(Index)>& is_free);

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_CURVES_PLACE_CROSSINGS_H
