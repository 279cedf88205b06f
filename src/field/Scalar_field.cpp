// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/field/Scalar_field.h>

namespace meridian {

double Scalar_field::convert(double x, Index from, Index to) const
{
  if (from == to) { return x; }
  if (from > to) // regions come after their parents
    return convert(regions[from].offset + regions[from].scale * x, regions[from].parent, to);
  return (convert(x, from, regions[to].parent) - regions[to].offset) / regions[to].scale;
}

} // namespace meridian
