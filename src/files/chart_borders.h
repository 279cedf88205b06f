// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_FILES_CHART_BORDERS_H
#define MERIDIAN_FILES_CHART_BORDERS_H

#include <meridian/base/Result_mesh.h>
#include <meridian/unwrap/square_border.h>

#include <vector>

namespace meridian {
namespace files {

// A path along the border of a chart: sides `3*f + k` in order, the chart on their left.
struct Border_path
{
  std::vector<std::int32_t> sides;
  // the other side of a seam in its own order, which is backwards; empty on the border of the surface
  std::vector<std::int32_t> mates;
};

// The borders of all charts of an opened mesh as the longest paths that are either border of the surface or a seam with
// one stretch of border on each side. A path ends where other than two sectors of the surface meet, or seam and border
// do. Each seam path comes once, with both sides; paths are sorted by their first side, but circles come last.
//
// The faces must have the same turn throughout and every vertex one fan. Throws Internal_error if an edge has two faces
// on one side, or a seam is no border. Linear.
std::vector<Border_path> find_chart_borders(const Result_mesh& mesh);

} // namespace files
} // namespace meridian

#endif // MERIDIAN_FILES_CHART_BORDERS_H
