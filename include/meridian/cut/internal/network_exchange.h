// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_INTERNAL_NETWORK_EXCHANGE_H
#define MERIDIAN_CUT_INTERNAL_NETWORK_EXCHANGE_H

#include <meridian/base/vectors.h>
#include <meridian/curves/Gap_graph.h>
#include <meridian/curves/Normal_curves.h>
#include <meridian/curves/chords.h>
#include <meridian/curves/tighten_curves.h>
#include <meridian/cut/internal/disc_walk.h>
#include <meridian/cut/internal/network_moves.h>
#include <meridian/surface/Triangle_surface.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

namespace meridian {
namespace internal {

// Takes out what dangles from a vertex, and the vertex itself if it lies inside a curve only.
void tidy_vertex(Normal_curves& curves, Index v);

// Finds new curves through the disc that a network leaves of its surface. One that ends on different sides of an old
// curve may take its place.
class Network_exchange
{
public:
  explicit Network_exchange(Normal_curves& curves) : m_curves(curves), m_surface(curves.surface()), m_graph(curves) {}

  // Puts shorter curves in the place of others. Returns how many. `pause` is called between tries; it may throw.
  int run(const Tighten_options& options, const std::function<void()>& pause);

private:
  // Where a new curve may begin: at a vertex of the network or of the boundary, or at a crossing of a curve, which is
  // then moved to a vertex.
  struct Root
  {
    Index vertex, crossing;
    std::size_t side;
  };
  // A way through the disc: from node `begin` on back to its root, and from `end` on, which lies on the same region of
  // `face`. The sides of the disc where it begins and ends are known by their curve and direction, or as a piece of
  // boundary by a vertex on it.
  struct Candidate
  {
    double length = std::numeric_limits<double>::infinity();
    Gap_graph::Node begin = -1, end = -1;
    Index face = -1;
    std::array<Disc_side, 2> sides;
  };

  // The vertex that a curve can be moved to from crossing `x`, or -1.
  Index free_vertex_beside(Index x) const;

  void walk();

  // Grows a cell of gaps from every side of the disc. Where two sides' cells touch there is a candidate.
  void grow();

  // A cell begins at a gap beside its root, unless another is nearer.
  void start(const Gap& g, const Root& root);
  void start_at_vertex(Index v, const std::vector<Index>& spokes, std::size_t side);
  void start_on_curve(std::size_t side);
  void start_on_boundary(std::size_t side);

  // At the corner between side `i` and the next.
  void start_at_corner(std::size_t i, const Network_star& star);

  Disc_side known_as(Index root) const;

  // The longest curve whose two sides a candidate separates, and its length; -1 if there is none.
  std::pair<Index, double> longest_between(const Candidate& c) const;

  // The nodes from `n` back to where its cell begins; none if an exchange since then was on the way.
  std::vector<Gap_graph::Node> back_from(Gap_graph::Node n);

  // A curve that may take the place of another.
  struct New_curve
  {
    std::array<Root, 2> roots;
    std::array<Index, 2> ends; // the vertices
    std::vector<Crossing> steps;
  };
  // What an exchange changes.
  struct Changes
  {
    std::set<Index> edges, vertices;
  };

  // The steps along a way, of which `before` come before the face `between`.
  std::vector<Crossing> steps_along(const std::vector<Gap_graph::Node>& way, std::size_t before, Index between);

  // The curve of a candidate, if exchanges before this one have left it its way.
  std::optional<New_curve> find_new_curve(const Candidate& c);

  // Whether no exchange before this one may have put a curve's end in the way.
  bool is_clear(const std::vector<Gap_graph::Node>& way) const;

  // Whether a curve keeps off its ends, and never goes straight back.
  bool is_proper(const New_curve& curve) const;

  void note_change(Index curve, Changes& changes) const;

  // Notes the curves that an exchange may take out.
  void note_removed(const New_curve& curve, Index old, Changes& changes) const;

  // False if there is no room.
  bool put_in(const New_curve& curve);

  void take_out(Index curve);

  // Tightens the curves from `known` on. Returns by how much the network is shorter; 0 if some of them meet.
  double tighten_from(Index known, const Tighten_options& options);

  bool try_exchange(const Candidate& c, const Tighten_options& options);

  Normal_curves& m_curves;
  const Triangle_surface& m_surface;
  std::vector<Disc_side> m_sides;
  std::vector<std::array<std::size_t, 2>> m_place;         // of each curve's sides among them
  std::unordered_map<Index, std::size_t> m_boundary_place; // of pieces of boundary, by the vertex after them
  std::vector<double> m_length;                            // of each curve; 0 if it is gone
  std::vector<Root> m_roots;
  std::set<Index> m_changed_edges, m_changed_vertices; // since the cells were grown
  Gap_graph m_graph;
  std::map<std::pair<std::size_t, std::size_t>, Candidate> m_candidates;
};

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_CUT_INTERNAL_NETWORK_EXCHANGE_H
