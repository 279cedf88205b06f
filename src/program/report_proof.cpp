// SPDX-License-Identifier: GPL-3.0-or-later
#include "report_proof.h"

#include <string>

namespace meridian {
namespace program {

Json report_counts(const Component_count& c)
{
  return {{"vertices", c.vertices}, {"edges", c.edges},
          {"faces", c.faces},       {"euler_characteristic", c.euler_characteristic},
          {"genus", c.genus},       {"boundary_loops", c.boundary_loops}};
}

Json report_intersections(const Curve_count& count)
{
  if (count.is_symplectic) { return "symplectic"; }
  Json rows = Json::array();
  for (int i = 0; i < 2 * count.pairs; ++i)
  {
    Json row = Json::array();
    for (int j = 0; j < 2 * count.pairs; ++j)
    {
      const auto entry = count.intersections.find({i, j});
      row.push_back(entry == count.intersections.end() ? 0 : entry->second);
    }
    rows.push_back(row);
  }
  return rows;
}

std::string format_report(const Json& report)
{
  return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace program
} // namespace meridian
