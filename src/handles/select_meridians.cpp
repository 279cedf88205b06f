// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/handles/select_meridians.h>

#include <meridian/base/Union_find.h>
#include <meridian/base/vectors.h>
#include <meridian/surface/Refined_surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

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

namespace {

// The pieces that contours leave of a surface. Their elements are the vertices and the gaps between crossings along an
// edge; the first and the last gap belong to its ends.
class Contour_pieces
{
public:
  Contour_pieces(const Ordered_surface& m, const std::vector<Contour>& loops)
    : m_ordered(m), m_loops(loops), m_crossings(count_crossings(loops)), m_above(m_crossings), m_below(m_crossings),
      m_pieces(m.surface.number_of_vertices() + m_crossings)
  {
    place_gaps();
    join_along_loops();
  }

  // Leaves a loop uncut, if it lies between two pieces. Returns whether it does.
  bool join_across(std::size_t loop)
  {
    return m_pieces.unite(m_above[m_first_crossing[loop]], m_below[m_first_crossing[loop]]);
  }

  int count()
  {
    const Index n = m_ordered.surface.number_of_vertices();
    int pieces = 0;
    std::vector<char> is_seen(n + m_crossings, 0);
    const auto visit = [&](Index place) {
      char& is_known = is_seen[m_pieces.find(place)];
      pieces += !is_known;
      is_known = 1;
    };
    for (Index v = 0; v < n; ++v) { visit(v); }
    for (Index gap : m_above) { visit(gap); }
    return pieces;
  }

private:
  struct Passed_level
  {
    Index edge, level, id;
  };

  static Index count_crossings(const std::vector<Contour>& loops)
  {
    Index count = 0;
    for (const Contour& loop : loops) { count += static_cast<Index>(loop.halfedges.size()); }
    return count;
  }

  // All crossings by edge and level.
  std::vector<Passed_level> sort_crossings() const
  {
    std::vector<Passed_level> crossings;
    Index ids = 0;
    for (const Contour& loop : m_loops)
      for (Index h : loop.halfedges) { crossings.push_back({m_ordered.surface.edge(h), loop.level, ids++}); }
    std::sort(crossings.begin(), crossings.end(), [](const Passed_level& a, const Passed_level& b) {
      return std::tie(a.edge, a.level, a.id) < std::tie(b.edge, b.level, b.id);
    });
    return crossings;
  }

  // Finds what lies on both sides of each crossing, and joins the ends of edges that no loop crosses.
  void place_gaps()
  {
    const Refined_surface& s = m_ordered.surface;
    const Index n = s.number_of_vertices();
    const std::vector<Passed_level> crossings = sort_crossings();
    std::vector<char> is_crossed(s.number_of_halfedges(), 0);
    for (std::size_t i = 0; i < crossings.size(); ++i)
    {
      const Passed_level& c = crossings[i];
      is_crossed[c.edge] = 1;
      Index low = s.source(c.edge), high = s.target(c.edge);
      if (m_ordered.rank[low] > m_ordered.rank[high]) { std::swap(low, high); }
      const bool first = i == 0 || crossings[i - 1].edge != c.edge;
      const bool last = i + 1 == crossings.size() || crossings[i + 1].edge != c.edge;
      m_below[c.id] = first ? low : n + crossings[i - 1].id;
      m_above[c.id] = last ? high : n + c.id;
    }
    for (Index h = 0; h < s.number_of_halfedges(); ++h)
      if (s.edge(h) == h && !is_crossed[h]) { m_pieces.unite(s.source(h), s.target(h)); }
  }

  // Joins what lies on one side of a loop.
  void join_along_loops()
  {
    Index id = 0;
    for (const Contour& loop : m_loops)
    {
      m_first_crossing.push_back(id);
      for (std::size_t i = 0; i + 1 < loop.halfedges.size(); ++i, ++id)
      {
        m_pieces.unite(m_above[id], m_above[id + 1]);
        m_pieces.unite(m_below[id], m_below[id + 1]);
      }
      ++id;
    }
  }

  const Ordered_surface& m_ordered;
  const std::vector<Contour>& m_loops;
  Index m_crossings;
  std::vector<Index> m_above, m_below; // of each crossing
  std::vector<Index> m_first_crossing; // of each loop
  Union_find m_pieces;
};

} // namespace

std::vector<Meridian_choice> select_meridians(const Ordered_surface& m, const std::vector<Contour>& loops,
                                              const std::vector<std::size_t>& order)
{
  Contour_pieces pieces(m, loops);
  std::vector<std::size_t> chosen;
  for (auto i = order.rbegin(); i != order.rend(); ++i)
  {
    if (!pieces.join_across(*i)) { chosen.push_back(*i); }
  }
  std::reverse(chosen.begin(), chosen.end());

  // What is left after the last cut was joined by the uncut loops; cutting fewer can only leave it more connected.
  const int components = pieces.count();
  const Refined_surface& s = m.surface;
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
