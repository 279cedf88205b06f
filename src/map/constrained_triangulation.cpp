// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/map/constrained_triangulation.h>

#include <meridian/base/Bounding_box.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <map>
#include <utility>

namespace meridian {

namespace internal {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex_base = CGAL::Triangulation_vertex_base_with_info_2<Index, Kernel>;
struct Mark
{
  bool is_seen = false;
};
using Face_base =
  CGAL::Triangulation_face_base_with_info_2<Mark, Kernel, CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Structure = CGAL::Triangulation_data_structure_2<Vertex_base, Face_base>;
using Triangulation =
  CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::No_constraint_intersection_tag>;

} // namespace

std::vector<std::array<Index, 3>> triangulate_outside(const std::vector<Index>& loop, std::vector<Plane_point>& at)
{
  Bounding_box<Plane_point> bounds(at[loop.front()]);
  for (Index v : loop) { bounds.add(at[v]); }
  const auto& [low, high] = bounds;
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
  const auto visit = [&](Triangulation::Face_handle f) {
    if (!triangulation.is_infinite(f) && !std::exchange(f->info().is_seen, true)) { stack.push_back(f); }
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

std::vector<std::array<Index, 2>> constrained_delaunay_edges(const std::vector<Index>& vertices,
                                                             const std::vector<std::vector<Index>>& polygons,
                                                             const std::vector<Plane_point>& at)
{
  std::vector<std::pair<Kernel::Point_2, Index>> points;
  for (Index v : vertices) { points.emplace_back(Kernel::Point_2(at[v][0], at[v][1]), v); }
  Triangulation t;
  t.insert(points.begin(), points.end());
  if (t.number_of_vertices() != points.size()) { return {}; }
  std::map<Index, Triangulation::Vertex_handle> handle;
  for (auto v : t.finite_vertex_handles()) { handle[v->info()] = v; }
  for (const auto& polygon : polygons)
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      t.insert_constraint(handle.at(polygon[i]), handle.at(polygon[(i + 1) % polygon.size()]));
    }
  std::vector<std::array<Index, 2>> edges;
  for (const auto& e : t.finite_edges())
  {
    edges.push_back({e.first->vertex(t.cw(e.second))->info(), e.first->vertex(t.ccw(e.second))->info()});
  }
  return edges;
}

} // namespace internal

} // namespace meridian
