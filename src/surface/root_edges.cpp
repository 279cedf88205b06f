// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/surface/root_edges.h>

#include <meridian/base/exceptions.h>

#include <algorithm>

namespace meridian {

namespace internal {

bool find_stretch(const Triangle_surface& root, const Refined_surface& s, Index h, Root_stretch& found)
{
  std::array<Index, 2> ends;
  if (!on_common_root_edge(s.origin(s.source(h)), s.origin(s.target(h)), ends, found.at)) { return false; }
  const Index f = s.face_of[s.face(h)];
  for (Index k = 3 * f; k < 3 * f + 3; ++k)
    if (std::min(root.source(k), root.target(k)) == ends[0] && std::max(root.source(k), root.target(k)) == ends[1])
    {
      found.halfedge = k;
      found.lower = ends[0];
      return true;
    }
  throw Internal_error("find_stretch: an edge does not lie on the face it came from");
}

} // namespace internal

Index root_vertex(const Triangle_surface& root, const Refined_surface& s, Index v)
{
  const Origin o = s.origin(v);
  if (o.kind == Origin::FACE)
  {
    const auto w = std::max_element(o.weight.begin(), o.weight.end()) - o.weight.begin();
    return root.triangles[o.index[0]][w];
  }
  return o.kind == Origin::EDGE && o.weight[0] > 0.5 ? o.index[1] : o.index[0];
}

} // namespace meridian
