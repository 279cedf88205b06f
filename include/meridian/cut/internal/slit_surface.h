// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_INTERNAL_SLIT_SURFACE_H
#define MERIDIAN_CUT_INTERNAL_SLIT_SURFACE_H

#include <meridian/base/Union_find.h>
#include <meridian/base/vectors.h>
#include <meridian/curves/sleeve.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/Surface_curve.h>
#include <meridian/surface/Triangle_surface.h>

#include <algorithm>
#include <vector>

namespace meridian {
namespace internal {

// A surface cut along its seams without being taken apart: faces across a seam are not neighbours, and each corner at
// a boundary knows which boundary of the cut surface it lies on.
class Slit_surface
{
public:
  // `kept_out`: of each face of the root, whether curves shall go around it; empty if around none.
  Slit_surface(const Triangle_surface& root, Refined_surface& s, bool bifurcations, std::vector<char> kept_out = {});

  // A vertex that shall be reached like a boundary; nothing happens if it lies on one. All come before the first link.
  void add_point(Index v);

  const Refined_surface& surface() const { return m_surface; }
  Index number_of_loops() const { return static_cast<Index>(m_vertices.size()); }
  Index loop(Index corner) const { return m_loop[corner]; } // of the corner at the source of a halfedge, or -1
  const std::vector<Index>& vertices(Index loop) const { return m_vertices[loop]; }
  bool may_cross(Index h) const { return !m_surface.is_seam_or_boundary(h); }
  bool is_kept_out(Index f) const { return !m_kept_out.empty() && m_kept_out[m_surface.face_of[f]]; }
  // What a way through a face, or along an edge, is longer than it is: where curves shall not go, more than any other.
  double detour(Index f) const { return is_kept_out(f) ? m_detour : 0; }
  double detour_along(Index h) const
  {
    const Index o = m_surface.opposite[h];
    return o < 0 ? detour(m_surface.face(h)) : std::min(detour(m_surface.face(h)), detour(m_surface.face(o)));
  }
  bool is_free(Index v) const { return !m_is_used[v]; }
  bool are_joined(Index a, Index b) const { return m_joined.find(a) == m_joined.find(b); }
  const std::vector<char>& was_changed() const { return m_was_changed; } // by a link, for each face; may be short

  // Inserts the shortest path of a sleeve. Returns its vertices.
  std::vector<Index> insert(Sleeve sleeve);

  std::vector<Index> parents; // of the faces that links appended, in order

private:
  Index add_loop();
  // The corners at the source of `h`, from `h` to the left as far as the next seam.
  void label_sector(Index h, Index loop);
  Index loop_at(const Sleeve& sleeve, bool start) const;
  // Inserts a curve and keeps the labels of the corners that this moves to other faces. Returns its vertices.
  std::vector<Index> refine(const Surface_curve& curve, bool mark_seam);

  const Triangle_surface& m_root;
  Refined_surface& m_surface;
  bool m_bifurcations;
  std::vector<char> m_kept_out;
  double m_detour = 0;
  std::vector<Index> m_loop;   // of each corner
  std::vector<char> m_is_used; // of each vertex: on a boundary, a seam or a link
  std::vector<char> m_was_changed;
  std::vector<std::vector<Index>> m_vertices; // of each boundary
  mutable Union_find m_joined{0};             // boundaries; finding one shortens the way to it
};

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_CUT_INTERNAL_SLIT_SURFACE_H
