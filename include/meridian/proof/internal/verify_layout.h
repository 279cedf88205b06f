// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_PROOF_INTERNAL_VERIFY_LAYOUT_H
#define MERIDIAN_PROOF_INTERNAL_VERIFY_LAYOUT_H

#include <meridian/base/Result_mesh.h>
#include <meridian/base/vectors.h>
#include <meridian/proof/Padding.h>
#include <meridian/proof/internal/verify_counts.h>

#include <array>
#include <vector>

namespace meridian {
namespace verification {

// Counts what is wrong with borders in the plane, by exact signs. The pieces that faces are joined to are discs whose
// faces are all counterclockwise; so the layout is one-to-one if no two borders meet and no piece lies inside another.
class Layout_verifier
{
public:
  // What joins faces to pieces.
  enum class Joined
  {
    ALONG_EDGES,
    AT_VERTICES
  };
  Layout_verifier(const Result_mesh& result, const std::vector<Plane_point>& texture,
                  Joined joined = Joined::ALONG_EDGES);

  // Faces whose side on the border meets another than at a vertex that both have.
  std::vector<Id> find_meeting() const;
  // Faces, one of each piece that lies inside another; only counted right if no borders meet.
  std::vector<Id> find_inside() const;
  // Faces with a side on the border that is nearer than the padding to that of another piece in the same tile, a square
  // with corners in whole numbers.
  std::vector<Id> find_near(const Padding& padding) const;
  // Faces with a side on the border that is nearer than the padding to another of the same piece, across what is
  // outside, while the way along the border is longer than eight times the padding.
  std::vector<Id> find_near_itself(const Padding& padding) const;

private:
  struct Box;
  std::vector<Box> boxes(const Plane_point& margin) const;

  const Plane_point& at(Id side) const { return m_texture[m_result.faces[side / 3][side % 3]]; }
  Id vertex(Id side) const { return m_result.faces[side / 3][side % 3]; }
  bool meet(Id a, Id b) const;
  std::array<double, 2> tile_of(Id side) const;
  // The length of the border of its piece before each side, in texels, and of the whole; pieces are discs.
  struct Way
  {
    double before = 0, whole = 0, length = 0;
  };
  std::vector<Way> ways_along_borders(const Padding& padding) const;
  bool is_outside_of(Id side, Id other) const;
  bool are_nearer(Id a, Id b, const Padding& padding) const;

  const Result_mesh& m_result;
  const std::vector<Plane_point>& m_texture;
  std::vector<Id> m_border; // sides of faces, one an edge
  std::vector<Id> m_piece;  // of each face, its first face
};

} // namespace verification
} // namespace meridian

#endif // MERIDIAN_PROOF_INTERNAL_VERIFY_LAYOUT_H
