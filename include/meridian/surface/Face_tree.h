// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_SURFACE_FACE_TREE_H
#define MERIDIAN_SURFACE_FACE_TREE_H

#include <meridian/base/vectors.h>
#include <meridian/surface/Triangle_surface.h>

#include <vector>

namespace meridian {
namespace internal {

// Shortest ways through faces from a seed, straight between the middles of the edges that they cross. The distance of a
// face is measured to the middle of the edge by which it was entered; that of the seed from its centroid.
struct Face_tree
{
  std::vector<double> distance; // infinite where no way leads
  std::vector<Index> by;        // the halfedge by which the face before was left; -1 at the seed

  // Where a way comes into a face.
  Point entry(const Triangle_surface& s, Index face) const;
};

Face_tree grow_face_tree(const Triangle_surface& s, Index seed);

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_SURFACE_FACE_TREE_H
