// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/handles/Generators.h>

namespace meridian {

double total_length(const Generators& generators)
{
  double sum = 0;
  for (const Generator_pair& pair : generators.pairs) { sum += pair.meridian.length + pair.longitude.length; }
  return sum;
}

} // namespace meridian
