// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/field/internal/simplify_order.h>

#include <meridian/base/exceptions.h>

#include <algorithm>
#include <vector>

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

namespace {

// The graph with a source joined to all minima, a sink joined to all maxima, and an edge from source to sink.
class Biconnected_graph
{
public:
  Biconnected_graph(const Closed_model& g, const std::vector<Index>& minima, const std::vector<Index>& maxima)
    : m_graph(g), m_minima(minima), m_maxima(maxima), m_extra(g.number_of_nodes, -1)
  {
    for (Index a : minima) { m_extra[a] = source(); }
    for (Index a : maxima) { m_extra[a] = sink(); }
  }

  Index source() const { return m_graph.number_of_nodes; }
  Index sink() const { return m_graph.number_of_nodes + 1; }
  Index number_of_nodes() const { return m_graph.number_of_nodes + 2; }

  Index degree(Index a) const
  {
    if (a == source()) { return static_cast<Index>(m_minima.size()) + 1; }
    if (a == sink()) { return static_cast<Index>(m_maxima.size()) + 1; }
    return m_graph.begin[a + 1] - m_graph.begin[a] + 1; // the last one may lead to the source or the sink
  }

  // Neighbour `i` of a node, or -1.
  Index neighbor(Index a, Index i) const
  {
    if (a == source()) { return i == 0 ? sink() : m_minima[i - 1]; } // the first edge of the search leads to the sink
    if (a == sink()) { return i == 0 ? source() : m_maxima[i - 1]; }
    const Index begin = m_graph.begin[a];
    return i < m_graph.begin[a + 1] - begin ? m_graph.neighbor[begin + i] : m_extra[a];
  }

private:
  const Closed_model& m_graph;
  const std::vector<Index>&m_minima, &m_maxima;
  std::vector<Index> m_extra; // of each node: the source, the sink or -1
};

// Nodes in the order of a depth-first search; of each its parent, and the node nearest to the root that an edge joins
// to it or one below it.
struct Search_tree
{
  std::vector<Index> preorder, parent, low;
};

Search_tree search_depth_first(const Biconnected_graph& g)
{
  const Index n = g.number_of_nodes();
  Search_tree tree{{}, std::vector<Index>(n, -1), std::vector<Index>(n, -1)};
  std::vector<Index> pre(n, -1), position(n, 0), stack;
  const auto enter = [&](Index a, Index parent) {
    pre[a] = static_cast<Index>(tree.preorder.size());
    tree.low[a] = a;
    tree.parent[a] = parent;
    tree.preorder.push_back(a);
    stack.push_back(a);
  };
  enter(g.source(), -1);
  while (!stack.empty())
  {
    const Index a = stack.back();
    if (position[a] < g.degree(a))
    {
      const Index b = g.neighbor(a, position[a]++);
      if (b < 0) { continue; }
      if (pre[b] < 0) { enter(b, a); }
      else if (pre[b] < pre[tree.low[a]]) { tree.low[a] = b; }
      continue;
    }
    stack.pop_back();
    const Index p = tree.parent[a];
    if (p >= 0 && pre[tree.low[a]] < pre[tree.low[p]]) { tree.low[p] = tree.low[a]; }
  }
  return tree;
}

// A doubly linked list that starts as source, sink; each node goes before or after its parent. Returns what comes
// between the two.
std::vector<Index> list_between(const Biconnected_graph& g, const Search_tree& tree)
{
  const Index s = g.source(), t = g.sink();
  std::vector<Index> before(g.number_of_nodes(), -1), after(g.number_of_nodes(), -1);
  std::vector<char> minus(g.number_of_nodes(), 0);
  after[s] = t;
  before[t] = s;
  minus[s] = 1;
  for (Index a : tree.preorder)
  {
    if (a == s || a == t) { continue; }
    const Index p = tree.parent[a];
    const bool goes_before = minus[tree.low[a]];
    const Index left = goes_before ? before[p] : p, right = goes_before ? p : after[p];
    before[a] = left;
    after[a] = right;
    if (left >= 0) { after[left] = a; }
    if (right >= 0) { before[right] = a; }
    minus[p] = !goes_before;
  }
  std::vector<Index> result;
  for (Index a = after[s]; a >= 0 && a != t; a = after[a]) { result.push_back(a); }
  return result;
}

} // namespace

std::vector<Index> st_numbering(const Closed_model& g, const std::vector<Index>& minima,
                                const std::vector<Index>& maxima)
{
  const Biconnected_graph graph(g, minima, maxima);
  std::vector<Index> result = list_between(graph, search_depth_first(graph));
  if (static_cast<Index>(result.size()) != g.number_of_nodes)
  {
    throw Internal_error("st_numbering: the graph is not biconnected");
  }
  return result;
}

} // namespace internal

} // namespace meridian
