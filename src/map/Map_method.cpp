// SPDX-License-Identifier: GPL-3.0-or-later
#include <meridian/map/Map_method.h>

#include <array>
#include <cstddef>

namespace meridian {

const char* name_of(Map_method method)
{
  constexpr std::array<const char*, 9> names{"symmetric-dirichlet", "positive", "stretch", "mean-value", "tutte",
                                             "conformal",           "authalic", "lscm",    "arap"};
  return names[static_cast<std::size_t>(method)];
}

} // namespace meridian
