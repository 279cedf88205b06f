// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/field/Node_order.h>

#include <meridian/base/exceptions.h>
#include <meridian/field/internal/simplify_order.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

namespace meridian {

Node_order order_nodes(const Closed_model& g, const Scalar_field& field)
{
  const Index n = g.number_of_nodes;
  const auto by_value = [&](Index a, Index b) {
    return field.value[a] < field.value[b] || (!(field.value[b] < field.value[a]) && a < b);
  };
  std::vector<std::vector<Index>> members(field.regions.size());
  for (Index a = 0; a < n; ++a) { members[field.region_of(a)].push_back(a); }
  for (auto& m : members) { std::sort(m.begin(), m.end(), by_value); }

  // The nodes of a flat region follow the highest node of its rim that is not above them.
  std::map<Index, std::vector<Index>> followers;
  for (Index r = 1; r < static_cast<Index>(members.size()); ++r)
  {
    std::vector<std::pair<double, Index>> rim;
    for (Index a : members[r])
      for (Index i = g.begin[a]; i < g.begin[a + 1]; ++i)
        if (field.region_of(g.neighbor[i]) < r) { rim.emplace_back(field.value_in(r, g.neighbor[i]), g.neighbor[i]); }
    std::sort(rim.begin(), rim.end());
    rim.erase(std::unique(rim.begin(), rim.end()), rim.end());
    if (rim.empty()) { throw Internal_error("order_nodes: a flat region touches nothing"); }
    for (Index a : members[r])
    {
      auto above = std::upper_bound(rim.begin(), rim.end(), field.value[a],
                                    [](double x, const std::pair<double, Index>& p) { return x < p.first; });
      followers[above == rim.begin() ? above->second : std::prev(above)->second].push_back(a);
    }
  }
  Node_order order;
  order.nodes.reserve(n);
  if (followers.empty()) { order.nodes = std::move(members[0]); }
  else
  {
    std::vector<Index> open(members[0].rbegin(), members[0].rend());
    while (!open.empty())
    {
      const Index a = open.back();
      open.pop_back();
      order.nodes.push_back(a);
      const auto f = followers.find(a);
      if (f != followers.end()) { open.insert(open.end(), f->second.rbegin(), f->second.rend()); }
    }
  }
  order.rank.resize(n);
  for (Index i = 0; i < n; ++i) { order.rank[order.nodes[i]] = i; }
  return order;
}

void simplify_order(const Closed_model& g, Node_order& order, const std::vector<Index>& minima,
                    const std::vector<Index>& maxima)
{
  constexpr int sweeps = 8;
  std::vector<char> may_be_lowest(g.number_of_nodes, 0), may_be_highest(g.number_of_nodes, 0);
  for (Index a : minima) { may_be_lowest[a] = 1; }
  for (Index a : maxima) { may_be_highest[a] = 1; }
  for (;; ++order.rounds)
  {
    const bool low = internal::has_other_extrema(g, order.rank, may_be_lowest, true);
    const bool high = internal::has_other_extrema(g, order.rank, may_be_highest, false);
    if (!low && !high) { break; }
    if (order.rounds == sweeps)
    {
      order.nodes = internal::st_numbering(g, minima, maxima);
      order.numbered = true;
    }
    else { order.nodes = internal::sweep(g, order.nodes, order.rank, low ? minima : maxima, low); }
    for (Index i = 0; i < g.number_of_nodes; ++i) { order.rank[order.nodes[i]] = i; }
    if (order.numbered) { break; }
  }
}

} // namespace meridian
