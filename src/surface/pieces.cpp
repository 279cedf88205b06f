// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/surface/pieces.h>

#include <algorithm>
#include <vector>

namespace meridian {

std::vector<Index> number_pieces(const Triangle_surface& s)
{
  std::vector<Index> piece_of(s.number_of_faces(), -1), stack;
  Index pieces = 0;
  for (Index first = 0; first < s.number_of_faces(); ++first)
  {
    if (piece_of[first] >= 0) { continue; }
    stack.assign(1, first);
    piece_of[first] = pieces;
    while (!stack.empty())
    {
      const Index f = stack.back();
      stack.pop_back();
      for (Index h = 3 * f; h < 3 * f + 3; ++h)
      {
        if (s.opposite[h] < 0 || piece_of[s.face(s.opposite[h])] >= 0) { continue; }
        stack.push_back(s.face(s.opposite[h]));
        piece_of[stack.back()] = pieces;
      }
    }
    ++pieces;
  }
  return piece_of;
}

std::vector<Surface_piece> pieces_of(const Triangle_surface& s)
{
  const std::vector<Index> piece_of = number_pieces(s);
  std::vector<Surface_piece> pieces;
  std::vector<Index> local_face(s.number_of_faces(), -1), local_vertex(s.number_of_vertices(), -1);
  for (Index f = 0; f < s.number_of_faces(); ++f)
  {
    if (piece_of[f] == static_cast<Index>(pieces.size())) { pieces.emplace_back(); }
    local_face[f] = static_cast<Index>(pieces[piece_of[f]].faces.size());
    pieces[piece_of[f]].faces.push_back(f);
  }
  for (Surface_piece& p : pieces)
  {
    for (Index f : p.faces)
    {
      auto& t = p.surface.triangles.emplace_back();
      for (int k = 0; k < 3; ++k)
      {
        const Index v = s.triangles[f][k], h = s.opposite[3 * f + k];
        if (local_vertex[v] < 0) // no vertex is in two pieces
        {
          local_vertex[v] = static_cast<Index>(p.vertices.size());
          p.vertices.push_back(v);
          p.surface.points.push_back(s.points[v]);
        }
        t[k] = local_vertex[v];
        p.surface.opposite.push_back(h < 0 ? -1 : 3 * local_face[s.face(h)] + h % 3);
      }
    }
    find_outgoing(p.surface);
  }
  return pieces;
}

Index vertex_of_whole(const Surface_piece& piece, const Refined_surface& s, const Opened_surface& opened, Index v)
{
  const Index w = piece.vertices[v], n = s.number_of_vertices();
  return w < n ? w : opened.copy_of[w - n];
}

Surface_curve carry_to_whole(const Surface_piece& piece, const Refined_surface& s, const Opened_surface& opened,
                             Surface_curve curve)
{
  for (Curve_point& p : curve.points)
  {
    if (p.is_vertex()) { p.vertex = vertex_of_whole(piece, s, opened, p.vertex); }
    else { p.halfedge = halfedge_of_whole(piece, p.halfedge); }
  }
  return curve;
}

} // namespace meridian
