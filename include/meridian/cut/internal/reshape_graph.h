// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_INTERNAL_RESHAPE_GRAPH_H
#define MERIDIAN_CUT_INTERNAL_RESHAPE_GRAPH_H

#include <meridian/base/Stage_runner.h>
#include <meridian/cut/Cut.h>
#include <meridian/cut/Cut_options.h>
#include <meridian/surface/Triangle_surface.h>

namespace meridian {

namespace internal {

// Makes the whole graph shorter, or moves it onto edges.
void reshape_graph(const Triangle_surface& root, const Cut_options& options, const Stage_runner& run, Cut& cut);

} // namespace internal

} // namespace meridian

#endif // MERIDIAN_CUT_INTERNAL_RESHAPE_GRAPH_H
