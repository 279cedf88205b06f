// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_HANDLES_INTERNAL_ARC_LONGITUDES_H
#define MERIDIAN_HANDLES_INTERNAL_ARC_LONGITUDES_H

#include <meridian/base/Progress_observer.h>
#include <meridian/base/Stage_runner.h>
#include <meridian/base/vectors.h>
#include <meridian/curves/Normal_curves.h>
#include <meridian/curves/find_crossing_loop.h>

#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace meridian {
namespace internal {

// The contract, on normal curves.
void check_contract(const Normal_curves& curves);

// Finds longitudes, the shortest first: one is taken when no other could be shorter. Curves that are there only
// lengthen the way of the others, so a way is the shortest still if nothing has come to its edges since it was found.
//
// `take_flow(i, loop)` may add another curve in place of `loop`, and says whether it did.
template <class Take_flow>
void add_shortest_longitudes(Normal_curves& curves, Index pairs, const Stage_runner& run, const Take_flow& take_flow)
{
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  constexpr double enough = 1.1; // a loop need not be searched for again that is at most so much longer than the next
  Crossing_loop_search searcher(curves);
  std::vector<Crossing_loop> loops(pairs);
  std::vector<std::vector<std::size_t>> crowd(pairs); // how many crossings the edges of a loop had
  const auto count = [&](Index i) {
    std::vector<std::size_t> sizes;
    for (const auto& step : loops[i].steps) { sizes.push_back(curves.on(curves.surface().edge(step.halfedge)).size()); }
    return sizes;
  };
  const auto search = [&](Index i) {
    loops[i] = searcher.find(2 * i);
    crowd[i] = count(i);
  };
  for (Index i = 0; i < pairs; ++i)
  {
    search(i);
    queue.emplace(loops[i].length, i);
    run.progress(Stage::LONGITUDES, (i + 1.) / (2 * pairs));
  }
  for (Index done = 0; !queue.empty();)
  {
    const Index i = queue.top().second;
    queue.pop();
    if (count(i) != crowd[i])
    {
      search(i);
      if (!queue.empty() && loops[i].length > enough * queue.top().first)
      {
        queue.emplace(loops[i].length, i);
        continue;
      }
    }
    if (!take_flow(i, loops[i])) { curves.add(2 * i + 1, loops[i].steps); }
    searcher.note_added(2 * i + 1);
    loops[i].steps.clear();
    run.progress(Stage::LONGITUDES, (pairs + ++done) / (2. * pairs));
  }
}

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_HANDLES_INTERNAL_ARC_LONGITUDES_H
