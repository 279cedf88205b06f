// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MAP_INTERNAL_DISC_HIERARCHY_H
#define MERIDIAN_MAP_INTERNAL_DISC_HIERARCHY_H

#include <meridian/base/vectors.h>
#include <meridian/surface/Triangle_surface.h>

#include <array>
#include <cstddef>
#include <vector>

namespace meridian {
namespace internal {

// A disc with fewer and fewer of its vertices: one after another is moved into a neighbour, of the border along the
// border, and its faces go with it. Each level is a disc again; what was taken out between two levels is kept.
class Disc_hierarchy
{
public:
  // A vertex that was taken out: it lies in the polygon of its neighbours, counterclockwise. Of a border vertex they
  // begin and end on the border.
  struct Removal
  {
    Index vertex;
    Index into; // one of the neighbours
    bool is_border;
    std::size_t begin, end; // its neighbours: from there in `ring`, to before there
  };

  // Levels of a quarter of the vertices each, down to one of at most `few`, or to where no vertex can be taken out.
  Disc_hierarchy(const Triangle_surface& disc, Index few);

  std::size_t number_of_levels() const { return m_levels.size(); }
  // The faces of a level, of which 0 is the disc itself, by vertices of the disc.
  const std::vector<std::array<Index, 3>>& triangles(std::size_t level) const { return m_levels[level].triangles; }
  // Calls `f(removal)` for what is between level `level + 1` and `level`, in the order in which it is put back.
  template <class Function> void for_each_removal(std::size_t level, const Function& f) const
  {
    for (std::size_t i = m_levels[level + 1].removals; i-- > m_levels[level].removals;) { f(m_removals[i]); }
  }
  Index ring(std::size_t place) const { return m_ring[place]; }

private:
  struct Level
  {
    std::vector<std::array<Index, 3>> triangles;
    std::size_t removals; // before it
  };

  std::vector<Level> m_levels;
  std::vector<Removal> m_removals;
  std::vector<Index> m_ring;
};

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_MAP_INTERNAL_DISC_HIERARCHY_H
