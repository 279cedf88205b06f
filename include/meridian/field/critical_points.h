// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FIELD_CRITICAL_POINTS_H
#define MERIDIAN_FIELD_CRITICAL_POINTS_H

#include <meridian/surface/Closed_model.h>

namespace meridian {

/// \ingroup PkgMeridianOrder
/// what an order does at a node.
enum class Critical_kind
{
  MINIMUM,
  SADDLE,
  MAXIMUM
};

/// \ingroup PkgMeridianOrder
/// a critical node of an order.
struct Critical_point
{
  Index vertex; ///< the vertex; the first one of a boundary loop
  Critical_kind kind;
  int multiplicity; ///< of a saddle: `m` where `m + 1` valleys meet; 1 for extrema
};

/*!
 * \ingroup PkgMeridianOrder
 *
 * \returns the critical nodes of an order, in the order of their vertices (Banchoff 1970)
 *
 * The walk around a regular node passes between lower and higher exactly twice. Boundary loops are nodes, and the walk
 * goes round their collar.
 *
 * \param s the surface
 * \param rank of each vertex; equal on a boundary loop, different otherwise
 * \pre no interior edge joins a boundary loop to itself
 * \post minima - saddles + maxima is the Euler characteristic of the closed model, with saddles counted by multiplicity
 * \par Complexity
 * One comparison a halfedge.
 */
inline std::vector<Critical_point> find_critical_points(const Triangle_surface& s, const std::vector<Index>& rank)
{
  std::vector<Critical_point> found;
  std::vector<char> seen(s.number_of_vertices(), 0);
  for (Index v = 0; v < s.number_of_vertices(); ++v)
  {
    if (s.is_boundary_vertex(v))
    {
      if (seen[v]) { continue; }
      for (Index u = v; !seen[u]; u = s.target(s.outgoing[u])) { seen[u] = 1; }
    }
    int changes = 0, first = -1, last = -1;
    for_each_around_node(s, v, [&](Index h) {
      const int higher = rank[s.target(h)] > rank[v];
      if (first < 0) { first = higher; }
      else if (higher != last) { ++changes; }
      last = higher;
    });
    if (first != last) { ++changes; }
    if (changes == 2) { continue; }
    if (changes == 0) { found.push_back({v, first == 1 ? Critical_kind::MINIMUM : Critical_kind::MAXIMUM, 1}); }
    else { found.push_back({v, Critical_kind::SADDLE, changes / 2 - 1}); }
  }
  return found;
}

/// \ingroup PkgMeridianOrder
/// how many critical points there are; saddles by multiplicity.
struct Critical_counts
{
  int minima = 0, maxima = 0, saddles = 0;
};

/// \ingroup PkgMeridianOrder
inline Critical_counts count(const std::vector<Critical_point>& points)
{
  Critical_counts c;
  for (const auto& p : points) switch (p.kind)
    {
    case Critical_kind::MINIMUM: ++c.minima; break;
    case Critical_kind::MAXIMUM: ++c.maxima; break;
    case Critical_kind::SADDLE: c.saddles += p.multiplicity; break;
    }
  return c;
}

} // namespace meridian

#endif // MERIDIAN_FIELD_CRITICAL_POINTS_H
