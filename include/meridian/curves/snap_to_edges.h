// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CURVES_SNAP_TO_EDGES_H
#define MERIDIAN_CURVES_SNAP_TO_EDGES_H

#include <meridian/surface/Surface_curve.h>
#include <meridian/surface/Triangle_surface.h>

#include <vector>

namespace meridian {

/*!
 * \ingroup PkgMeridianContours
 *
 * moves disjoint closed curves onto existing edges.
 *
 * Each crossing of a curve with an edge goes to one of the edge's ends, and the curve along the edges between. All
 * choices together make the shortest such path once round the strip of faces that the curve runs through. Curves are
 * moved in the order given; a vertex that a curve passes is its own from the start. If a curve is stuck for what others
 * took, it is moved before them in a second try.
 *
 * \param root the surface
 * \param curves closed, simple and disjoint, of points on vertices and inside edges, as from `project_contours()`
 * \param refine_where_needed whether crossings stay inside their edges where curves could not be moved otherwise; as
 *   few as can be found for each curve in turn. The result is then not of edges there, and `insert_curves()` divides
 *   the faces
 *
 * \returns the curves in their order, each homotopic to the one given, closed, simple, of three edges at least,
 *          disjoint from all others; but for vertices that curves went through before, none is on the boundary
 * \throws Invalid_input_error if a curve cannot be moved onto edges and refining is not allowed; the message names the
 *   curve and the edges where it is stuck. Also if curves share a vertex or are not closed
 * \par Complexity
 * Linear in the crossings for each try, after sorting them
 */
std::vector<Surface_curve> snap_to_edges(const Triangle_surface& root, const std::vector<Surface_curve>& curves,
                                         bool refine_where_needed);

} // namespace meridian

#endif // MERIDIAN_CURVES_SNAP_TO_EDGES_H
