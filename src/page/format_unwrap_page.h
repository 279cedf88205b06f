// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_PAGE_FORMAT_UNWRAP_PAGE_H
#define MERIDIAN_PAGE_FORMAT_UNWRAP_PAGE_H

#include <meridian/base/Result_mesh.h>
#include <meridian/base/vectors.h>

#include <array>
#include <string>
#include <vector>

namespace meridian {
namespace page {

// A self-contained page that shows an unwrapped mesh with a checkerboard on it, and its layout beside it; both can be
// coloured by distortion instead.
//
// `mesh` is an opened mesh whose copies follow the other vertices; `texture` has the place of each vertex in the unit
// square, `distortion` a number for each face: 1 is none.
std::string format_unwrap_page(const std::string& title, const std::string& caption, const Result_mesh& mesh,
                               const std::vector<Plane_point>& texture, const std::vector<double>& distortion);

} // namespace page
} // namespace meridian

#endif // MERIDIAN_PAGE_FORMAT_UNWRAP_PAGE_H
