// SPDX-License-Identifier: GPL-3.0-or-later
// The library for the default solvers, compiled once in instances.cpp and map_instances.cpp.
#ifndef MERIDIAN_INSTANCES_H
#define MERIDIAN_INSTANCES_H

#include <meridian/cut/cut_to_disc.h>
#include <meridian/field/eigenfunctions.h>
#include <meridian/handles/find_shortest_basis.h>
#include <meridian/unwrap/compare_parameterizations.h>
#include <meridian/unwrap/unwrap_surface.h>

namespace meridian {

extern template Cut cut_to_disc<>(const Triangle_surface&, const Cut_options&);
extern template Generators find_generators<>(const Triangle_surface&, const Generator_options&);
extern template Homology_basis find_shortest_basis<>(const Triangle_surface&, const Basis_options&);

extern template std::vector<double> eigenfunction_field<>(const Triangle_surface&, int, Weights);
extern template std::pair<Index, Index> find_curved_vertices<>(const Triangle_surface&, int, Weights);
extern template std::vector<double> geodesic_distance<>(const Triangle_surface&, const std::vector<Index>&);

extern template Parameterization parameterize_disc<>(const Triangle_surface&, const Map_options&);
extern template Unwrapping unwrap_surface<>(const Triangle_surface&, const Unwrap_options&);
extern template Map_comparison compare_parameterizations<>(const Triangle_surface&, const Cut_disc&, const Cut_disc&,
                                                           Map_weights);

} // namespace meridian

#endif // MERIDIAN_INSTANCES_H
