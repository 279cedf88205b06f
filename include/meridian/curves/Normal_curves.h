// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CURVES_NORMAL_CURVES_H
#define MERIDIAN_CURVES_NORMAL_CURVES_H

#include <meridian/base/vectors.h>
#include <meridian/curves/internal/face_chords.h>
#include <meridian/surface/Triangle_surface.h>

#include <vector>

namespace meridian {

/*!
 * \ingroup PkgMeridianGenerators
 *
 * curves in normal position: they cross edges, never pass through a vertex, and the crossings of every edge stand in a
 * total order. A curve is closed, or open and ends at two vertices.
 *
 * Sequences of edges and orders on edges are all that the topology is read from: between two crossings a curve runs
 * through a face as a chord, and two chords cross if and only if their ends alternate around the face. An open curve
 * leaves its first vertex, and comes to its last, across the edge on the other side of a face; or it runs along one
 * edge and crosses none. Where on its edge a crossing lies is a number beside it, for lengths alone. Closed curves `2i`
 * and `2i + 1` are partners, who may cross; no two others do.
 */
class Normal_curves : public internal::Face_chords
{
public:
  /// a crossing to be made: in gap `place` of its edge. Several in one gap are ordered by `t`.
  struct Step
  {
    Index halfedge, place;
    double t;
  };

  /// The surface must outlive the curves.
  Normal_curves(const Triangle_surface& surface, Index curves) : Face_chords(surface, curves) {}
  Normal_curves(Triangle_surface&& surface, Index curves) = delete;

  /// adds a closed curve, which must not be there yet.
  void add(Index curve, const std::vector<Step>& steps);
  /// adds an open curve. Without steps it runs along the edge that joins its ends, which nothing may cross.
  /// \returns the curve
  Index add(Index from, Index to, const std::vector<Step>& steps);
  void remove(Index curve);

  /// \returns for each pair how often its curves cross each other
  /// \throws Internal_error if other chords cross, or a chord has both ends on one edge
  std::vector<Index> count_crossings() const;
  /// \returns whether a curve is simple and crosses its partner once, and nothing else
  bool crosses_partner_once(Index curve) const;
  /// \returns whether a curve is simple and crosses no other
  bool is_disjoint(Index curve) const;
  /// \returns whether a curve that crosses its partner once crosses it from right to left
  bool runs_from_right(Index curve) const;

private:
  // Counts where partners cross. False if others do, or if a chord has both ends on one edge.
  bool count_in_faces(std::vector<Index>& faces, std::vector<Index>& count) const;
  void find_meeting(Index curve);
  // Appends the crossings of a curve that has none, and joins them in order.
  void link_new(Index curve, const std::vector<Step>& steps);
};

namespace internal {

double length(const Normal_curves& curves, Index c);

} // namespace internal

} // namespace meridian

#endif // MERIDIAN_CURVES_NORMAL_CURVES_H
