// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_INTERNAL_MINIMUM_SPANNING_TREE_H
#define MERIDIAN_CUT_INTERNAL_MINIMUM_SPANNING_TREE_H

#include <meridian/base/vectors.h>

#include <cstddef>
#include <vector>

namespace meridian {
namespace internal {

// A candidate for an edge of a spanning tree; several may join the same two vertices.
struct Spanning_edge
{
  Index from, to;
  double weight;
};

// The edges of a minimum spanning forest of the vertices 0 to `vertices` - 1, as indices into `edges`, by ascending
// weight (Kruskal 1956, by Boost.Graph). Of edges of one weight any may be taken.
std::vector<std::size_t> minimum_spanning_tree(Index vertices, const std::vector<Spanning_edge>& edges);

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_CUT_INTERNAL_MINIMUM_SPANNING_TREE_H
