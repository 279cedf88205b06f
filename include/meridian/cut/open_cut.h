// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_OPEN_CUT_H
#define MERIDIAN_CUT_OPEN_CUT_H

#include <meridian/cut/Cut.h>
#include <meridian/surface/measures.h>

namespace meridian {

/// \ingroup PkgMeridianCut
/// takes the refined surface of a cut apart along its seams, and measures them.
/// \par Complexity
/// Linear.
inline void open_cut(Cut& cut)
{
  cut.opened = open_along(cut.surface);
  cut.length = 0;
  for (const auto& seam : cut.opened.seams) { cut.length += cut.surface.length(seam[0]); }
  cut.smallest_angle_after = smallest_angle(cut.surface);
}

} // namespace meridian

#endif // MERIDIAN_CUT_OPEN_CUT_H
