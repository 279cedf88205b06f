// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_HANDLES_INTERNAL_DUAL_LOOPS_H
#define MERIDIAN_HANDLES_INTERNAL_DUAL_LOOPS_H

#include <meridian/base/Euler_tour.h>
#include <meridian/base/Progress_observer.h>
#include <meridian/base/vectors.h>
#include <meridian/curves/Normal_curves.h>
#include <meridian/curves/contours.h>
#include <meridian/curves/passings.h>
#include <meridian/surface/Closed_model.h>
#include <meridian/surface/Surface_curve.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/measures.h>

#include <boost/dynamic_bitset.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace meridian {
namespace internal {

// A closed strip of faces, each of them once, and its class in the first homology of the closed model modulo 2.
struct Dual_loop
{
  std::vector<Edge_place> crossings;
  double length, length_found;
  boost::dynamic_bitset<> parity;
};

// A spanning tree of the nodes of a closed model and one of its faces that cross no common edge. The tree's loops of
// the edges in neither are a basis; how often a strip of faces crosses them, modulo 2, is its class.
class Node_tree
{
public:
  Node_tree(const Triangle_surface& s, const Closed_model& g);

  std::size_t rank() const { return m_edges.size(); }

  boost::dynamic_bitset<> parity_of(const std::vector<Edge_place>& strip) const;

private:
  const Triangle_surface& m_surface;
  const Closed_model& m_graph;
  std::vector<Index> m_edges; // in neither tree
  Euler_tour m_tour;          // of the nodes' tree; its steps are halfedges
};

// The shortest loops through one face that are a basis: a tree of shortest ways through faces, and of the other edges a
// spanning tree of the nodes with the longest loops (Erickson, Whittlesey 2005).
std::vector<Dual_loop> loops_at(const Triangle_surface& s, const Closed_model& g, Index base, std::vector<double>& far);

// Of loops, the shortest first, those that are independent of the ones before.
std::vector<Dual_loop> choose_basis(std::vector<Dual_loop> loops, std::size_t wanted);

// Candidates for a short basis: the loops that make one from each of several faces far apart, and others; of these the
// shortest.
std::vector<Dual_loop> find_dual_loops(const Triangle_surface& s, int bases, std::size_t wanted,
                                       const std::vector<std::vector<Edge_place>>& others, const Progress& progress);

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_HANDLES_INTERNAL_DUAL_LOOPS_H
