// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/cut/keep_out.h>

#include <meridian/base/exceptions.h>
#include <meridian/cut/edge_cuts.h>
#include <meridian/surface/measures.h>
#include <meridian/surface/open_along.h>

#include <string>
#include <utility>

namespace meridian {

namespace internal {

namespace {

// Takes the faces at a cut graph of a piece out of what is kept out.
void open_piece(const Surface_piece& piece, std::vector<char>& kept_out)
{
  const Triangle_surface& s = piece.surface;
  constexpr int bases = 4;
  std::vector<char> is_cut(s.number_of_vertices(), boundary_loops(s).empty());
  for (Index h : find_short_tree_cotree_cut(s, bases)) { is_cut[s.source(h)] = is_cut[s.target(h)] = 1; }
  for (Index h = 0; h < s.number_of_halfedges(); ++h)
  {
    if (is_cut[s.source(h)]) { kept_out[piece.faces[s.face(h)]] = 0; }
  }
}

} // namespace

} // namespace internal

std::vector<char> open_kept_out(const Triangle_surface& s, std::vector<char> kept_out)
{
  for (bool goes_on = true; std::exchange(goes_on, false);)
  {
    const Refined_surface walled = wall_off(Refined_surface(s), kept_out);
    for (const Surface_piece& piece : pieces_of(surface_of(walled, open_along(walled))))
    {
      const bool is_disc = boundary_loops(piece.surface).size() == 1 && genus(piece.surface) == 0;
      if (is_disc || !kept_out[piece.faces.front()]) { continue; }
      internal::open_piece(piece, kept_out);
      goes_on = true;
    }
  }
  return kept_out;
}

Refined_surface wall_off(Refined_surface s, const std::vector<char>& kept_out)
{
  for (Index h = 0; h < s.number_of_halfedges(); ++h)
  {
    const Index o = s.opposite[h];
    if (o >= 0 && kept_out[s.face_of[s.face(h)]] != kept_out[s.face_of[s.face(o)]]) { s.seam[h] = 1; }
  }
  return s;
}

std::vector<char> mark_faces(const Triangle_surface& s, const std::vector<Index>& faces)
{
  std::vector<char> is_marked(s.number_of_faces(), 0);
  for (Index f : faces)
  {
    if (f < 0 || f >= s.number_of_faces())
    {
      throw Invalid_input_error("seams shall keep out of faces of the surface; " + std::to_string(f) + " is none");
    }
    is_marked[f] = 1;
  }
  return is_marked;
}

std::vector<char> find_kept_out(const Refined_surface& s, const std::vector<Index>& faces)
{
  if (faces.empty()) { return {}; }
  return open_kept_out(surface_of(s, open_along(s)), mark_faces(s, faces));
}

std::vector<char> carry_kept_out(const Refined_surface& s, const std::vector<char>& kept_out)
{
  std::vector<char> carried;
  if (kept_out.empty()) { return carried; }
  carried.reserve(s.face_of.size());
  for (Index f : s.face_of) { carried.push_back(kept_out[f]); }
  return carried;
}

std::vector<char> carry_kept_out(const Surface_piece& piece, const Refined_surface& s,
                                 const std::vector<char>& kept_out)
{
  std::vector<char> carried;
  if (kept_out.empty()) { return carried; }
  for (Index f : piece.faces) { carried.push_back(kept_out[s.face_of[f]]); }
  return carried;
}

std::vector<char> vertices_inside(const Triangle_surface& s, const std::vector<char>& kept_out)
{
  std::vector<char> inside(s.number_of_vertices(), !kept_out.empty());
  for (std::size_t f = 0; f < kept_out.size(); ++f)
    for (Index v : s.triangles[f]) { inside[v] &= kept_out[f]; }
  return inside;
}

double seam_length_inside(const Refined_surface& s, const std::vector<char>& kept_out)
{
  double sum = 0;
  if (kept_out.empty()) { return sum; }
  for (Index h = 0; h < s.number_of_halfedges(); ++h)
  {
    const Index o = s.opposite[h];
    if (o > h && s.seam[h] && kept_out[s.face_of[s.face(h)]] && kept_out[s.face_of[s.face(o)]]) { sum += s.length(h); }
  }
  return sum;
}

} // namespace meridian
