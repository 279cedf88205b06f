// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FIELD_INTERNAL_SIMPLIFY_ORDER_H
#define MERIDIAN_FIELD_INTERNAL_SIMPLIFY_ORDER_H

#include <meridian/base/vectors.h>
#include <meridian/surface/Closed_model.h>

#include <cstdint>
#include <vector>

namespace meridian {
namespace internal {

// A priority queue of distinct numbers 0 .. n-1: a tree of 64-bit words, a few steps an operation.
class Bit_queue
{
public:
  explicit Bit_queue(std::size_t n);
  bool empty() const { return m_levels.back()[0] == 0; }
  void push(std::size_t i);
  std::size_t pop(); // the smallest

private:
  std::vector<std::vector<std::uint64_t>> m_levels;
};

bool has_other_extrema(const Closed_model& g, const std::vector<Index>& rank, const std::vector<char>& allowed,
                       bool low);

// Floods the graph from `seeds`, always on to the lowest node in reach (the highest, if not `up`), and returns the
// nodes in that order, lowest first: every node but the seeds then has a neighbour on the flooded side.
std::vector<Index> sweep(const Closed_model& g, const std::vector<Index>& nodes, const std::vector<Index>& rank,
                         const std::vector<Index>& seeds, bool up);

// An st-numbering (Tarjan 1986, "Two streamlined depth-first search algorithms"): every node but the minima has a
// lower neighbour, every node but the maxima a higher one. A source joined to all minima, a sink joined to all maxima
// and an edge from source to sink are added for the search, and left out of the result.
std::vector<Index> st_numbering(const Closed_model& g, const std::vector<Index>& minima,
                                const std::vector<Index>& maxima);

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_FIELD_INTERNAL_SIMPLIFY_ORDER_H
