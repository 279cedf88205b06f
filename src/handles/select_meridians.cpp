// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/handles/select_meridians.h>

#include <meridian/base/vectors.h>
#include <meridian/surface/Refined_surface.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

namespace meridian {

std::vector<std::size_t> rank_by_preference(const std::vector<Loop_candidate>& candidates, const Preference& rate)
{
  std::vector<std::pair<double, double>> key;
  for (const auto& c : candidates)
  {
    const double r = rate(c);
    const double last = std::numeric_limits<double>::infinity();
    key.emplace_back(std::isnan(r) ? last : -r, std::isnan(c.length) ? last : c.length);
  }
  std::vector<std::size_t> order(candidates.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key[a] < key[b]; });
  return order;
}

std::vector<Meridian_choice> select_meridians(const Ordered_surface& m, const std::vector<Contour>& loops,
                                              const std::vector<std::size_t>& order)
{
  const Refined_surface& s = m.surface;
  const Index n = s.number_of_vertices();
  // The gaps between crossings along an edge are parts of pieces too; the first and the last belong to its ends.
  struct Crossing
  {
    Index edge, level, id;
  };
  std::vector<Crossing> crossings;
  Index ids = 0;
  for (const Contour& loop : loops)
    for (Index h : loop.halfedges) { crossings.push_back({s.edge(h), loop.level, ids++}); }
  std::sort(crossings.begin(), crossings.end(), [](const Crossing& a, const Crossing& b) {
    return std::tie(a.edge, a.level, a.id) < std::tie(b.edge, b.level, b.id);
  });
  std::vector<Index> above(ids), below(ids), parent(n + ids), size(n + ids, 0);
  std::iota(parent.begin(), parent.end(), Index(0));
  boost::disjoint_sets<Index*, Index*> pieces(size.data(), parent.data());
  std::vector<char> is_crossed(s.number_of_halfedges(), 0);
  for (std::size_t i = 0; i < crossings.size(); ++i)
  {
    const Crossing& c = crossings[i];
    is_crossed[c.edge] = 1;
    Index low = s.source(c.edge), high = s.target(c.edge);
    if (m.rank[low] > m.rank[high]) { std::swap(low, high); }
    const bool first = i == 0 || crossings[i - 1].edge != c.edge;
    const bool last = i + 1 == crossings.size() || crossings[i + 1].edge != c.edge;
    below[c.id] = first ? low : n + crossings[i - 1].id;
    above[c.id] = last ? high : n + c.id;
  }
  for (Index h = 0; h < s.number_of_halfedges(); ++h)
    if (s.edge(h) == h && !is_crossed[h]) { pieces.union_set(s.source(h), s.target(h)); }
  std::vector<Index> first_id;
  Index id = 0;
  for (const Contour& loop : loops)
  {
    first_id.push_back(id);
    for (std::size_t i = 0; i + 1 < loop.halfedges.size(); ++i, ++id)
    {
      pieces.union_set(above[id], above[id + 1]);
      pieces.union_set(below[id], below[id + 1]);
    }
    ++id;
  }

  std::vector<std::size_t> chosen;
  for (auto i = order.rbegin(); i != order.rend(); ++i)
  {
    const Index p = pieces.find_set(above[first_id[*i]]), q = pieces.find_set(below[first_id[*i]]);
    if (p == q) { chosen.push_back(*i); }
    else { pieces.link(p, q); }
  }
  std::reverse(chosen.begin(), chosen.end());

  // What is left after the last cut was joined by the uncut loops; cutting fewer can only leave it more connected.
  int components = 0;
  std::vector<char> seen(n + ids, 0);
  const auto visit = [&](Index place) {
    char& known = seen[pieces.find_set(place)];
    components += !known;
    known = 1;
  };
  for (Index v = 0; v < n; ++v) { visit(v); }
  for (Index gap : above) { visit(gap); }
  const Index loops_of_boundary = m.graph.number_of_nodes - m.graph.first_loop_node;
  const int characteristic = s.number_of_vertices() - s.number_of_edges() + s.number_of_faces();
  std::vector<Meridian_choice> result;
  for (std::size_t i : chosen)
  {
    const int boundaries = loops_of_boundary + 2 * static_cast<int>(result.size() + 1);
    result.push_back({i, (2 * components - characteristic - boundaries) / 2, components});
  }
  return result;
}

} // namespace meridian
