// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_INTERNAL_NETWORK_MOVES_H
#define MERIDIAN_CUT_INTERNAL_NETWORK_MOVES_H

#include <meridian/base/vectors.h>
#include <meridian/curves/Normal_curves.h>
#include <meridian/curves/tighten_curves.h>

#include <initializer_list>
#include <optional>
#include <vector>

namespace meridian {
namespace internal {

// Moves of the vertices in which the open curves of a network meet. All of them keep the network's class.

using Network_end = Normal_curves::End;

// The star of a vertex where curves end. Spoke `i` is the i-th halfedge that leaves it, counterclockwise; corner `i`
// lies between spokes `i` and `i + 1`. A curve's end stands on a spoke (at `2 i`) or in a corner (at `2 i + 1`).
struct Network_star
{
  struct Arm
  {
    Network_end end;
    Index at;
    Index place;
    double angle;
  }; // `place` orders the arms of one corner
  std::vector<Index> spokes;
  std::vector<double> angle; // of each spoke, counterclockwise from the first
  double whole = 0;          // the angle of all corners
  std::vector<Arm> arms;     // counterclockwise
  bool is_closed = true;     // whether the vertex lies inside the surface
};

Network_star make_star(const Normal_curves& curves, Index v);

// The spokes strictly between two places of a star, counterclockwise.
std::vector<Index> spokes_between(const Network_star& star, Index from, Index to);

// Moves an arm's end from vertex `v` to `to`, which lies at place `at` of the star: from there the curve follows the
// edge back to `v` and goes round `v` on the right of the edge (seen from `v`), or on its left, to where it ran before.
void drag(Normal_curves& curves, const Network_star& star, Index v, const Network_star::Arm& arm, Index to, Index at,
          bool on_right);

double curve_length(const Normal_curves& curves, Index c);

// The length of all curves that end at some vertices.
double length_around(const Normal_curves& curves, std::initializer_list<Index> vertices);

void tighten_around(Normal_curves& curves, std::initializer_list<Index> vertices, const Tighten_options& options);

// A way to move a vertex of the network, or two arms of it, along an edge. Where three arms meet, all move; where more
// do, the two on both sides of the edge, and a new curve along the edge joins them to the others.
struct Vertex_move
{
  double slope;
  Index to, at;
};

// The moves that promise to make the network shorter, the best first. On the boundary of the surface the outer arm
// slides along it.
std::vector<Vertex_move> find_vertex_moves(const Normal_curves& curves, const Network_star& star);

void apply(Normal_curves& curves, const Network_star& star, Index v, const Vertex_move& move);

// Moves a vertex once, if that makes the network shorter. Returns where it went, or nothing.
std::optional<Index> move_vertex(Normal_curves& curves, Index v, const Tighten_options& options);

// Draws all curves that end at the far end of a curve along an edge to its near end, which takes that curve out.
void contract(Normal_curves& curves, Index curve, bool to_last);

// Where two vertices are joined by one edge, draws them together and parts them the other way. Returns whether that
// makes the network shorter.
bool exchange_neighbors(Normal_curves& curves, Index curve, const Tighten_options& options);

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_CUT_INTERNAL_NETWORK_MOVES_H
