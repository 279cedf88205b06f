// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_PROOF_INTERNAL_MESH_VERIFIER_H
#define MERIDIAN_PROOF_INTERNAL_MESH_VERIFIER_H

#include <meridian/base/Polygon_soup.h>
#include <meridian/base/Result_mesh.h>
#include <meridian/base/Verification.h>
#include <meridian/base/list_elements.h>
#include <meridian/proof/internal/Input_topology.h>
#include <meridian/proof/internal/verify_counts.h>

#include <algorithm>
#include <array>
#include <vector>

namespace meridian {
namespace verification {

// Recounts that a result is the input, divided and taken apart along its seams.
class Mesh_verifier
{
public:
  Mesh_verifier(const Polygon_soup& input, const Result_mesh& result) : m_input(input), m_result(result) {}

  // False if the rest cannot be counted.
  bool verify_mesh();

protected:
  template <class Element> void fail(const char* what, std::vector<Element> elements)
  {
    if (elements.empty()) { return; }
    std::sort(elements.begin(), elements.end());
    elements.erase(std::unique(elements.begin(), elements.end()), elements.end());
    m_report.failures.push_back(internal::list_elements(what, elements));
  }

  bool check_arrays();

  Id root(Id v) const { return m_result.copy_of[v] < 0 ? v : m_result.copy_of[v]; }
  Id corner(Id side) const { return m_result.faces[side / 3][side % 3]; }

  // Bit for bit; text does not keep the payload of what is not a number.
  static bool is_same(const Point& p, const Point& q);
  static bool is_inside(const std::array<double, 3>& weight);

  void check_vertices();

  // The sides of triangle t that an origin lies on, as bits; -1 if it does not lie on the triangle.
  int sides_of(const Result_origin& o, Id t) const;

  bool find_triangles();

  // Finds for every side of the result the side next to it on the input: within a triangle, or across an edge that
  // glues.
  void check_subdivision();

  struct Faults;
  struct Division;
  using Face_iterator = std::vector<Id>::const_iterator;

  // Of each side of the result the side of a triangle that it lies on, or -1.
  std::vector<Id> find_input_sides() const;

  void find_mates(const std::vector<Id>& input_side, Faults& faults);

  // The parts of each triangle: connected, Euler characteristic 1, and each side of the triangle divided from end to
  // end.
  void check_divisions(const std::vector<Id>& input_side, Faults& faults) const;

  // Lists what some faces of one triangle have on its rim and inside.
  void collect_division(Face_iterator first, Face_iterator last, const std::vector<Id>& input_side,
                        Division& division) const;

  // How far along side k of triangle t a vertex lies.
  double along(Id v, Id t, int k) const;

  // The exact sign, -1, 0 or 1, of the area of a face on a triangle that it is a part of.
  int orientation_in(Id face, Id t) const;

  // Which sides of the result share an edge.
  void pair_result();

  // Shared edges and seams are exactly the edges of the input's subdivision that are not on its boundary.
  void check_glueing();

  // Returns of each side the one that a seam joins it to, or -1.
  std::vector<Id> check_seams();

  // With the seams glued, each component counts as on the input.
  void check_glued_counts(const std::vector<Id>& seam);

  // Which corners of faces meet in one vertex of the result, by its shared edges.
  Union_find find_fans(Union_find* parts = nullptr);

  int component(Id face) const { return m_in.component[m_triangle_of[face]]; }

  const Polygon_soup& m_input;
  const Result_mesh& m_result;
  Verification m_report;
  Input_topology m_in;
  // The result.
  std::vector<Id> m_triangle_of;        // of each face
  std::vector<Id> m_mate;               // of each side: its neighbour on the input
  std::vector<Id> m_result_twin;        // of each side: its neighbour in the result
  std::vector<Id> m_crowded, m_against; // faces at edges with more than two, and turned against a neighbour
};

} // namespace verification
} // namespace meridian

#endif // MERIDIAN_PROOF_INTERNAL_MESH_VERIFIER_H
