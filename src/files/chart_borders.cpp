// SPDX-License-Identifier: GPL-3.0-or-later
#include "chart_borders.h"

#include <meridian/base/Result_mesh.h>
#include <meridian/base/exceptions.h>
#include <meridian/base/vectors.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/unwrap/square_border.h>

namespace meridian {
namespace files {

std::vector<Border_path> find_chart_borders(const Result_mesh& mesh)
{
  Triangle_surface s;
  s.points = mesh.points;
  s.triangles = mesh.faces;
  connect(s);
  std::vector<Index> mate(s.number_of_halfedges(), -1);
  for (const auto& [a, b] : mesh.seams)
  {
    if (s.opposite[a] >= 0 || s.opposite[b] >= 0 || a == b)
    {
      throw Internal_error("find_chart_borders: a seam is no border");
    }
    mate[a] = b;
    mate[b] = a;
  }
  const auto next = [&](Index h) { return s.outgoing[s.target(h)]; }; // along the border
  const auto goes_on = [&](Index h, Index g) {
    if (mate[h] < 0 || mate[g] < 0) { return mate[h] < 0 && mate[g] < 0; }
    return g != mate[h] && next(mate[g]) == mate[h]; // neither the tip of a seam, nor a fork
  };
  // inner: goes on from another
  std::vector<char> is_inner(s.number_of_halfedges(), 0), is_done(s.number_of_halfedges(), 0);
  for (Index h = 0; h < s.number_of_halfedges(); ++h)
    if (s.opposite[h] < 0 && goes_on(h, next(h))) { is_inner[next(h)] = 1; }
  std::vector<Border_path> paths;
  for (const bool is_circle : {false, true})
    for (Index first = 0; first < s.number_of_halfedges(); ++first)
    {
      if (s.opposite[first] >= 0 || is_done[first] || (is_inner[first] && !is_circle)) { continue; }
      Border_path& path = paths.emplace_back();
      for (Index h = first;; h = next(h))
      {
        path.sides.push_back(h);
        is_done[h] = 1;
        if (mate[h] >= 0) { is_done[mate[h]] = 1; }
        if (!is_inner[next(h)] || next(h) == first) { break; }
      }
      for (auto h = path.sides.rbegin(); h != path.sides.rend() && mate[first] >= 0; ++h)
      {
        path.mates.push_back(mate[*h]);
      }
    }
  return paths;
}

} // namespace files
} // namespace meridian
