// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_HANDLES_SELECT_MERIDIANS_H
#define MERIDIAN_HANDLES_SELECT_MERIDIANS_H

#include <meridian/curves/contours.h>
#include <meridian/field/order_surface.h>
#include <meridian/surface/measures.h>

#include <boost/pending/disjoint_sets.hpp>

#include <functional>
#include <tuple>

namespace meridian {

/// \ingroup PkgMeridianMeridians
/// what a preference may look at when it rates a loop.
struct Loop_candidate
{
  Index saddle;        ///< vertex of the saddle on the root surface, or the root vertex nearest to it
  Point position;      ///< of the saddle
  Curvature curvature; ///< at that vertex; zero on the boundary
  double length;       ///< of the loop
  bool is_longer;      ///< whether the other loop of the saddle is shorter
  /// \returns the mean along the loop of values at the root's vertices
  std::function<double(const std::vector<double>&)> average;
};

/// \ingroup PkgMeridianMeridians
/// rates a loop; the loops with the highest rates are cut first. Of two with equal rates the shorter is.
using Preference = std::function<double(const Loop_candidate&)>;

/// \ingroup PkgMeridianMeridians
/// ready-made preferences. Those that rate saddles put the longer loop of every saddle behind the shorter loops of all.
namespace preference {
namespace internal {
// rate >= 0
inline double rate_saddle(double rate, const Loop_candidate& c)
{
  return c.is_longer ? -1 / (1 + std::min(rate, 1e300)) : rate;
}
} // namespace internal
/// saddles of high curvature first, whatever its sign: seams there cost little distortion (the paper's choice)
inline double gaussian_curvature(const Loop_candidate& c)
{
  return internal::rate_saddle(std::abs(c.curvature.gaussian), c);
}
/// saddles of high mean curvature first, whatever its sign
inline double mean_curvature(const Loop_candidate& c) { return internal::rate_saddle(std::abs(c.curvature.mean), c); }
/// short loops first
inline double short_length(const Loop_candidate& c) { return -c.length; }
/// loops first that run where `weight` is low: one number a vertex of the root, such as `visibility()` or what marks a
/// region to keep away from
inline Preference low_weight(std::vector<double> weight)
{
  return [weight = std::move(weight)](const Loop_candidate& c) { return -c.average(weight); };
}
/// loops whose saddles lie far out in direction `d` first
inline Preference position(const Point& d)
{
  return [d](const Loop_candidate& c) { return dot(c.position, d); };
}
} // namespace preference

/// \ingroup PkgMeridianMeridians
/// a chosen loop, and what the surface is after all loops up to it are cut.
struct Meridian_choice
{
  std::size_t loop;     ///< its place among the candidates
  int genus_after;      ///< genus of the surface cut so far
  int components_after; ///< number of its components
};

/// \ingroup PkgMeridianMeridians
/// \returns the candidates' places, the most preferred first: by rate, then length, then place
inline std::vector<std::size_t> rank_by_preference(const std::vector<Loop_candidate>& candidates,
                                                   const Preference& rate)
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

/*!
 * \ingroup PkgMeridianMeridians
 *
 * chooses the loops that cut all handles and leave the surface connected.
 *
 * The paper tries the loops from the most to the least preferred and recounts the genus after each. The same loops come
 * out of one pass the other way round: take them from the *least* to the *most* preferred; one that joins two pieces
 * stays uncut, every other is cut. (Loops are the edges and pieces the nodes of a graph, and the uncut loops are its
 * spanning tree: reverse-delete duality.)
 *
 * \param m the ordered surface
 * \param loops disjoint contours, at least all loops of the saddles
 * \param order the loops' places, the most preferred first
 *
 * \returns the chosen loops, the most preferred first, with the genus and the number of components after each cut
 * \post as many loops as the genus
 * \par Complexity
 * \f$ O((n + k \log k) \alpha(n)) \f$ for `k` crossings
 */
inline std::vector<Meridian_choice> select_meridians(const Ordered_surface& m, const std::vector<Contour>& loops,
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

/// \ingroup PkgMeridianMeridians
/// the loops of all saddles, and which of them are meridians.
struct Meridian_search
{
  std::vector<Contour> loops;
  std::vector<Loop_candidate> candidates; ///< one a loop
  std::vector<Meridian_choice> choices;   ///< the most preferred first

  std::vector<const Contour*> chosen() const
  {
    std::vector<const Contour*> contours;
    for (const auto& choice : choices) { contours.push_back(&loops[choice.loop]); }
    return contours;
  }
};

namespace internal {

// The mean of values at the root's vertices along a contour: linear along the edges of the root, by length.
inline double average_along(const Triangle_surface& root, const Ordered_surface& m, const Contour& loop,
                            const std::vector<double>& values)
{
  double sum = 0, whole = 0;
  // the middle of a filled hole has none
  const auto at = [&](Index v) { return v < static_cast<Index>(values.size()) ? values[v] : 0; };
  const auto value = [&](Index v) {
    const Origin o = m.surface.origin(v);
    if (o.kind == Origin::VERTEX) { return at(o.index[0]); }
    if (o.kind == Origin::EDGE) { return at(o.index[0]) + o.weight[0] * (at(o.index[1]) - at(o.index[0])); }
    double inside = 0;
    for (int k = 0; k < 3; ++k) { inside += o.weight[k] * at(root.triangles[o.index[0]][k]); }
    return inside;
  };
  std::vector<std::pair<Point, double>> points;
  for (Index h : loop.halfedges)
  {
    const double t = crossing_fraction(m, h, loop.level), from = value(m.surface.source(h));
    points.emplace_back(m.surface.point_on(h, t), from + t * (value(m.surface.target(h)) - from));
  }
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const auto& [p, x] = points[i];
    const auto& [q, y] = points[(i + 1) % points.size()];
    const double length = distance(p, q);
    sum += length * (x + y) / 2;
    whole += length;
  }
  return whole > 0 ? sum / whole : points.front().second;
}

} // namespace internal

/// \ingroup PkgMeridianMeridians
/// rates the loops of `search` and chooses as many meridians as the genus; moves those to the tightest level if that is
/// wanted.
/// \throws Internal_error if there are not as many
/// \par Complexity
/// that of `select_meridians()`
inline void find_meridians(const Triangle_surface& root, const Ordered_surface& m, int genus,
                           const Preference& preference, Meridian_search& search, Levels levels = Levels::SADDLE)
{
  for (const Contour& loop : search.loops)
  {
    const Index v = root_vertex(root, m.surface, loop.saddle);
    search.candidates.push_back(
      {v, root.points[v], curvature(root, v), length(m, loop), loop.is_longer,
       [&](const std::vector<double>& values) { return internal::average_along(root, m, loop, values); }});
  }
  search.choices = select_meridians(m, search.loops, rank_by_preference(search.candidates, preference));
  if (static_cast<int>(search.choices.size()) != genus)
    throw Internal_error("find_meridians: " + std::to_string(search.choices.size())
                         + " meridians on a surface of genus " + std::to_string(genus));
  if (levels == Levels::SADDLE) { return; }
  std::vector<char> is_critical(m.graph.number_of_nodes, 0);
  for (const Critical_point& p : find_critical_points(m.surface, m.rank)) { is_critical[m.graph.node[p.vertex]] = 1; }
  for (const auto& choice : search.choices)
  {
    search.loops[choice.loop] = find_tightest_contour(m, search.loops[choice.loop], is_critical);
  }
}

} // namespace meridian

#endif // MERIDIAN_HANDLES_SELECT_MERIDIANS_H
