// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_UNWRAP_INTERNAL_FIRST_CUT_H
#define MERIDIAN_UNWRAP_INTERNAL_FIRST_CUT_H

#include <meridian/base/vectors.h>
#include <meridian/cut/Cut.h>
#include <meridian/cut/Cut_options.h>
#include <meridian/surface/Triangle_surface.h>
#include <meridian/unwrap/Unwrapping.h>

#include <vector>

namespace meridian {
namespace internal {

// Whether `complete_cut()` does what is chosen about a cut.
bool completes_seams(const Cut_options& options);

// Throws Invalid_input_error if seams are given, or faces to keep out of, with choices that do not go with them.
void check_wishes(const Unwrap_options& options);

// The cut that an unwrapping begins with: along seams, if there are any, and around what is kept out of.
Cut first_cut(const Triangle_surface& root, const std::vector<Index>& seams, const Unwrap_options& options);

// Of each face of the root, whether seams go around it; empty if around none. Checks wishes first.
std::vector<char> kept_out_of(const Triangle_surface& root, const Unwrap_options& options);

} // namespace internal
} // namespace meridian

#endif // MERIDIAN_UNWRAP_INTERNAL_FIRST_CUT_H
