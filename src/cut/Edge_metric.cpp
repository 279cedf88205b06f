// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/cut/Edge_metric.h>

#include <meridian/base/exceptions.h>

#include <cmath>
#include <sstream>

namespace meridian {

std::vector<double> measure_edges(const Triangle_surface& s, const Edge_metric& metric)
{
  std::vector<double> lengths(s.number_of_halfedges());
  for (Index h = 0; h < s.number_of_halfedges(); ++h)
  {
    if (s.edge(h) != h) { continue; }
    const double length = metric ? metric(s, h) : s.length(h);
    if (!(length >= 0) || !std::isfinite(length))
    {
      std::ostringstream message; // shows a number of any size in a few digits
      message << "the edge between vertices " << s.source(h) << " and " << s.target(h) << " has the length " << length
              << " by the metric that was given; it must be finite and not negative";
      throw Invalid_input_error(message.str());
    }
    lengths[h] = length;
    if (s.opposite[h] >= 0) { lengths[s.opposite[h]] = length; }
  }
  return lengths;
}

} // namespace meridian
