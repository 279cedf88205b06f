// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CURVES_INTERNAL_FLOW_DIRECTION_H
#define MERIDIAN_CURVES_INTERNAL_FLOW_DIRECTION_H

#include <meridian/base/vectors.h>
#include <meridian/field/Ordered_surface.h>
#include <meridian/surface/Refined_surface.h>

#include <utility>

namespace meridian {
namespace internal {

// Which way is down on an ordered surface: by ranks between vertices, by values in faces. For ascending lines it is up.
class Flow_direction
{
public:
  Flow_direction(const Ordered_surface& m, bool descends) : m_ordered(m), m_surface(m.surface), m_descends(descends) {}

  bool descends() const { return m_descends; }
  Index node(Index v) const { return m_ordered.graph.node[v]; }
  Index rank(Index v) const { return m_descends ? m_ordered.rank[v] : -m_ordered.rank[v]; }
  bool is_down(Index h, Index v) const { return rank(m_surface.target(h)) < rank(v); }
  Index lower_end(Index h) const
  {
    return rank(m_surface.source(h)) < rank(m_surface.target(h)) ? m_surface.source(h) : m_surface.target(h);
  }

  // Downwards in a face, as a vector in it, by the field in the finest scale of its corners.
  Point slope(Index f) const;
  // How steep the field is along an edge, whichever way.
  double steepness(Index h) const;
  bool flows_out(Index h) const { return dot(slope(m_surface.face(h)), outwards(h)) > 0; }
  // How far along `h` the way down from point `p` of its face leaves through it, and when; never if it does not.
  std::pair<double, double> leave(Index h, const Point& p) const;

private:
  Point normal(Index f) const;
  Point outwards(Index h) const;

  const Ordered_surface& m_ordered;
  const Refined_surface& m_surface;
  bool m_descends;
};

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_CURVES_INTERNAL_FLOW_DIRECTION_H
