// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_PROOF_INTERNAL_INPUT_TOPOLOGY_H
#define MERIDIAN_PROOF_INTERNAL_INPUT_TOPOLOGY_H

#include <meridian/base/Polygon_soup.h>
#include <meridian/base/Verification.h>
#include <meridian/proof/internal/verify_counts.h>

#include <array>
#include <set>
#include <utility>
#include <vector>

namespace meridian {
namespace verification {

// The triangles of the input, how they are glued, and what that counts. An edge glues its sides if it has two; of an
// edge with more, two sides whose corners lie in the same fans at both ends, if they are the only two.
class Input_topology
{
public:
  Input_topology() = default;
  explicit Input_topology(const Polygon_soup& input);

  std::vector<std::array<Id, 3>> triangles;
  std::vector<char> is_used;                 // of each triangle: not part of a face that repeats a vertex
  std::vector<Id> first_triangle;            // of each polygon
  std::vector<Id> twin;                      // of each side of a triangle
  std::vector<Id> component;                 // of each triangle
  std::set<std::array<Id, 2>> crowded_edges; // with three or more faces
  std::vector<Id> damaged;                   // polygons that name a vertex that is not there
  std::vector<Component_count> counts;

private:
  std::pair<Id, Id> ends(Id s) const;

  void take_triangles(const Polygon_soup& input);

  // Glues the sides of edges that have two. Returns those of edges with more.
  std::vector<std::vector<Id>> glue_pairs(Id vertices, Union_find& fans);

  // Glues those sides of one edge that are the only two between their fans.
  void glue_crowded(const std::vector<Id>& sides, Union_find& fans);

  // Returns the number of components.
  int number_components();

  void count_components(int components, Union_find& fans);

  void glue(Id a, Id b, Union_find& fans);
};

} // namespace verification
} // namespace meridian

#endif // MERIDIAN_PROOF_INTERNAL_INPUT_TOPOLOGY_H
