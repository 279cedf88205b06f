// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/handles/find_meridians.h>

#include <meridian/base/exceptions.h>
#include <meridian/base/vectors.h>
#include <meridian/field/critical_points.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/Surface_curve.h>
#include <meridian/surface/measures.h>
#include <meridian/surface/root_edges.h>

#include <string>
#include <utility>

namespace meridian {

std::vector<const Contour*> Meridian_search::chosen() const
{
  std::vector<const Contour*> contours;
  for (const auto& choice : choices) { contours.push_back(&loops[choice.loop]); }
  return contours;
}

namespace internal {

double average_along(const Triangle_surface& root, const Ordered_surface& m, const Contour& loop,
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

void find_meridians(const Triangle_surface& root, const Ordered_surface& m, int genus, const Preference& preference,
                    Meridian_search& search, Levels levels, Index filled_holes)
{
  const auto average = [&](const Contour& loop, const std::vector<double>& values) {
    const Index wanted = root.number_of_vertices() - filled_holes;
    if (static_cast<Index>(values.size()) != wanted)
      throw Invalid_input_error("a preference has " + std::to_string(values.size()) + " weights for "
                                + std::to_string(wanted) + " vertices; it needs one a vertex");
    return internal::average_along(root, m, loop, values);
  };
  for (const Contour& loop : search.loops)
  {
    const Index v = root_vertex(root, m.surface, loop.saddle);
    search.candidates.push_back({v, root.points[v], curvature(root, v), length(m, loop), loop.is_longer,
                                 [&](const std::vector<double>& values) { return average(loop, values); }});
  }
  search.choices = select_meridians(
    m, search.loops, rank_by_preference(search.candidates, preference ? preference : preference::gaussian_curvature));
  for (Loop_candidate& c : search.candidates) { c.average = nullptr; } // it looks at a loop that may be moved below
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
