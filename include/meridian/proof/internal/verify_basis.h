// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_PROOF_INTERNAL_VERIFY_BASIS_H
#define MERIDIAN_PROOF_INTERNAL_VERIFY_BASIS_H

#include <meridian/proof/internal/verify_counts.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace meridian {
namespace verification {

// A matrix of integers, by its rows' entries that are not zero.
using Integer_row = std::map<Id, boost::multiprecision::cpp_int>;

// Whether the determinant of a square matrix is 1 or -1. Elimination over the integers: within a column rows are
// reduced by the smallest entry until one is left (Euclid), which must be a unit.
bool is_unimodular(std::vector<Integer_row> rows, Id columns);

// First homology of one component by a spanning tree of its vertices and one of its faces (and of the outside, if it
// has a boundary) that crosses no edge of the first. Each edge in neither has a loop through faces that crosses it; the
// class of a closed walk counts how often it crosses these loops.
class Tree_cotree
{
public:
  // `faces`: those of the component; `local`: the place of each among them; `twin` and `corner` speak of all sides of
  // the mesh.
  Tree_cotree(const std::vector<Id>& faces, const std::vector<Id>& local, const std::vector<Id>& twin, Id vertices,
              const std::function<Id(Id)>& corner);

  Id rank() const { return static_cast<Id>(m_edges.size()); }

  // The class of a closed walk, given as sides that it runs along, each with +1 or with -1 if it runs against the side.
  Integer_row class_of(const std::vector<std::pair<Id, int>>& walk) const;

private:
  // Of a face: the sides of the neighbours that the cotree joins it to, and the neighbours.
  using Cotree = std::vector<std::vector<std::pair<Id, Id>>>;

  // Grows the cotree through edges, and keeps those that it does not need.
  Cotree grow_cotree(const std::vector<Id>& edges);

  // Makes an Euler tour of the cotree: the faces below an edge are a stretch of it.
  void tour(const Cotree& cotree, Id root);

  Id place(Id side) const { return side < 0 ? m_outside : m_local[side / 3]; }

  const std::vector<Id>& m_local;
  const std::vector<Id>& m_twin;
  Id m_outside;
  std::vector<Id> m_edges;          // in neither tree
  std::vector<char> m_is_down;      // for each side of the faces, whether the cotree comes down through it
  std::vector<Id> m_enter, m_leave; // of each face on the tour
};

} // namespace verification
} // namespace meridian

#endif // MERIDIAN_PROOF_INTERNAL_VERIFY_BASIS_H
