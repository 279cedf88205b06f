// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FIELD_CURVED_VERTICES_H
#define MERIDIAN_FIELD_CURVED_VERTICES_H

#include <meridian/base/vectors.h>
#include <meridian/field/Sparse_solver.h>
#include <meridian/field/edge_weights.h>
#include <meridian/field/eigenfunctions.h>
#include <meridian/surface/Closed_model.h>
#include <meridian/surface/Triangle_surface.h>

#include <utility>

namespace meridian {

/*!
 * \ingroup PkgMeridianOrder
 *
 * \returns two different nodes where the surface is strongly curved: of all local minima of the eigenfunctions but the
 *          constant one, and then of all local maxima but the first node, the one with the highest absolute Gaussian
 *          curvature at its vertex. Loops have curvature 0. The lower node wins a tie.
 *
 * \param s the surface
 * \param g its closed model, or another graph on the same nodes
 * \param e eigenfunctions on the nodes, at least two
 * \pre the graph is connected and has at least two nodes
 * \par Complexity
 * Linear in edges times functions.
 */
std::pair<Index, Index> find_curved_extrema(const Triangle_surface& s, const Closed_model& g, const Eigenfunctions& e);

/*!
 * \ingroup PkgMeridianOrder
 *
 * \returns two vertices for the minimum and the maximum of a field: of the extrema of the first eigenfunctions, those
 *          of highest curvature (\cite patane2007, section 2.1)
 * \param s the surface
 * \param functions how many eigenfunctions are looked at
 * \param weights the discretization; not mean-value
 * \param make_solver makes the solver
 * \pre `s` is connected
 * \throws as `eigenfunction_field()`
 * \par Complexity
 * that of `eigenfunction_field()`
 */
std::pair<Index, Index> find_curved_vertices(const Triangle_surface& s, int functions = 4,
                                             Weights weights = Weights::POSITIVE,
                                             Make_solver make_solver = make_symmetric_solver);

} // namespace meridian

#endif // MERIDIAN_FIELD_CURVED_VERTICES_H
