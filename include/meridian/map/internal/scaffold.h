// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MAP_INTERNAL_SCAFFOLD_H
#define MERIDIAN_MAP_INTERNAL_SCAFFOLD_H

#include <meridian/map/planar_map.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <set>

namespace meridian {
namespace internal {

// The triangles between a simple polygon, whose corners are `loop`, and a box around it. The corners of the box are
// appended to `at`.
inline std::vector<std::array<Index, 3>> triangulate_outside(const std::vector<Index>& loop,
                                                             std::vector<Plane_point>& at)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Vertex_base = CGAL::Triangulation_vertex_base_with_info_2<Index, Kernel>;
  using Structure =
    CGAL::Triangulation_data_structure_2<Vertex_base, CGAL::Constrained_triangulation_face_base_2<Kernel>>;
  using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::No_constraint_intersection_tag>;

  Plane_point low = at[loop.front()], high = low;
  for (Index v : loop)
    for (int i = 0; i < 2; ++i)
    {
      low[i] = std::min(low[i], at[v][i]);
      high[i] = std::max(high[i], at[v][i]);
    }
  const double margin = std::max(high[0] - low[0], high[1] - low[1]);
  std::vector<Index> box;
  for (int i = 0; i < 4; ++i)
  {
    box.push_back(static_cast<Index>(at.size()));
    at.push_back({i == 0 || i == 3 ? low[0] - margin : high[0] + margin, i < 2 ? low[1] - margin : high[1] + margin});
  }

  Triangulation triangulation;
  const auto insert = [&](const std::vector<Index>& polygon) {
    std::vector<Triangulation::Vertex_handle> handles;
    for (Index v : polygon)
    {
      handles.push_back(triangulation.insert({at[v][0], at[v][1]},
                                             handles.empty() ? Triangulation::Face_handle() : handles.back()->face()));
      handles.back()->info() = v;
    }
    for (std::size_t i = 0; i < handles.size(); ++i)
    {
      triangulation.insert_constraint(handles[i], handles[(i + 1) % handles.size()]);
    }
  };
  insert(box);
  insert(loop);

  // The ring is what a walk from the box reaches without crossing the polygon.
  std::vector<Triangulation::Face_handle> stack;
  std::set<Triangulation::Face_handle> seen;
  const auto visit = [&](Triangulation::Face_handle f) {
    if (!triangulation.is_infinite(f) && seen.insert(f).second) { stack.push_back(f); }
  };
  auto around = triangulation.incident_faces(triangulation.infinite_vertex()), first = around;
  do {
    visit(around->neighbor(around->index(triangulation.infinite_vertex())));
  } while (++around != first);
  std::vector<std::array<Index, 3>> triangles;
  while (!stack.empty())
  {
    const auto f = stack.back();
    stack.pop_back();
    triangles.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
    for (int i = 0; i < 3; ++i)
    {
      if (!f->is_constrained(i)) { visit(f->neighbor(i)); }
    }
  }
  return triangles;
}

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_MAP_INTERNAL_SCAFFOLD_H
