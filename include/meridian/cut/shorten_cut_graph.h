// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_SHORTEN_CUT_GRAPH_H
#define MERIDIAN_CUT_SHORTEN_CUT_GRAPH_H

#include <meridian/base/vectors.h>
#include <meridian/curves/Normal_curves.h>
#include <meridian/curves/tighten_curves.h>
#include <meridian/surface/Surface_curve.h>
#include <meridian/surface/Triangle_surface.h>

#include <functional>
#include <vector>

namespace meridian {

namespace internal {

// Adds paths of edges to a network. Each is pushed off the vertices that it passes, to its left.
void add_paths(Normal_curves& curves, const std::vector<std::vector<Index>>& paths);

double network_length(const Normal_curves& curves);

// Moves all vertices of a network, and parts and joins them, until no pass gains much more than the least gain.
void move_vertices(Normal_curves& curves, const Tighten_options& options, const Progress& progress = {});

} // namespace internal

/*!
 * \ingroup PkgMeridianCut
 *
 * makes a cut graph shorter; what it leaves of the surface stays a disc.
 *
 * Shorter ways of edges through the disc take the place of paths whose two sides they separate (see
 * `exchange_in_edge_cut()`): this chooses the graph. Its paths become open curves in normal position, and two moves are
 * tried by turns until they gain little:
 * - a curve is pulled tight and moved over vertices of the mesh (see `tighten_curves()`);
 * - a vertex of the graph moves to a neighbour, two curves that leave it at less than 120 degrees part from the others,
 * or two vertices draw together and part the other way: the graph tends to a Steiner network of geodesics.
 *
 * These keep the class of the graph. The exchange keeps the disc: a disc cut along a way through it is two discs, and
 * glueing them along a path that lies on both makes one. No step depends on a number being exact.
 *
 * \param root the surface
 * \param paths the graph: vertices joined by edges inside the surface, as from `seam_paths()`
 * \param options see there
 * \param progress told how much is done
 *
 * \returns the curves of the graph, not longer than it was; their ends are vertices of `root`
 * \pre `root` is connected; cutting along the paths leaves one disc; no path dangles
 * \throws Invalid_input_error if the paths leave anything but a disc, or are no paths of edges
 * \par Complexity
 * That of `exchange_in_edge_cut()`, and linear in the crossings of the curves that a move changes
 */
std::vector<Surface_curve> shorten_cut_graph(const Triangle_surface& root, const std::vector<std::vector<Index>>& paths,
                                             const Tighten_options& options = Tighten_options(),
                                             const Progress& progress = {});

} // namespace meridian

#endif // MERIDIAN_CUT_SHORTEN_CUT_GRAPH_H
