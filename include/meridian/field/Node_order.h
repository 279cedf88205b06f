// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FIELD_NODE_ORDER_H
#define MERIDIAN_FIELD_NODE_ORDER_H

#include <meridian/base/vectors.h>
#include <meridian/field/Scalar_field.h>
#include <meridian/surface/Closed_model.h>

#include <vector>

namespace meridian {

/// \ingroup PkgMeridianOrder
/// a total order on the nodes of a closed model. All topology is read from it, never from values.
struct Node_order
{
  std::vector<Index> nodes; ///< from lowest to highest
  std::vector<Index> rank;  ///< the place of each node in `nodes`
  int rounds = 0;           ///< sweeps that the simplification took; 0 if the field's own order was kept
  bool numbered = false;    ///< whether the sweeps did not end and an st-numbering replaced the order
};

/// \ingroup PkgMeridianOrder
/// \param g the closed model
/// \param field a function on its nodes
/// \returns the nodes ranked by (value, index), values being compared in the scale of their region
/// \par Complexity
/// \f$ O(n \log n) \f$ (simulation of simplicity: \cite edelsbrunner1990)
Node_order order_nodes(const Closed_model& g, const Scalar_field& field);

/*!
 * \ingroup PkgMeridianOrder
 *
 * changes an order until no node is lower than all its neighbours but `minima`, and none higher but `maxima`.
 *
 * Sweeps from the allowed extrema with a priority queue, upwards and downwards in turn (\cite tierny2012). If
 * extrema are left after eight sweeps, an st-numbering ends it (\cite tarjan1986).
 *
 * \param g the closed model
 * \param order the order; unchanged if it has no other extrema
 * \param minima, maxima the allowed extrema, sorted; neither is empty and they are disjoint
 * \pre no edge joins a node to itself and the link of every node is connected, as in every closed model without
 *      chords: then the graph is biconnected, and the result is a theorem
 * \par Complexity
 * \f$ O(n \log n) \f$ a sweep, linear for the st-numbering
 */
void simplify_order(const Closed_model& g, Node_order& order, const std::vector<Index>& minima,
                    const std::vector<Index>& maxima);

} // namespace meridian

#endif // MERIDIAN_FIELD_NODE_ORDER_H
