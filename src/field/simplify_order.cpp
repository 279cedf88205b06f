// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/field/internal/simplify_order.h>

#include <meridian/base/exceptions.h>

#include <algorithm>

namespace meridian {

namespace internal {

Bit_queue::Bit_queue(std::size_t n)
{
  do {
    n = (n + 63) / 64;
    m_levels.emplace_back(n, 0);
  } while (n > 1);
}

void Bit_queue::push(std::size_t i)
{
  for (auto& level : m_levels)
  {
    level[i / 64] |= std::uint64_t(1) << (i % 64);
    i /= 64;
  }
}

std::size_t Bit_queue::pop() // the smallest
{
  std::size_t i = 0;
  for (std::size_t l = m_levels.size(); l-- > 0;) { i = i * 64 + __builtin_ctzll(m_levels[l][i]); }
  const std::size_t smallest = i;
  for (auto& level : m_levels)
  {
    level[i / 64] &= ~(std::uint64_t(1) << (i % 64));
    if (level[i / 64] != 0) { break; }
    i /= 64;
  }
  return smallest;
}

bool has_other_extrema(const Closed_model& g, const std::vector<Index>& rank, const std::vector<char>& allowed,
                       bool low)
{
  for (Index a = 0; a < g.number_of_nodes; ++a)
  {
    if (allowed[a]) { continue; }
    bool is_extremum = true;
    for (Index i = g.begin[a]; i < g.begin[a + 1] && is_extremum; ++i)
      is_extremum = (rank[g.neighbor[i]] < rank[a]) != low;
    if (is_extremum) { return true; }
  }
  return false;
}

std::vector<Index> sweep(const Closed_model& g, const std::vector<Index>& nodes, const std::vector<Index>& rank,
                         const std::vector<Index>& seeds, bool up)
{
  const Index n = g.number_of_nodes;
  const auto key = [&](Index a) { return up ? rank[a] : n - 1 - rank[a]; };
  std::vector<Index> result;
  result.reserve(n);
  std::vector<char> reached(n, 0);
  Bit_queue queue(n);
  const auto reach = [&](Index a) {
    if (reached[a]) { return; }
    reached[a] = 1;
    queue.push(key(a));
  };
  for (Index a : seeds) { reach(a); }
  while (!queue.empty())
  {
    const Index k = static_cast<Index>(queue.pop());
    const Index a = nodes[up ? k : n - 1 - k];
    result.push_back(a);
    for (Index i = g.begin[a]; i < g.begin[a + 1]; ++i) { reach(g.neighbor[i]); }
  }
  if (!up) { std::reverse(result.begin(), result.end()); }
  if (static_cast<Index>(result.size()) != n) { throw Internal_error("simplify_order: the surface is not connected"); }
  return result;
}

std::vector<Index> st_numbering(const Closed_model& g, const std::vector<Index>& minima,
                                const std::vector<Index>& maxima)
{
  const Index n = g.number_of_nodes, s = n, t = n + 1;
  const auto degree = [&](Index a) {
    if (a == s) { return static_cast<Index>(minima.size()) + 1; }
    if (a == t) { return static_cast<Index>(maxima.size()) + 1; }
    return g.begin[a + 1] - g.begin[a] + 1; // the last one may lead to the source or the sink
  };
  std::vector<Index> extra(n, -1);
  for (Index a : minima) { extra[a] = s; }
  for (Index a : maxima) { extra[a] = t; }
  const auto neighbor = [&](Index a, Index i) -> Index {
    if (a == s) { return i == 0 ? t : minima[i - 1]; } // the first edge of the search goes from source to sink
    if (a == t) { return i == 0 ? s : maxima[i - 1]; }
    return i < g.begin[a + 1] - g.begin[a] ? g.neighbor[g.begin[a] + i] : extra[a];
  };
  std::vector<Index> pre(n + 2, -1), low(n + 2, -1), parent(n + 2, -1), preorder, position(n + 2, 0);
  std::vector<Index> stack{s};
  pre[s] = 0;
  low[s] = s;
  preorder.push_back(s);
  while (!stack.empty())
  {
    const Index a = stack.back();
    if (position[a] < degree(a))
    {
      const Index b = neighbor(a, position[a]++);
      if (b < 0) { continue; }
      if (pre[b] < 0)
      {
        pre[b] = static_cast<Index>(preorder.size());
        low[b] = b;
        parent[b] = a;
        preorder.push_back(b);
        stack.push_back(b);
      }
      else if (pre[b] < pre[low[a]]) { low[a] = b; }
      continue;
    }
    stack.pop_back();
    const Index p = parent[a];
    if (p >= 0 && pre[low[a]] < pre[low[p]]) { low[p] = low[a]; }
  }
  // A doubly linked list that starts as source, sink; each node goes before or after its parent.
  std::vector<Index> before(n + 2, -1), after(n + 2, -1);
  std::vector<char> minus(n + 2, 0);
  after[s] = t;
  before[t] = s;
  minus[s] = 1;
  for (Index a : preorder)
  {
    if (a == s || a == t) { continue; }
    const Index p = parent[a];
    const bool goes_before = minus[low[a]];
    const Index left = goes_before ? before[p] : p, right = goes_before ? p : after[p];
    before[a] = left;
    after[a] = right;
    if (left >= 0) { after[left] = a; }
    if (right >= 0) { before[right] = a; }
    minus[p] = !goes_before;
  }
  std::vector<Index> result;
  for (Index a = after[s]; a >= 0 && a != t; a = after[a]) { result.push_back(a); }
  if (static_cast<Index>(result.size()) != n) { throw Internal_error("st_numbering: the graph is not biconnected"); }
  return result;
}

} // namespace internal

} // namespace meridian
