// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef MERIDIAN_CUT_TIGHTENING_H
#define MERIDIAN_CUT_TIGHTENING_H

#include <meridian/base/names.h>

#include <array>

namespace meridian {

/// \ingroup PkgMeridianCut
/// what is made shorter before the surface is opened.
enum class Tightening
{
  NONE,   ///< curves stay as they were found
  CURVES, ///< meridians, each within its class; links are shortest paths between them anyway
  GRAPH   ///< the whole cut graph: its vertices move, and ways through the disc take the place of longer curves
};

/// the names of `Tightening`.
template <> struct Names<Tightening>
{
  static constexpr std::array<Named_value<Tightening>, 3> table{{
    {Tightening::NONE, "no", "curves stay as they were found"},
    {Tightening::CURVES, "curves", "meridians, each within its class"},
    {Tightening::GRAPH, "graph", "the whole graph, whose vertices then move and whose paths may change places"},
  }};
};

} // namespace meridian

#endif // MERIDIAN_CUT_TIGHTENING_H
