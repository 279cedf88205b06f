// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_EDGE_METRIC_H
#define MERIDIAN_CUT_EDGE_METRIC_H

#include <meridian/base/vectors.h>
#include <meridian/surface/Triangle_surface.h>

#include <functional>
#include <vector>

namespace meridian {

/// \ingroup PkgMeridianCut
/// how long an edge counts, given one of its halfedges: for ways along edges that shall keep away from where it is
/// long. The same from both sides, finite and not negative. Empty: its length.
using Edge_metric = std::function<double(const Triangle_surface& s, Index halfedge)>;

/// \ingroup PkgMeridianCut
/// asks a metric once for each edge.
/// \param s the surface
/// \param metric the metric
/// \returns one number a halfedge, the same on both sides
/// \throws Invalid_input_error if a number is negative or not finite
std::vector<double> measure_edges(const Triangle_surface& s, const Edge_metric& metric);

} // namespace meridian

#endif // MERIDIAN_CUT_EDGE_METRIC_H
