// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/base/Polygon_soup.h>

namespace meridian {

void Polygon_soup::add_polygon(const std::int32_t* first, std::size_t n)
{
  corners.insert(corners.end(), first, first + n);
  begin.push_back(corners.size());
}

} // namespace meridian
