// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/cut/open_cut.h>

#include <meridian/surface/measures.h>
#include <meridian/surface/open_along.h>

namespace meridian {

void open_cut(Cut& cut)
{
  cut.opened = open_along(cut.surface);
  cut.length = 0;
  for (const auto& seam : cut.opened.seams) { cut.length += cut.surface.length(seam[0]); }
  cut.smallest_angle_after = smallest_angle(cut.surface);
}

} // namespace meridian
