// SPDX-License-Identifier: GPL-3.0-or-later
#include "instances.h"

#include <meridian/map/parameterize_disc.h>

namespace meridian {

template Parameterization parameterize_disc<>(const Triangle_surface&, const Map_options&);
template Unwrapping unwrap_surface<>(const Triangle_surface&, const Unwrap_options&);
template Map_comparison compare_parameterizations<>(const Triangle_surface&, const Cut_disc&, const Cut_disc&,
                                                    Map_weights);

} // namespace meridian
