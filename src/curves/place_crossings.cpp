// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/curves/place_crossings.h>

namespace meridian {

namespace internal {

bool is_before(const Crossing& a, const Crossing& b)
{
  if (a.edge != b.edge) { return a.edge < b.edge; }
  return a.from_source ? std::tie(a.piece, a.place) < std::tie(b.piece, b.place)
                       : std::tie(b.piece, b.place) < std::tie(a.piece, a.place);
}

} // namespace internal

} // namespace meridian
