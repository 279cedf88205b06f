// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_OPEN_CUT_H
#define MERIDIAN_CUT_OPEN_CUT_H

#include <meridian/cut/Cut.h>

namespace meridian {

/// \ingroup PkgMeridianCut
/// takes the refined surface of a cut apart along its seams, and measures them.
/// \param cut the cut, whose seams are flagged
/// \par Complexity
/// Linear.
void open_cut(Cut& cut);

} // namespace meridian

#endif // MERIDIAN_CUT_OPEN_CUT_H
