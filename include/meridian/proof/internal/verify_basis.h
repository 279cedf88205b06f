// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_PROOF_INTERNAL_VERIFY_BASIS_H
#define MERIDIAN_PROOF_INTERNAL_VERIFY_BASIS_H

#include <meridian/proof/internal/verify_counts.h>

#include <boost/multiprecision/cpp_int.hpp>

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
  template <class Corner>
  Tree_cotree(const std::vector<Id>& faces, const std::vector<Id>& local, const std::vector<Id>& twin, Id vertices,
              const Corner& corner)
    : m_local(local), m_twin(twin), m_outside(static_cast<Id>(faces.size()))
  {
    bool is_closed = true;
    std::vector<Id> sides;
    for (Id f : faces)
      for (Id s = 3 * f; s < 3 * f + 3; ++s)
      {
        is_closed = is_closed && twin[s] >= 0;
        sides.push_back(s);
      }
    Union_find tree(vertices), cotree(faces.size() + 1);
    std::vector<Id> rest;
    for (Id s : sides)
    {
      if (twin[s] > s) { continue; } // an edge counts with its higher side
      const Id a = corner(s), b = corner(next_side(s));
      if (tree.find(a) != tree.find(b))
      {
        tree.join(a, b);
        continue;
      }
      rest.push_back(s);
    }
    // of a face: the side of the neighbour, and the neighbour
    std::vector<std::vector<std::pair<Id, Id>>> dual(faces.size() + 1);
    for (Id s : rest)
    {
      const Id f = local[s / 3], g = place(twin[s]);
      if (cotree.find(f) == cotree.find(g))
      {
        m_edges.push_back(s);
        continue;
      }
      cotree.join(f, g);
      dual[g].emplace_back(s, f);
      dual[f].emplace_back(twin[s], g);
    }
    // An Euler tour of the cotree: the faces below an edge are a stretch of it.
    const Id root = is_closed ? 0 : m_outside;
    m_enter.resize(faces.size() + 1);
    m_leave.resize(faces.size() + 1);
    m_is_down.assign(3 * faces.size(), 0);
    struct Visit
    {
      Id face, parent;
      std::size_t next;
    };
    std::vector<Visit> stack{{root, -1, 0}};
    Id time = 0;
    m_enter[root] = time++;
    while (!stack.empty())
    {
      Visit& v = stack.back();
      auto& around = dual[v.face];
      if (v.next == around.size())
      {
        m_leave[v.face] = time;
        stack.pop_back();
        continue;
      }
      const auto [side, g] = around[v.next++];
      if (g == v.parent) { continue; }
      m_is_down[3 * g + side % 3] = 1;
      m_enter[g] = time++;
      stack.push_back({g, v.face, 0});
    }
  }

  Id rank() const { return static_cast<Id>(m_edges.size()); }

  // The class of a closed walk, given as sides that it runs along, each with +1 or with -1 if it runs against the side.
  Integer_row class_of(const std::vector<std::pair<Id, int>>& walk) const;

private:
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
