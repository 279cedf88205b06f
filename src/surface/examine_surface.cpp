// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/surface/examine_surface.h>

#include <meridian/base/exceptions.h>
#include <meridian/surface/internal/soup_topology.h>

#include <algorithm>

namespace meridian {

Examination examine_surface(const Polygon_soup& soup, bool split)
{
  Examination result;
  internal::check_indices_and_points(soup);
  internal::Soup_topology t = internal::gather_triangles(soup, result.repairs);
  if (t.triangles.empty())
    throw Invalid_input_error("the mesh has no usable face (" + std::to_string(soup.points.size()) + " points, "
                              + std::to_string(soup.number_of_polygons()) + " polygons)");
  internal::pair_sides(t, split, result.repairs);
  internal::orient(t, result.repairs);
  internal::separate_fans(t, soup.points.size(), result.added_vertex_of, result.repairs);

  // Components, numbered by their first triangle.
  const Index n = static_cast<Index>(t.triangles.size());
  std::vector<Index> component(n, -1), stack;
  Index components = 0;
  for (Index f = 0; f < n; ++f)
  {
    if (component[f] >= 0) { continue; }
    component[f] = components;
    stack.assign(1, f);
    while (!stack.empty())
    {
      const Index g = stack.back();
      stack.pop_back();
      for (Index k = 0; k < 3; ++k)
      {
        const Index o = t.twin[3 * g + k];
        if (o < 0 || component[o / 3] >= 0) { continue; }
        component[o / 3] = components;
        stack.push_back(o / 3);
      }
    }
    ++components;
  }
  result.components.resize(components);
  std::vector<Index> local_face(n);
  for (Index f = 0; f < n; ++f)
  {
    Surface_component& c = result.components[component[f]];
    local_face[f] = c.surface.number_of_faces();
    c.surface.triangles.push_back(t.triangles[f]);
    c.triangle_of.push_back(t.index[f]);
    c.polygon_of.push_back(t.polygon[f]);
    c.is_flipped.push_back(t.is_flipped[f]);
  }
  for (Index f = 0; f < n; ++f) // the twins, as `connect()` would find them
    for (Index side = 3 * f; side < 3 * f + 3; ++side)
    {
      const Index o = t.twin[side];
      result.components[component[f]].surface.opposite.push_back(o < 0 ? -1 : 3 * local_face[o / 3] + o % 3);
    }
  std::vector<Index> local(soup.points.size() + result.added_vertex_of.size(), -1), used;
  for (Surface_component& c : result.components)
  {
    used.clear();
    for (const auto& corners : c.surface.triangles)
      for (Index v : corners)
        if (local[v] < 0)
        {
          local[v] = 0;
          used.push_back(v);
        }
    std::sort(used.begin(), used.end());
    for (std::size_t i = 0; i < used.size(); ++i) { local[used[i]] = static_cast<Index>(i); }
    for (auto& corners : c.surface.triangles)
    {
      for (Index& v : corners) { v = local[v]; }
    }
    for (Index v : used)
    {
      local[v] = -1;
      const Index original =
        v < static_cast<Index>(soup.points.size()) ? v : result.added_vertex_of[v - soup.points.size()];
      c.vertex_of.push_back(v);
      c.surface.points.push_back(soup.points[original]);
    }
    c.unit = internal::bring_to_scale(c.surface.points);
    find_outgoing(c.surface);
    c.boundary_loops = static_cast<int>(boundary_loops(c.surface).size());
  }
  internal::note_faces_without_area(result.components, result.repairs);
  return result;
}

} // namespace meridian
