// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_INTERNAL_CUT_METHODS_H
#define MERIDIAN_CUT_INTERNAL_CUT_METHODS_H

#include <meridian/base/Stage_runner.h>
#include <meridian/cut/Cut.h>
#include <meridian/cut/Cut_options.h>
#include <meridian/cut/link_boundaries.h>
#include <meridian/field/Ordered_surface.h>
#include <meridian/surface/Triangle_surface.h>

#include <vector>

namespace meridian {

namespace internal {

void cut_along_contours(const Triangle_surface& root, const Ordered_surface& m, const Cut_options& options,
                        const Stage_runner& run, Cut& cut);

// Cuts edges alone, of a surface that is no disc and no closed sphere already.
void cut_along_edges(const Triangle_surface& root, const Cut_options& options, const Stage_runner& run, Cut& cut);

std::vector<Link_guide> cut_along_generators(const Triangle_surface& root, const Ordered_surface& m,
                                             const Cut_options& options, const Stage_runner& run, Cut& cut);

void cut_along_flow_lines(const Triangle_surface& root, const Ordered_surface& m, const Stage_runner& run, Cut& cut);

} // namespace internal

} // namespace meridian

#endif // MERIDIAN_CUT_INTERNAL_CUT_METHODS_H
