// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_EMBED_IN_PLANE_H
#define MERIDIAN_EMBED_IN_PLANE_H

#include <meridian/Node_graph.h>
#include <meridian/edge_weights.h>
#include <meridian/internal/laplace_system.h>
#include <meridian/solver_traits.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

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
 * The longest boundary loop becomes a circle; the others are filled with a fan around a new vertex, so that the whole is
 * a disc. In exact arithmetic no face can be turned over; in double precision faces at the end of long tubes underflow,
 * which the exact orientation predicate tells.
 *
 * \tparam SymmetricTraits a model of CGAL's `SparseLinearAlgebraWithFactorTraits_d`
 * \param s the surface
 * \returns the embedding
 * \pre `s` has genus 0 and at least one boundary loop
 * \throws Solver_error if the system cannot be factorized
 * \par Complexity
 * One factorization.
 */
template <class SymmetricTraits = Symmetric_solver_traits>
Planar_embedding embed_in_plane(const Triangle_surface& s)
{
  const auto loops = boundary_loops(s);
  const auto length_of = [&](const std::vector<Index>& loop) {
    double sum = 0;
    for (Index h : loop) { sum += s.length(h); }
    return sum;
  };
  std::size_t outer = 0;
  for (std::size_t i = 1; i < loops.size(); ++i) { if (length_of(loops[i]) > length_of(loops[outer])) { outer = i; } }

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

  const Index n = filled.number_of_vertices();
  std::vector<std::array<double, 2>> at(n, {0, 0});
  std::vector<char> is_outer(n, 0);
  const double whole = length_of(loops[outer]);
  const double size = static_cast<double>(loops[outer].size());
  double along = 0;
  for (Index h : loops[outer])
  {
    // Half by length, half by number: edges without length keep a place on the circle.
    const double angle = 2 * std::acos(-1.) * along;
    at[s.source(h)] = {std::cos(angle), std::sin(angle)};
    is_outer[s.source(h)] = 1;
    along += 0.5 / size + (whole > 0 ? 0.5 * s.length(h) / whole : 0.5 / size);
  }

  Node_graph g; // the vertices themselves: nothing is shrunk here
  g.number_of_nodes = n;
  g.begin.assign(n + 1, 0);
  for (Index h = 0; h < filled.number_of_halfedges(); ++h) { ++g.begin[filled.source(h) + 1]; }
  for (Index v = 0; v < n; ++v) { g.begin[v + 1] += g.begin[v]; }
  g.halfedge.resize(g.begin.back());
  g.neighbor.resize(g.begin.back());
  std::vector<Index> fill(g.begin.begin(), g.begin.end() - 1), inner;
  for (Index h = 0; h < filled.number_of_halfedges(); ++h)
  {
    const Index i = fill[filled.source(h)]++;
    g.halfedge[i] = h;
    g.neighbor[i] = filled.target(h);
  }
  for (Index v = 0; v < n; ++v) { if (!is_outer[v]) { inner.push_back(v); } }
  const auto weights = edge_weights(filled, Weights::POSITIVE);
  internal::Laplace_system<SymmetricTraits> system(g, weights);
  system.template solve<2>(inner, [&](Index v) { return at[v]; }, [&](Index v, int i, double x) { at[v][i] = x; });

  Planar_embedding embedding;
  for (const auto& p : at) { embedding.points.emplace_back(p[0], p[1]); }
  embedding.is_valid = std::all_of(filled.triangles.begin(), filled.triangles.end(), [&](const auto& t) {
    return CGAL::orientation(embedding.points[t[0]], embedding.points[t[1]], embedding.points[t[2]]) == CGAL::COUNTERCLOCKWISE;
  });
  embedding.points.resize(s.number_of_vertices());
  return embedding;
}

} // namespace meridian

#endif // MERIDIAN_EMBED_IN_PLANE_H
