// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/curves/tighten_loops.h>

#include <meridian/base/exceptions.h>
#include <meridian/curves/Normal_curves.h>
#include <meridian/curves/passings.h>
#include <meridian/curves/place_normal_curves.h>
#include <meridian/surface/check_surface.h>
#include <meridian/surface/insert_curves.h>

#include <cstddef>
#include <string>
#include <utility>

namespace meridian {

namespace {

// Refuses loops that are not made of edges or meet a vertex twice.
void check_loops(const Triangle_surface& s, const std::vector<std::vector<Index>>& loops)
{
  std::vector<char> is_visited(s.number_of_vertices(), 0);
  for (std::size_t i = 0; i < loops.size(); ++i)
  {
    const std::string name = "loop " + std::to_string(i);
    check_vertices(s, loops[i], name.c_str());
    if (loops[i].size() < 3) { throw Invalid_input_error(name + " has less than three vertices"); }
    for (std::size_t k = 0; k < loops[i].size(); ++k)
    {
      const Index v = loops[i][k], w = loops[i][(k + 1) % loops[i].size()];
      if (is_visited[v])
      {
        throw Invalid_input_error("vertex " + std::to_string(v) + " is visited twice; only disjoint simple loops can be"
                                  + " tightened together");
      }
      is_visited[v] = 1;
      if (s.find_halfedge(v, w) < 0 || s.find_halfedge(w, v) < 0)
      {
        throw Invalid_input_error(name + ": vertices " + std::to_string(v) + " and " + std::to_string(w)
                                  + " are not joined by an edge inside the surface");
      }
    }
  }
}

// The edges that a loop crosses when it is pushed off to its left: those that leave its vertices to that side.
std::vector<Normal_curves::Step> push_off(const Normal_curves& curves, const std::vector<Index>& loop)
{
  const Triangle_surface& s = curves.surface();
  std::vector<Normal_curves::Step> steps;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const Index v = loop[i], before = loop[(i + loop.size() - 1) % loop.size()], after = loop[(i + 1) % loop.size()];
    const Index back = s.find_halfedge(v, before), on = s.find_halfedge(v, after);
    for (Index h = s.turn_right(back); h != on; h = s.turn_right(h))
    {
      if (h < 0 || s.opposite[h] < 0)
      {
        throw Invalid_input_error("a loop runs along the boundary at vertex " + std::to_string(v)
                                  + "; turn it round, or choose one inside the surface");
      }
      const bool is_lower = s.edge(h) == h; // the crossing lies next to the edge's first end, or to its second
      steps.push_back({h, is_lower ? 0 : static_cast<Index>(curves.on(s.edge(h)).size()), is_lower ? 0.25 : 0.75});
    }
  }
  internal::cancel(s, steps);
  return steps;
}

} // namespace

Tightened_loops tighten_loops(const Triangle_surface& root, const std::vector<std::vector<Index>>& loops,
                              const Tighten_options& options, const Progress& progress)
{
  check_surface(root);
  check_loops(root, loops);
  Tightened_loops result;
  result.surface = Refined_surface(root);
  const Index n = static_cast<Index>(loops.size());
  Normal_curves curves(root, 2 * n); // every second: partners might cross
  for (Index i = 0; i < n; ++i)
  {
    const auto steps = push_off(curves, loops[i]);
    if (steps.empty())
    {
      throw Invalid_input_error("loop " + std::to_string(i) + " can be contracted; there is nothing to pull tight");
    }
    curves.add(2 * i, steps);
    for (std::size_t k = 0; k < loops[i].size(); ++k)
    {
      result.length_before += distance(root.points[loops[i][k]], root.points[loops[i][(k + 1) % loops[i].size()]]);
    }
  }
  result.length = tighten_curves(curves, options, progress);
  std::vector<Surface_curve> placed;
  const std::vector<Surface_curve> all = internal::place_normal_curves(curves);
  for (Index i = 0; i < n; ++i) { placed.push_back(all[2 * i]); }
  result.vertices = insert_curves(root, result.surface, placed).vertices;
  return result;
}

} // namespace meridian
