// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/handles/internal/arc_longitudes.h>

#include <meridian/base/exceptions.h>
#include <meridian/curves/chords.h>

#include <string>

namespace meridian {

namespace internal {

void check_contract(const Normal_curves& curves)
{
  for (Index n : count_crossings(curves))
    if (n != 1)
    {
      throw Internal_error("find_generators: a meridian and its longitude cross " + std::to_string(n) + " times");
    }
}

} // namespace internal

} // namespace meridian
