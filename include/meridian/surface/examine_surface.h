// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_SURFACE_EXAMINE_SURFACE_H
#define MERIDIAN_SURFACE_EXAMINE_SURFACE_H

#include <meridian/base/Polygon_soup.h>
#include <meridian/base/list_elements.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/surface/internal/soup_topology.h>

namespace meridian {

/// \ingroup PkgMeridianSurface
/// a connected component of a soup, as an oriented manifold with indices of its own.
struct Surface_component
{
  Triangle_surface surface;
  std::vector<Index> vertex_of;   ///< the soup's point of each vertex; ascending, but for those that pinches added
  std::vector<Index> triangle_of; ///< the soup's triangle of each face, as `for_each_triangle()` counts them; ascending
  std::vector<Index> polygon_of;  ///< the soup's polygon of each face
  std::vector<char> is_flipped;   ///< whether the face was turned over: its last two corners change places
  int boundary_loops = 0;
  /// a length on `surface` is this many units of the soup; not 1 only for extreme coordinates
  double unit = 1;
  int euler_characteristic() const
  {
    return surface.number_of_vertices() - surface.number_of_edges() + surface.number_of_faces();
  }
  int genus() const { return (2 - euler_characteristic() - boundary_loops) / 2; }
};

/// \ingroup PkgMeridianSurface
/// what a soup is, and what was done to make surfaces of it.
struct Examination
{
  std::vector<Surface_component> components; ///< by their first triangle
  std::vector<Index> added_vertex_of;        ///< the points that pinches doubled, in the order of their new vertices
  std::vector<std::string> repairs;          ///< in words: the defect, its count, the first elements, the policy
};

/*!
 * \ingroup PkgMeridianSurface
 *
 * makes oriented manifolds of a soup, or says why that cannot be.
 *
 * Orientability is decided first, by walking through all faces with a side to keep; nothing is ever cut to make a
 * surface orientable. Then, each listed under `repairs`: polygons with a repeated corner or fewer than three are left
 * out; unreferenced points stay and are not used; faces are turned over, the fewer ones of a component, until all
 * agree; a vertex whose faces form several fans becomes one vertex a fan; faces without area stay. Where squares of
 * coordinates would leave the range of double, a component is brought to size by an exact power of two.
 *
 * \param soup points and polygons
 * \param split whether edges with three or more faces are split: each of their faces gets a border of its own there,
 *        but two faces whose fans already meet at both ends stay together
 *
 * \throws Invalid_input_error if there is no face, a used point is not finite, an index is out of range, an edge has
 *         three or more faces and is not split, or a component is not orientable
 * \par Complexity
 * \f$ O(n \log d) \f$ for the largest degree \f$ d \f$
 */
inline Examination examine_surface(const Polygon_soup& soup, bool split = false)
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

#endif // MERIDIAN_SURFACE_EXAMINE_SURFACE_H
