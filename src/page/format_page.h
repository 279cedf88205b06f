// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_PAGE_FORMAT_PAGE_H
#define MERIDIAN_PAGE_FORMAT_PAGE_H

#include <meridian/base/vectors.h>
#include <meridian/result/Assembled_result.h>
#include <meridian/surface/Refined_surface.h>
#include <meridian/surface/Triangle_surface.h>

namespace meridian {
namespace page {

// A component of what is shown: its surface, and the field that shades it, at the vertices of `root`; maybe empty.
struct Part
{
  const Triangle_surface& root;
  const Refined_surface& surface;
  const std::vector<double>& field;
};

// A curve on a part: vertices of its surface. Curves of one kind have one colour.
struct Curve
{
  enum Kind
  {
    MERIDIAN,
    OTHER,
    FLOW
  };
  Kind kind;
  std::size_t part;
  std::vector<Index> path;
  bool is_closed;
  std::string label;         // written beside it, unless empty
  std::vector<Point> points; // in place of a path, if that is empty
};

// A self-contained page that shows the surface shaded by its field, with curves drawn over it. `others` is what curves
// are called that are no meridians.
std::string format_page(const std::string& title, const std::string& caption, const std::string& others,
                        const std::vector<Part>& parts, const std::vector<Curve>& curves,
                        const Assembled_result& assembled);

} // namespace page
} // namespace meridian

#endif // MERIDIAN_PAGE_FORMAT_PAGE_H
