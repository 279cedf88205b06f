// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CURVES_FIND_CROSSING_LOOP_H
#define MERIDIAN_CURVES_FIND_CROSSING_LOOP_H

#include <meridian/base/vectors.h>
#include <meridian/curves/Gap_graph.h>
#include <meridian/curves/Normal_curves.h>
#include <meridian/surface/Triangle_surface.h>

#include <limits>
#include <vector>

namespace meridian {
namespace internal {

// A way through gaps, each with the face by which the next one is reached.
struct Gap_walk
{
  struct Stop
  {
    Gap gap;
    Index face_after;
  };
  std::vector<Stop> stops;
};

struct Crossing_loop
{
  std::vector<Crossing> steps;
  double across; // from one side of the curve to the other, through the middles of gaps
  double length; // and back along the curve
};

// Searches for loops; keeps what it knows of the gaps from one search to the next.
class Crossing_loop_search
{
public:
  explicit Crossing_loop_search(const Normal_curves& curves)
    : m_curves(curves), m_surface(curves.surface()), m_graph(curves)
  {}

  explicit Crossing_loop_search(Normal_curves&& curves) = delete;

  // The shortest closed walk that crosses curve `m` once, from right to left, and no other curve: from the left side of
  // the curve through gaps to its right side, and along that side back to where it began. If the curve does not
  // separate the surface cut along the others there is one.
  Crossing_loop find(Index m);

  // Takes notice of a curve that was added since.
  void note_added(Index curve) { m_graph.forget_around(curve); }

private:
  // The shortest way known from one side to the other, by a node on it.
  struct Way
  {
    double length = std::numeric_limits<double>::infinity();
    Gap_graph::Node node = -1;
  };

  Way search(Index m);

  // The way as a walk from the left side to the right side, and its length.
  Gap_walk walk_along(const Way& way, double& length);

  // Goes back from beside crossing `last` to beside crossing `first` along the right side of their curve, the shorter
  // way round.
  Crossing_loop close(Gap_walk walk, double across, Index first, Index last);

  const Normal_curves& m_curves;
  const Triangle_surface& m_surface;
  Gap_graph m_graph;
};

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_CURVES_FIND_CROSSING_LOOP_H
