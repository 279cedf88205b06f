// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_SURFACE_TRIANGLE_TREE_H
#define MERIDIAN_SURFACE_TRIANGLE_TREE_H

#include <meridian/base/vectors.h>
#include <meridian/surface/Triangle_surface.h>

#include <memory>

namespace meridian {

/*!
 * \ingroup PkgMeridianSurface
 *
 * Boxes around the faces of a surface, in a tree (CGAL's AABB tree): which face a ray meets, and how far a point is
 * from all of them. Faces without area are left out: they hide nothing, and lie on the edges of others.
 *
 * \par Complexity
 * \f$ O(n \log n) \f$ to build, \f$ O(\log n) \f$ a question as a rule
 */
class Triangle_tree
{
public:
  /// \param s the surface, which must live as long as the tree
  explicit Triangle_tree(const Triangle_surface& s);
  explicit Triangle_tree(Triangle_surface&&) = delete;
  ~Triangle_tree();
  Triangle_tree(const Triangle_tree&) = delete;
  Triangle_tree& operator=(const Triangle_tree&) = delete;

  /// \returns whether no face has an area.
  bool empty() const;

  /// \returns whether the ray from vertex `v` in a direction meets a face that is not around `v`.
  /// \param v a vertex of the surface
  /// \param direction of the ray, not zero
  bool is_hidden(Index v, const Point& direction) const;

  /// Prepares for many distances.
  void accelerate_distances();

  /// \returns the squared distance of a point from the nearest face. \pre The tree is not empty.
  /// \param p the point
  double squared_distance(const Point& p) const;

private:
  struct Boxes;
  std::unique_ptr<Boxes> m_boxes;
};

} // namespace meridian

#endif // MERIDIAN_SURFACE_TRIANGLE_TREE_H
