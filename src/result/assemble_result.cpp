// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/result/assemble_result.h>

namespace meridian {

Assembled_result assemble_result(const Polygon_soup& soup, const Examination& examination, const std::vector<Cut>& cuts)
{
  std::vector<internal::Result_part> parts;
  for (const Cut& cut : cuts) { parts.push_back({cut.surface, cut.opened}); }
  return internal::assemble_parts(soup, examination, parts);
}

} // namespace meridian
