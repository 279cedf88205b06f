// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_SURFACE_INTERNAL_SOUP_TOPOLOGY_H
#define MERIDIAN_SURFACE_INTERNAL_SOUP_TOPOLOGY_H

#include <meridian/base/Polygon_soup.h>
#include <meridian/base/list_elements.h>
#include <meridian/base/vectors.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

namespace meridian {
namespace internal {

// The triangles of a soup while they become a surface. Side 3*f+k runs from corner k of triangle f to the next.
struct Soup_topology
{
  std::vector<std::array<Index, 3>> triangles;
  std::vector<Index> index, polygon; // of each triangle in the soup
  std::vector<char> is_flipped;
  std::vector<Index> twin;                 // the side glued to each side, or -1
  std::vector<std::vector<Index>> crowded; // sides of the edges with three or more faces

  std::pair<Index, Index> ends(Index side) const;
};

void check_indices_and_points(const Polygon_soup& soup);

// Divides extreme coordinates by a power of two, exactly but for those that vanish beside the largest; returns it.
double bring_to_scale(std::vector<Point>& points);

Soup_topology gather_triangles(const Polygon_soup& soup, std::vector<std::string>& repairs);

// Glues sides that are alone with each other on their edge.
void pair_sides(Soup_topology& t, bool split, std::vector<std::string>& repairs);

// Turns faces over until neighbours agree; refuses components where that cannot be.
void orient(Soup_topology& t, std::vector<std::string>& repairs);

// Gives each fan of faces at a point a vertex of its own, and glues sides of crowded edges whose fans meet at both
// ends.
void separate_fans(Soup_topology& t, std::size_t points, std::vector<Index>& added, std::vector<std::string>& repairs);

// Faces without area stay: their weights are bounded, and topology does not look at them.
template <class Components>
void note_faces_without_area(const Components& components, std::vector<std::string>& repairs)
{
  std::vector<Index> flat;
  for (const auto& c : components)
    for (Index f = 0; f < c.surface.number_of_faces(); ++f)
    {
      const auto& corner = c.surface.triangles[f];
      const auto& p = c.surface.points;
      const double area = norm(cross(p[corner[1]] - p[corner[0]], p[corner[2]] - p[corner[0]]));
      if (!(area > 0)) { flat.push_back(c.polygon_of[f]); }
    }
  if (flat.empty()) { return; }
  std::sort(flat.begin(), flat.end());
  flat.erase(std::unique(flat.begin(), flat.end()), flat.end());
  repairs.push_back(list_elements("faces kept that have no area", flat));
}

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_SURFACE_INTERNAL_SOUP_TOPOLOGY_H
