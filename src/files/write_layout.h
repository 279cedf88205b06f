// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FILES_WRITE_LAYOUT_H
#define MERIDIAN_FILES_WRITE_LAYOUT_H

#include <meridian/base/Result_mesh.h>
#include <meridian/base/vectors.h>

#include <array>
#include <string>
#include <vector>

namespace meridian {
namespace files {

// A picture of an unwrapped mesh, as SVG: faces coloured by distortion, borders of charts, and along both sides of
// every seam path one colour and one number. Linear.
//
// `texture` has the place of each vertex in the unit square, `distortion` a number for each face: 1 is none, more is
// red, less is blue; beyond 1/4 and 4 colours stay as they are.
std::string format_layout(const Result_mesh& mesh, const std::vector<Plane_point>& texture,
                          const std::vector<double>& distortion);

} // namespace files
} // namespace meridian

#endif // MERIDIAN_FILES_WRITE_LAYOUT_H
