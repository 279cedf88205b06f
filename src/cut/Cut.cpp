// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/cut/Cut.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace meridian {

std::vector<Named_curve> curves_of(const Cut& cut, Curve_kind kind)
{
  std::vector<Named_curve> curves;
  std::copy_if(cut.curves.begin(), cut.curves.end(), std::back_inserter(curves),
               [&](const Named_curve& c) { return c.kind == kind; });
  return curves;
}

void add_curves(Cut& cut, Curve_kind kind, std::vector<std::vector<Index>> lines)
{
  const bool is_closed = kind == Curve_kind::MERIDIAN || kind == Curve_kind::LONGITUDE;
  for (std::vector<Index>& line : lines) { cut.curves.push_back({kind, std::move(line), is_closed, -1}); }
}

} // namespace meridian
