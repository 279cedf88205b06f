// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_BASE_EULER_TOUR_H
#define MERIDIAN_BASE_EULER_TOUR_H

#include <meridian/base/vectors.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace meridian {
namespace internal {

// A walk round a tree (Tarjan, Vishkin 1985): what hangs below a node is entered between its own enter and leave. The
// proof has one of its own, on purpose.
struct Euler_tour
{
  std::vector<Index> enter, leave; // of each node; -1 where the tree does not come
  std::vector<char> is_down;       // of each step, whether it leads away from the root
};

// `steps_at[a]` holds the steps from node `a` to its neighbours in the tree, `target(step)` the node that one leads to.
template <class Target>
Euler_tour walk_tree(const std::vector<std::vector<Index>>& steps_at, Index root, Index number_of_steps,
                     const Target& target)
{
  Euler_tour tour{std::vector<Index>(steps_at.size(), -1), std::vector<Index>(steps_at.size(), -1),
                  std::vector<char>(number_of_steps, 0)};
  std::vector<std::pair<Index, std::size_t>> stack{{root, 0}};
  Index time = 0;
  tour.enter[root] = time++;
  while (!stack.empty())
  {
    auto& [a, next] = stack.back();
    if (next == steps_at[a].size())
    {
      tour.leave[a] = time;
      stack.pop_back();
      continue;
    }
    const Index step = steps_at[a][next++], b = target(step);
    if (tour.enter[b] >= 0) { continue; }
    tour.is_down[step] = 1;
    tour.enter[b] = time++;
    stack.emplace_back(b, 0);
  }
  return tour;
}

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_BASE_EULER_TOUR_H
