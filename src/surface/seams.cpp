// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/surface/seams.h>

namespace meridian {

double length_of_edges(const Triangle_surface& s, const std::vector<Index>& edges)
{
  double sum = 0;
  for (Index h : edges) { sum += s.length(h); }
  return sum;
}

double seam_length(const Refined_surface& s)
{
  double sum = 0;
  for (Index h = 0; h < s.number_of_halfedges(); ++h)
  {
    if (s.seam[h] && s.edge(h) == h) { sum += s.length(h); }
  }
  return sum;
}

} // namespace meridian
