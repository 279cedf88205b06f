// SPDX-License-Identifier: GPL-3.0-or-later
// The library for the default solvers, compiled once in instances.cpp.
#ifndef MERIDIAN_INSTANCES_H
#define MERIDIAN_INSTANCES_H

#include <meridian/cut_to_disc.h>
#include <meridian/shortest_basis.h>

namespace meridian {

extern template Disc_cut cut_to_disc<>(const Triangle_surface&, const Cut_options&);
extern template Generators find_generators<>(const Triangle_surface&, const Generator_options&);
extern template Homology_basis find_shortest_basis<>(const Triangle_surface&, const Basis_options&);

} // namespace meridian

#endif // MERIDIAN_INSTANCES_H
