// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_HANDLES_INTERNAL_FLOW_LOOPS_H
#define MERIDIAN_HANDLES_INTERNAL_FLOW_LOOPS_H

#include <meridian/base/vectors.h>
#include <meridian/curves/Normal_curves.h>
#include <meridian/curves/flow_lines.h>
#include <meridian/curves/passings.h>
#include <meridian/field/Ordered_surface.h>
#include <meridian/surface/Surface_curve.h>
#include <meridian/surface/Triangle_surface.h>

#include <unordered_map>
#include <vector>

namespace meridian {
namespace internal {

// A part of a surface as a surface of its own.
struct Surface_patch
{
  Triangle_surface surface;
  std::vector<Index> vertex_of, face_of;   // of the whole
  std::unordered_map<Index, Index> vertex; // the other way
};

// The faces within a distance of some others. Where the patch would touch itself it is pulled apart; the part that
// holds `start` is kept. Empty if there are more faces than `most`.
Surface_patch cut_patch(const Triangle_surface& s, const std::vector<Index>& faces, Index start, double reach,
                        std::size_t most);

// The edges that a closed polyline crosses once it is pushed a little to its left, off the vertices and edges that it
// runs along. False if that would leave the surface.
bool push_left(const Triangle_surface& s, const std::vector<Curve_point>& loop, std::vector<Edge_place>& crossings);

// A loop of flow lines.
struct Flow_loop
{
  std::vector<Crossing> steps;
  double length;
  Index saddle; // of the whole surface, or nearest to it
};

// The loops that the two lines of one tracer from each of the given saddles make, as far as they meet, placed among
// curves on the whole. The shortest come first.
std::vector<Flow_loop> find_flow_loops(const Normal_curves& curves, const Surface_patch& patch,
                                       const Ordered_surface& m, const std::vector<Index>& saddles,
                                       Flow_tracer& tracer);

// The same closed way, run backwards.
std::vector<Crossing> reversed(const Triangle_surface& s, std::vector<Crossing> steps);

// Adds a loop to curves, as it lies or reversed, if it crosses its partner once and nothing else.
bool try_loop(Normal_curves& curves, Index curve, std::vector<Crossing> steps);

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_HANDLES_INTERNAL_FLOW_LOOPS_H
