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

// Moves all vertices of a network, and parts and joins them, until no pass gains more than the least gain. `pause` is
// called between moves; it may throw.
void move_vertices(Normal_curves& curves, const Tighten_options& options, const std::function<void()>& pause);

} // namespace internal

/*!
 * \ingroup PkgMeridianCut
 *
 * makes a cut graph shorter; what it leaves of the surface stays a disc.
 *
 * The paths of the graph become open curves in normal position. Three moves are tried by turns until none gains more
 * than the least gain:
 * - a curve is pulled tight and moved over vertices of the mesh (see `tighten_curves()`);
 * - a vertex of the graph moves to a neighbour, two curves that leave it at less than 120 degrees part from the others,
 * or two vertices draw together and part the other way: the graph tends to a Steiner network of geodesics;
 * - a shorter way through the disc takes the place of a curve whose two sides it separates.
 *
 * The first two keep the class of the graph. The third keeps the disc: a disc cut along a way through it is two discs,
 * and glueing them along a curve that lies on both makes one. Which curves these are is read from the walk around the
 * disc, and the walk is done again, as a count, after each exchange. No step depends on a number being exact.
 *
 * \param root the surface
 * \param paths the graph: vertices joined by edges inside the surface, as from `seam_paths()`
 * \param options see there
 * \param progress told how much is done
 *
 * \returns the curves of the graph, not longer than it was; their ends are vertices of `root`
 * \pre `root` is connected; cutting along the paths leaves one disc; no path dangles
 * \throws Internal_error if the paths leave anything but a disc
 * \par Complexity
 * \f$ O(n \log n) \f$ for each round of exchanges and the size of the graph for each of them, and linear in the
 * crossings of the curves that a move changes
 */
std::vector<Surface_curve> shorten_cut_graph(const Triangle_surface& root, const std::vector<std::vector<Index>>& paths,
                                             const Tighten_options& options = Tighten_options(),
                                             const Progress& progress = {});

} // namespace meridian

#endif // MERIDIAN_CUT_SHORTEN_CUT_GRAPH_H
