// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_MAP_EMBED_IN_PLANE_H
#define MERIDIAN_MAP_EMBED_IN_PLANE_H

#include <meridian/field/edge_weights.h>
#include <meridian/map/map_into_polygon.h>

namespace meridian {

/// \ingroup PkgMeridianSurface
/// a planar embedding of a surface of genus 0.
struct Planar_embedding
{
  using Point_2 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
  std::vector<Point_2> points; ///< of each vertex
  bool is_valid = false;       ///< whether every face, those that fill holes too, is turned counterclockwise: exact
};

/*!
 * \ingroup PkgMeridianSurface
 *
 * embeds a connected bordered surface of genus 0 in the plane (Tutte 1963, with symmetric positive weights).
 *
 * The longest boundary loop becomes a circle; the others are filled with a fan around a new vertex, so that the whole
 * is a disc. In exact arithmetic no face can be turned over; in double precision faces at the end of long tubes
 * underflow, which the exact orientation predicate tells.
 *
 * \param s the surface
 * \returns the embedding
 * \pre `s` has genus 0 and at least one boundary loop
 * \throws Solver_error if the system cannot be factorized
 * \par Complexity
 * One factorization.
 */
inline Planar_embedding embed_in_plane(const Triangle_surface& s, Make_solver make_solver = make_symmetric_solver)
{
  const auto loops = boundary_loops(s);
  const auto length_of = [&](const std::vector<Index>& loop) {
    double sum = 0;
    for (Index h : loop) { sum += s.length(h); }
    return sum;
  };
  std::size_t outer = 0;
  for (std::size_t i = 1; i < loops.size(); ++i)
  {
    if (length_of(loops[i]) > length_of(loops[outer])) { outer = i; }
  }

  Triangle_surface filled;
  filled.points = s.points;
  filled.triangles = s.triangles;
  for (std::size_t i = 0; i < loops.size(); ++i)
  {
    if (i == outer) { continue; }
    const Index center = filled.number_of_vertices();
    Point middle{0, 0, 0};
    for (Index h : loops[i])
    {
      middle = middle + (1. / static_cast<double>(loops[i].size())) * s.points[s.source(h)];
      filled.triangles.push_back({s.target(h), s.source(h), center});
    }
    filled.points.push_back(middle);
  }
  connect(filled);

  const auto at = map_into_polygon(filled, edge_weights(filled, Weights::POSITIVE), loops[outer],
                                                    place_on_circle(places_along(s, loops[outer])), make_solver);
  Planar_embedding embedding;
  for (const auto& p : at) { embedding.points.emplace_back(p[0], p[1]); }
  embedding.is_valid = find_flipped_faces(filled.triangles, at).empty();
  embedding.points.resize(s.number_of_vertices());
  return embedding;
}

} // namespace meridian

#endif // MERIDIAN_MAP_EMBED_IN_PLANE_H
