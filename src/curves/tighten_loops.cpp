// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/curves/tighten_loops.h>

#include <meridian/base/Union_find.h>
#include <meridian/base/exceptions.h>
#include <meridian/curves/Normal_curves.h>
#include <meridian/curves/passings.h>
#include <meridian/curves/place_normal_curves.h>
#include <meridian/surface/check_surface.h>
#include <meridian/surface/insert_curves.h>
#include <meridian/surface/open_along.h>
#include <meridian/surface/seams.h>

#include <algorithm>
#include <cstddef>
#include <map>
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

// Whether a loop of edges bounds a disc.
bool bounds_disc(const Triangle_surface& s, const std::vector<Index>& loop)
{
  Refined_surface cut(s);
  std::vector<Index> edges;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    edges.push_back(s.find_halfedge(loop[i], loop[(i + 1) % loop.size()]));
  }
  flag_seam(cut, edges);
  const Triangle_surface opened = surface_of(cut, open_along(cut));
  Union_find pieces(opened.number_of_vertices());
  for (const auto& t : opened.triangles)
  {
    for (Index v : t) { pieces.unite(t[0], v); }
  }
  std::map<Index, Index> characteristic; // of each piece
  for (Index v = 0; v < opened.number_of_vertices(); ++v) { ++characteristic[pieces.find(v)]; }
  for (Index h = 0; h < opened.number_of_halfedges(); ++h)
  {
    if (opened.edge(h) == h) { --characteristic[pieces.find(opened.source(h))]; }
  }
  for (const auto& t : opened.triangles) { ++characteristic[pieces.find(t[0])]; }
  // a piece with one boundary loop and no handle
  return characteristic.size() > 1
         && std::any_of(characteristic.begin(), characteristic.end(), [](const auto& c) { return c.second == 1; });
}

// The edges that a loop crosses when it is pushed off to its left: those that leave its vertices to that side.
std::vector<Crossing> push_off(const Normal_curves& curves, const std::vector<Index>& loop)
{
  const Triangle_surface& s = curves.surface();
  std::vector<Crossing> steps;
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
    if (bounds_disc(root, loops[i]))
    {
      throw Invalid_input_error("loop " + std::to_string(i)
                                + " bounds a disc: it can be contracted, and there is nothing to pull tight");
    }
    curves.add(2 * i, push_off(curves, loops[i]));
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
