// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_RESULT_INTERNAL_ASSEMBLE_PARTS_H
#define MERIDIAN_RESULT_INTERNAL_ASSEMBLE_PARTS_H

#include <meridian/base/Polygon_soup.h>
#include <meridian/base/Result_mesh.h>
#include <meridian/base/vectors.h>
#include <meridian/result/Assembled_result.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/examine_surface.h>
#include <meridian/surface/open_along.h>

#include <vector>

namespace meridian {

namespace internal {

// An origin on a component, in terms of the file.
Result_origin file_origin(const Origin& o, const Surface_component& c, Index points, const std::vector<Index>& added);

// A refined component, and how it was taken apart.
struct Result_part
{
  const Refined_surface& surface;
  const Opened_surface& opened;
};

Assembled_result assemble_parts(const Polygon_soup& soup, const Examination& examination,
                                const std::vector<Result_part>& cuts);

} // namespace internal

} // namespace meridian

#endif // MERIDIAN_RESULT_INTERNAL_ASSEMBLE_PARTS_H
