// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_PLANAR_LINKS_H
#define MERIDIAN_CUT_PLANAR_LINKS_H

#include <meridian/base/vectors.h>
#include <meridian/field/Sparse_solver.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/Triangle_surface.h>

#include <string>
#include <vector>

namespace meridian {

/*!
 * \ingroup PkgMeridianLinks
 *
 * joins all boundaries of a slit genus-0 surface by preimages of segments in a planar embedding
 * (\cite patane2007families).
 *
 * The boundaries' images are the constraints of a constrained Delaunay triangulation (CGAL). Its edges between
 * different boundaries neither cross a boundary nor each other; the links are the minimum spanning tree of these. Each
 * segment is followed through the faces with exact orientation predicates, and where several cross one edge their order
 * on it is found in rational numbers.
 *
 * \param root the surface that `s` refines
 * \param s the surface, whose seams are disjoint closed curves. The links are inserted and flagged.
 * \param source a root vertex that the links shall pass through, or -1
 * \param links receives the links as vertices of `s`
 * \param make_solver makes the solver of the systems
 *
 * \returns an empty text, or why the plane cannot be used; `s` is then unchanged
 * \pre cutting `s` along its seams leaves a connected surface of genus 0
 * \throws Solver_error if the system cannot be factorized
 * \par Complexity
 * One factorization, and \f$ O(k \log k) \f$ for `k` boundary vertices and crossings.
 */
std::string link_boundaries_in_plane(const Triangle_surface& root, Refined_surface& s, Index source,
                                     std::vector<std::vector<Index>>& links,
                                     Make_solver make_solver = make_symmetric_solver);

} // namespace meridian

#endif // MERIDIAN_CUT_PLANAR_LINKS_H
