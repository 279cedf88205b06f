// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/surface/examine_surface.h>

#include <meridian/base/exceptions.h>
#include <meridian/base/vectors.h>
#include <meridian/surface/internal/soup_topology.h>

#include <algorithm>
#include <string>
#include <vector>

namespace meridian {

namespace internal {

namespace {

// The component of each triangle, numbered by their first triangles; returns how many there are.
Index number_components(const Soup_topology& t, std::vector<Index>& component)
{
  const Index n = static_cast<Index>(t.triangles.size());
  component.assign(n, -1);
  std::vector<Index> stack;
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
  return components;
}

void reserve(Surface_component& c, Index faces)
{
  c.surface.triangles.reserve(faces);
  c.surface.opposite.reserve(3 * static_cast<std::size_t>(faces));
  c.triangle_of.reserve(faces);
  c.polygon_of.reserve(faces);
  c.is_flipped.reserve(faces);
}

// Gives each component its triangles, with the vertices of the soup, and their twins.
void distribute_triangles(const Soup_topology& t, std::vector<Surface_component>& components)
{
  std::vector<Index> component;
  components.resize(number_components(t, component));
  const Index n = static_cast<Index>(t.triangles.size());
  std::vector<Index> local_face(n), size(components.size(), 0);
  for (Index f = 0; f < n; ++f) { ++size[component[f]]; }
  for (std::size_t i = 0; i < components.size(); ++i) { reserve(components[i], size[i]); }
  for (Index f = 0; f < n; ++f)
  {
    Surface_component& c = components[component[f]];
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
      components[component[f]].surface.opposite.push_back(o < 0 ? -1 : 3 * local_face[o / 3] + o % 3);
    }
}

// Numbers the vertices of a component from 0 and fills in `vertex_of`. `local` is -1 for all vertices of the soup,
// before and after.
void number_vertices(Surface_component& c, std::vector<Index>& local)
{
  for (const auto& corners : c.surface.triangles)
    for (Index v : corners)
      if (local[v] < 0)
      {
        local[v] = 0;
        c.vertex_of.push_back(v);
      }
  std::sort(c.vertex_of.begin(), c.vertex_of.end());
  for (std::size_t i = 0; i < c.vertex_of.size(); ++i) { local[c.vertex_of[i]] = static_cast<Index>(i); }
  for (auto& corners : c.surface.triangles)
  {
    for (Index& v : corners) { v = local[v]; }
  }
  for (Index v : c.vertex_of) { local[v] = -1; }
}

} // namespace

} // namespace internal

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
  internal::distribute_triangles(t, result.components);

  const Index points = static_cast<Index>(soup.points.size());
  std::vector<Index> local(soup.points.size() + result.added_vertex_of.size(), -1);
  for (Surface_component& c : result.components)
  {
    internal::number_vertices(c, local);
    c.surface.points.reserve(c.vertex_of.size());
    for (Index v : c.vertex_of)
    {
      c.surface.points.push_back(soup.points[v < points ? v : result.added_vertex_of[v - points]]);
    }
    c.unit = internal::bring_to_scale(c.surface.points);
    find_outgoing(c.surface);
    c.boundary_loops = static_cast<int>(boundary_loops(c.surface).size());
  }
  internal::note_faces_without_area(result.components, result.repairs);
  return result;
}

} // namespace meridian
