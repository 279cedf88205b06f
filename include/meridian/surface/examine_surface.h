// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_SURFACE_EXAMINE_SURFACE_H
#define MERIDIAN_SURFACE_EXAMINE_SURFACE_H

#include <meridian/base/Polygon_soup.h>
#include <meridian/base/vectors.h>
#include <meridian/surface/Triangle_surface.h>

#include <string>
#include <vector>

namespace meridian {

/// \ingroup PkgMeridianSurface
/// a connected component of a soup, as an oriented manifold with indices of its own.
struct Surface_component
{
  Triangle_surface surface;       ///< the component
  std::vector<Index> vertex_of;   ///< the soup's point of each vertex; ascending, unless renumbered, but for those that
                                  ///< pinches added
  std::vector<Index> triangle_of; ///< the soup's triangle of each face, as `for_each_triangle()` counts them;
                                  ///< ascending, unless renumbered
  std::vector<Index> polygon_of;  ///< the soup's polygon of each face
  std::vector<char> is_flipped;   ///< whether the face was turned over: its last two corners change places
  int boundary_loops = 0;         ///< how many there are
  /// a length on `surface` is this many units of the soup; not 1 only for extreme coordinates
  double unit = 1;
  /// \returns vertices - edges + faces
  int euler_characteristic() const
  {
    return surface.number_of_vertices() - surface.number_of_edges() + surface.number_of_faces();
  }
  /// \returns the number of handles
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
 * \returns the components, and what was done to make them
 * \throws Invalid_input_error if there is no face, a used point is not finite, an index is out of range, an edge has
 *         three or more faces and is not split, or a component is not orientable
 * \par Complexity
 * \f$ O(n \log d) \f$ for the largest degree \f$ d \f$
 */
Examination examine_surface(const Polygon_soup& soup, bool split = false);

} // namespace meridian

#endif // MERIDIAN_SURFACE_EXAMINE_SURFACE_H
